"""Models that are looked at: inspected and checked."""

from __future__ import annotations

import logging
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, SupportsIndex, overload

from . import _live, _native
from ._errors import ContactScaleError
from ._frames import frame_of
from ._html import heading, html_table, paragraph
from ._named import Named, line
from ._progress import following
from ._request import MODELS, InMemory, Memory, at_home, fields_of, is_path, models_of, with_own_files
from ._result import COLUMNS, Findings
from ._similarity import Similarity
from ._tables import columns_of, table
from ._threads import jobs_of
from .types import Progress, Sources, Table

if TYPE_CHECKING:
    import pandas as pd

log = logging.getLogger("osim_contact_scale")

#: From the worst on.
_SEVERITIES = ("error", "warning", "remark")

#: Columns of the table of models.
_MODEL = (
    "model",
    "name",
    "document_version",
    "mass_kg",
    "gravity_m_s2",
    "contacts_mass_kg",
    "contacts_mass_source",
    "spheres_per_limb",
)


def survey(verb: str, sources: Sources, keywords: Mapping[str, Any], jobs: int | None, progress: Progress) -> Any:
    """Inspects or checks models.

    Raises
    ------
    ContactScaleError
        The call is wrong, or there is one model and it cannot be read. Of several models those that fail are in `errors`.
    """
    count = jobs_of(jobs)
    memory = Memory()
    named = listed(sources)
    models = models_of(named, memory)
    if len(named) == 1:
        keywords = with_own_files(named[0], keywords, memory)
    fields = fields_of(verb, keywords, memory)
    fields["models"] = models
    call = f"ocs.{verb}(...)"
    has_folder = any(os.path.isdir(at_home(source)) for source in named if is_path(source))
    # How many models a folder has is known at the end.
    with following(progress, verb, None if has_folder else len(models)) as callback:
        rows, remarks, text = _native.survey(fields, memory, count, call, callback)
    for remark in remarks:
        log.info("%s", remark)
    alone = len(rows) == 1 and not has_folder
    errors = [error for _, _, error in rows if error is not None]
    if alone and errors:
        raise errors[0]
    for error in errors:
        log.error("%s", error)
    good = [(record, requests) for record, requests, error in rows if error is None and record is not None]
    given = [
        *zip(models, named),
        *((fields[name], keywords[name]) for name in MODELS if keywords.get(name) is not None),
    ]
    by_name = {name: _kept(name, source, memory) for name, source in given if isinstance(name, str)}
    return (Inspection if verb == "inspect" else Check)(good, errors, by_name, os.getcwd(), text)


def listed(sources: Any) -> list[Any]:
    """The models of a call: one, or all of a list or of another iterable of them.

    Raises
    ------
    TypeError
        A table.
    """
    if hasattr(sources, "columns") or isinstance(sources, Mapping):
        kind = type(sources).__name__
        raise TypeError(f'expected models, not a {kind}: name its column of paths, as in table["model"]')
    is_one = is_path(sources) or isinstance(sources, (bytes, bytearray, memoryview)) or _live.is_model(sources)
    return [sources] if is_one or not isinstance(sources, Iterable) else list(sources)


def _kept(name: str, source: Any, memory: Mapping[str, bytes]) -> Any:
    """A model for later calls. A live model is kept as its bytes: it may change, and it cannot go to another process."""
    return InMemory(name, memory[name]) if _live.is_model(source) else source


class Survey(Named, Sequence[dict[str, Any]]):
    """Models that were looked at: a record for each, as the command's JSON has it.

    Attributes
    ----------
    records : list of dict
        One for each model that could be read.
    errors : list of ContactScaleError
        One for each that could not.
    text : str
        What the command prints: one model in full, several as one table.
    """

    __slots__ = ("_folder", "_requests", "_sources", "errors", "records", "text")

    def __init__(
        self,
        good: list[Any],
        errors: list[ContactScaleError],
        sources: dict[str, Any],
        folder: str | None = None,
        text: str = "",
    ) -> None:
        self.records: list[dict[str, Any]] = [record for record, _ in good]
        self.errors = errors
        self._requests = [requests for _, requests in good]
        self._sources = sources
        # Where names of files begin.
        self._folder = folder
        self.text = text

    @overload
    def __getitem__(self, index: SupportsIndex, /) -> dict[str, Any]: ...

    @overload
    def __getitem__(self, index: slice, /) -> list[dict[str, Any]]: ...

    @overload
    def __getitem__(self, index: str, /) -> Any: ...

    def __getitem__(self, index: Any, /) -> Any:
        return self._by_name(index) if isinstance(index, str) else self.records[index]

    def __len__(self) -> int:
        return len(self.records)

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return iter(self.records)

    def __repr__(self) -> str:
        return line(type(self).__name__, self._count())

    def __str__(self) -> str:
        return self.text

    @property
    def similarity(self) -> Similarity:
        """What else of the models follows their size; empty unless `from_` (check) or `target_mass` (inspect) was given."""
        return Similarity(self.records)

    def _count(self) -> str:
        """How many models there are, or which one."""
        failed = f", {len(self.errors)} not read" if self.errors else ""
        alone = self.records[0]["model"] if len(self.records) == 1 else f"{len(self.records)} models"
        return f"{alone}{failed}"

    def _not_read(self) -> str:
        """The models that could not be read, as a notebook shows them."""
        if not self.errors:
            return ""
        return heading("Not read") + html_table(("error",), ([str(error)] for error in self.errors), ".errors")


class Inspection(Survey):
    """What contacts models have and what they do under the weight: one row per model, sphere or force."""

    __slots__ = ()

    def frame(self) -> pd.DataFrame:
        """The models as a DataFrame, always: as `models` has them, units in `attrs["units"]`.

        Examples
        --------
        >>> ocs.inspect("models/").frame()[["model", "mass_kg"]]
        """
        return frame_of(lambda: self.models)

    @property
    def models(self) -> Table:
        """A row for each model: masses, gravity, limbs, how many spheres and forces."""
        rows = []
        for record in self.records:
            contacts = record["contacts_mass_kg"] or {}
            own = {**record, "contacts_mass_kg": contacts.get("value"), "contacts_mass_source": contacts.get("source")}
            counts = {"sphere_count": len(record["spheres"]), "force_count": len(record["forces"])}
            rows.append({name: own.get(name) for name in _MODEL} | counts | _scalars(record["figures"], _MODEL))
        return table(rows, columns_of(_MODEL, rows))

    @property
    def spheres(self) -> Table:
        """A row for each sphere: radius, place, limb, and what it does under the weight, each figure by its name."""
        first = (
            "model",
            "name",
            "path",
            "radius_m",
            "location_x_m",
            "location_y_m",
            "location_z_m",
            "frame",
            "body",
            "limb",
            "line",
        )
        rows = []
        for record in self.records:
            figures = {
                sphere["path"]: {"side": limb["side"], **_scalars(sphere, ("sphere", "path", "radius_m"))}
                for limb in record["figures"]["limbs"] or ()
                for sphere in limb["spheres"]
            }
            for sphere in record["spheres"]:
                place = sphere["location_m"] or (None, None, None)
                axes = {f"location_{axis}_m": value for axis, value in zip("xyz", place)}
                rows.append({"model": record["model"], **_scalars(sphere), **axes, **figures.get(sphere["path"], {})})
        return table(rows, columns_of(first, rows))

    @property
    def forces(self) -> Table:
        """A row for each force, or each ContactParameters of one: its parameters by OpenSim's names, and without dimensions."""
        first = ("model", "name", "path", "type", "set", "spheres", "applies", "selected")
        rows = []
        for record in self.records:
            for force in record["forces"]:
                free = {f"dimensionless_{name}": value for name, value in (force["dimensionless"] or {}).items()}
                spheres = {"spheres": " ".join(force["spheres"])}
                rows.append({"model": record["model"], **_scalars(force), **spheres, **force["parameters"], **free})
        return table(rows, columns_of(first, rows))

    def _repr_html_(self) -> str:
        columns = ("model", "mass_kg", "contacts_mass_kg", "spheres_per_limb", "spheres", "forces")
        parts = [heading(f"inspect: {self._count()}"), html_table(columns, map(_seen, self.records), ".models has all")]
        if len(self.records) == 1:
            own = ("name", "radius_m", "body", "limb")
            spheres = ([sphere.get(name) for name in own] for sphere in self.records[0]["spheres"])
            parts.append(html_table(own, spheres, ".spheres has all"))
        return "".join([*parts, self._not_read()])


def _seen(record: Mapping[str, Any]) -> list[Any]:
    """What a notebook shows of a model."""
    contacts = (record["contacts_mass_kg"] or {}).get("value")
    counts = (len(record["spheres"]), len(record["forces"]))
    return [record["model"], record["mass_kg"], contacts, record["spheres_per_limb"], *counts]


class Check(Survey):
    """What the limits of the paper and the traps of the format say about models."""

    __slots__ = ()

    def frame(self) -> pd.DataFrame:
        """The findings of all models as a DataFrame, always: as `table` has them.

        Examples
        --------
        >>> ocs.check("models/").frame().groupby("code")["model"].nunique()
        """
        return frame_of(lambda: self.table)

    @property
    def findings(self) -> Findings:
        """All findings, model by model, from the worst to the least."""
        return Findings(finding for index in range(len(self.records)) for finding in self.of(index))

    def of(self, index: int) -> Findings:
        """The findings of one model, by its number from 0."""
        record = self.records[index]
        source = self._sources.get(record["model"])
        return Findings._of(record["findings"], self._requests[index], source, self._sources, self._folder)

    @property
    def models(self) -> Table:
        """A row for each model: how many findings of each severity."""
        rows = [{"model": record["model"], **record["counts"]} for record in self.records]
        return table(rows, ("model", *_SEVERITIES))

    @property
    def table(self) -> Table:
        """A row for each finding."""
        rows = []
        for record in self.records:
            for finding in record["findings"]:
                rows.append({"model": record["model"], **finding, "spheres": " ".join(finding["spheres"])})
        return table(rows, ("model", *COLUMNS))

    def _repr_html_(self) -> str:
        parts = [heading(f"check: {self._count()}")]
        if len(self.records) == 1:
            names = ("on", "sign", "text", "place")
            verdicts = ([verdict.get(name) for name in names] for verdict in self.records[0]["verdicts"])
            parts.append(html_table(("verdict", "", "says", "place"), verdicts, ".records"))
        elif self.records:
            counts = ([record["model"], *record["counts"].values()] for record in self._worst())
            parts.append(html_table(("model", "errors", "warnings", "remarks"), counts, ".models has all"))
        parts.append(self._found() if any(record["findings"] for record in self.records) else paragraph("no findings"))
        return "".join([*parts, self._not_read()])

    def _count(self) -> str:
        totals = {name: sum(record["counts"][name] for record in self.records) for name in _SEVERITIES}
        said = (f"{count} {name}{'s' if count > 1 else ''}" for name, count in totals.items() if count)
        return f"{super()._count()}: {', '.join(said) or 'no findings'}"

    def _worst(self) -> list[dict[str, Any]]:
        """The models, those with most errors first: there may be no room for the others."""
        return sorted(self.records, key=lambda record: [-count for count in record["counts"].values()])

    def _found(self) -> str:
        """The findings as a notebook shows them: of one model each, of several those of one kind as one row."""
        if len(self.records) == 1:
            return self.of(0)._table_of("")
        kinds: dict[tuple[str, str], list[str]] = {}
        for record in self.records:
            for finding in record["findings"]:
                models = kinds.setdefault((finding["severity"], finding["code"]), [])
                models += [record["model"]] if record["model"] not in models[-1:] else []
        ranked = sorted(kinds.items(), key=lambda kind: (_SEVERITIES.index(kind[0][0]), -len(kind[1])))
        rows = ([*kind, len(models), models[0]] for kind, models in ranked)
        columns = ("severity", "finding", "models", "for example")
        return html_table(columns, rows, ".findings.table") + paragraph("Each finding: .findings.table, or .of(number)")


def _scalars(record: Mapping[str, Any], without: Sequence[str] = ()) -> dict[str, Any]:
    """What fits into a cell."""
    plain = {name: value for name, value in record.items() if not isinstance(value, (list, dict, tuple))}
    return {name: value for name, value in plain.items() if name not in without}
