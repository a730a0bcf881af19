"""Inspects and checks models."""

from __future__ import annotations

import logging
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, SupportsIndex, overload

from . import _live, _native
from ._errors import ContactScaleError
from ._findings import COLUMNS, Findings
from ._frames import to_frame
from ._html import heading, html_table, paragraph
from ._keywords import (
    MODELS,
    InMemory,
    Memory,
    expand_home,
    is_file_object,
    is_path,
    to_fields,
    to_models,
    with_companions,
)
from ._named_values import NamedValues, repr_line
from ._progress import progress_callback
from ._similarity import Similarity
from ._tables import all_columns, table
from ._threads import thread_count
from .types import Progress, Sources, Table

if TYPE_CHECKING:
    import pandas as pd

log = logging.getLogger("osim_contact_scale")

#: Severities of findings, from the worst on.
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
        The call is wrong, or there is one model and it cannot be read. If there are several, `errors` has those that cannot be read.
    """
    count = thread_count(jobs)
    memory = Memory()
    source_list = as_list(sources)
    models = to_models(source_list, memory)
    if len(source_list) == 1:
        keywords = with_companions(source_list[0], keywords, memory)
    fields = to_fields(verb, keywords, memory)
    fields["models"] = models
    call = f"ocs.{verb}(...)"
    has_folder = any(os.path.isdir(expand_home(source)) for source in source_list if is_path(source))
    # The number of models in a folder is not known before the end.
    with progress_callback(progress, verb, None if has_folder else len(models)) as callback:
        rows, remarks, text = _native.survey(fields, memory, count, call, callback)
    for remark in remarks:
        log.info("%s", remark)
    is_single = len(rows) == 1 and not has_folder
    errors = [error for _, _, error in rows if error is not None]
    if is_single and errors:
        raise errors[0]
    for error in errors:
        log.error("%s", error)
    surveyed = [(record, requests) for record, requests, error in rows if error is None and record is not None]
    named_sources = [
        *zip(models, source_list),
        *((fields[name], keywords[name]) for name in MODELS if keywords.get(name) is not None),
    ]
    sources_by_name = {
        name: _for_later_calls(name, source, memory) for name, source in named_sources if isinstance(name, str)
    }
    return (Inspection if verb == "inspect" else Check)(surveyed, errors, sources_by_name, os.getcwd(), text)


def as_list(sources: Any) -> list[Any]:
    """The models of a call as a list: one model, or all of an iterable.

    Raises
    ------
    TypeError
        It is a table.
    """
    if hasattr(sources, "columns") or isinstance(sources, Mapping):
        kind = type(sources).__name__
        raise TypeError(f'expected models, not a {kind}: name its column of paths, as in table["model"]')
    is_bytes = isinstance(sources, (bytes, bytearray, memoryview)) or is_file_object(sources)
    is_one = is_path(sources) or is_bytes or _live.is_model(sources)
    return [sources] if is_one or not isinstance(sources, Iterable) else list(sources)


def _for_later_calls(name: str, source: Any, memory: Mapping[str, bytes]) -> Any:
    """A model for later calls. A live model is kept as bytes, because it may change and cannot be pickled."""
    return InMemory(name, memory[name]) if _live.is_model(source) else source


class Survey(NamedValues, Sequence[dict[str, Any]]):
    """Models that were inspected or checked: a record for each, as in the command's JSON.

    Attributes
    ----------
    records : list of dict
        One for each model that could be read.
    errors : list of ContactScaleError
        One for each model that could not be read.
    text : str
        What the command prints: one model in full, several as one table.
    """

    __slots__ = ("_folder", "_requests", "_sources", "errors", "records", "text")

    def __init__(
        self,
        surveyed: list[Any],
        errors: list[ContactScaleError],
        sources: dict[str, Any],
        folder: str | None = None,
        text: str = "",
    ) -> None:
        self.records: list[dict[str, Any]] = [record for record, _ in surveyed]
        self.errors = errors
        self._requests = [requests for _, requests in surveyed]
        self._sources = sources
        # The current folder at the call, which relative paths begin in.
        self._folder = folder
        self.text = text

    @overload
    def __getitem__(self, index: SupportsIndex, /) -> dict[str, Any]: ...

    @overload
    def __getitem__(self, index: slice, /) -> list[dict[str, Any]]: ...

    @overload
    def __getitem__(self, index: str, /) -> Any: ...

    def __getitem__(self, index: Any, /) -> Any:
        return self._get_by_name(index) if isinstance(index, str) else self.records[index]

    def __len__(self) -> int:
        return len(self.records)

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return iter(self.records)

    def __repr__(self) -> str:
        return repr_line(type(self).__name__, self._summary())

    def __str__(self) -> str:
        return self.text

    @property
    def similarity(self) -> Similarity:
        """Other numbers of the models that depend on size; empty unless `from_` (check) or `target_mass` (inspect) was given."""
        return Similarity(self.records)

    def _summary(self) -> str:
        """The number of models, or the name of the only one, and how many could not be read."""
        failed = f", {len(self.errors)} not read" if self.errors else ""
        name = self.records[0]["model"] if len(self.records) == 1 else f"{len(self.records)} models"
        return f"{name}{failed}"

    def _errors_html(self) -> str:
        """The models that could not be read, as HTML."""
        if not self.errors:
            return ""
        return heading("Not read") + html_table(("error",), ([str(error)] for error in self.errors), ".errors")


class Inspection(Survey):
    """The contacts of models, and how they deform under body weight: one row per model, sphere or force."""

    __slots__ = ()

    def frame(self) -> pd.DataFrame:
        """The table `models`, always as a DataFrame; units are in `attrs["units"]`.

        Examples
        --------
        >>> ocs.inspect("models/").frame()[["model", "mass_kg"]]
        """
        return to_frame(lambda: self.models)

    @property
    def models(self) -> Table:
        """A row for each model: masses, gravity, limbs, how many spheres and forces."""
        rows = []
        for record in self.records:
            contacts = record["contacts_mass_kg"] or {}
            values = {
                **record,
                "contacts_mass_kg": contacts.get("value"),
                "contacts_mass_source": contacts.get("source"),
            }
            counts = {"sphere_count": len(record["spheres"]), "force_count": len(record["forces"])}
            rows.append({name: values.get(name) for name in _MODEL} | counts | _scalars(record["figures"], _MODEL))
        return table(rows, all_columns(_MODEL, rows))

    @property
    def spheres(self) -> Table:
        """A row for each sphere: radius, place, limb, and its figures under body weight, each by its name."""
        leading = (
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
        return table(rows, all_columns(leading, rows))

    @property
    def forces(self) -> Table:
        """A row for each force, or each ContactParameters of one: its parameters with OpenSim's names, also in dimensionless form."""
        leading = ("model", "name", "path", "type", "set", "spheres", "applies", "selected")
        rows = []
        for record in self.records:
            for force in record["forces"]:
                dimensionless = {
                    f"dimensionless_{name}": value for name, value in (force["dimensionless"] or {}).items()
                }
                spheres = {"spheres": " ".join(force["spheres"])}
                rows.append(
                    {"model": record["model"], **_scalars(force), **spheres, **force["parameters"], **dimensionless}
                )
        return table(rows, all_columns(leading, rows))

    def _repr_html_(self) -> str:
        columns = ("model", "mass_kg", "contacts_mass_kg", "spheres_per_limb", "spheres", "forces")
        parts = [
            heading(f"inspect: {self._summary()}"),
            html_table(columns, map(_notebook_row, self.records), ".models has all"),
        ]
        if len(self.records) == 1:
            sphere_columns = ("name", "radius_m", "body", "limb")
            spheres = ([sphere.get(name) for name in sphere_columns] for sphere in self.records[0]["spheres"])
            parts.append(html_table(sphere_columns, spheres, ".spheres has all"))
        return "".join([*parts, self._errors_html()])

    def _summary(self) -> str:
        spheres = sum(len(record["spheres"]) for record in self.records)
        masses = [record["mass_kg"] for record in self.records if record["mass_kg"] is not None]
        mass = f", {masses[0]:g} kg" if len(self.records) == len(masses) == 1 else ""
        return f"{super()._summary()}: {spheres} spheres{mass}"


def _notebook_row(record: Mapping[str, Any]) -> list[Any]:
    """The cells of a model in a notebook's table."""
    contacts = (record["contacts_mass_kg"] or {}).get("value")
    counts = (len(record["spheres"]), len(record["forces"]))
    return [record["model"], record["mass_kg"], contacts, record["spheres_per_limb"], *counts]


class Check(Survey):
    """Models checked for the limits of the paper and the pitfalls of the file format."""

    __slots__ = ()

    def frame(self) -> pd.DataFrame:
        """The findings of all models: `table`, always as a DataFrame.

        Examples
        --------
        >>> ocs.check("models/").frame().groupby("code")["model"].nunique()
        """
        return to_frame(lambda: self.table)

    @property
    def findings(self) -> Findings:
        """All findings, model by model, from the worst to the least."""
        return Findings(finding for index in range(len(self.records)) for finding in self.findings_of(index))

    def findings_of(self, index: int) -> Findings:
        """The findings of one model, by its number from 0."""
        record = self.records[index]
        source = self._sources.get(record["model"])
        return Findings._from_records(record["findings"], self._requests[index], source, self._sources, self._folder)

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
        parts = [heading(f"check: {self._summary()}")]
        if len(self.records) == 1:
            names = ("on", "sign", "text", "place")
            verdicts = ([verdict.get(name) for name in names] for verdict in self.records[0]["verdicts"])
            parts.append(html_table(("verdict", "", "says", "place"), verdicts, ".records"))
        elif self.records:
            counts = ([record["model"], *record["counts"].values()] for record in self._worst_first())
            parts.append(html_table(("model", "errors", "warnings", "remarks"), counts, ".models has all"))
        parts.append(
            self._findings_html() if any(record["findings"] for record in self.records) else paragraph("no findings")
        )
        return "".join([*parts, self._errors_html()])

    def _summary(self) -> str:
        totals = {name: sum(record["counts"][name] for record in self.records) for name in _SEVERITIES}
        counted = (f"{count} {name}{'s' if count > 1 else ''}" for name, count in totals.items() if count)
        return f"{super()._summary()}: {', '.join(counted) or 'no findings'}"

    def _worst_first(self) -> list[dict[str, Any]]:
        """The models, those with most errors first, because a notebook shows only the first ones."""
        return sorted(self.records, key=lambda record: [-count for count in record["counts"].values()])

    def _findings_html(self) -> str:
        """The findings as HTML: a row for each finding of one model; for several models, a row for each code."""
        if len(self.records) == 1:
            return self.findings_of(0)._html_table("")
        kinds: dict[tuple[str, str], list[str]] = {}
        for record in self.records:
            for finding in record["findings"]:
                models = kinds.setdefault((finding["severity"], finding["code"]), [])
                models += [record["model"]] if record["model"] not in models[-1:] else []
        ranked = sorted(kinds.items(), key=lambda kind: (_SEVERITIES.index(kind[0][0]), -len(kind[1])))
        rows = ([*kind, len(models), models[0]] for kind, models in ranked)
        columns = ("severity", "finding", "models", "for example")
        return html_table(columns, rows, ".findings.table") + paragraph(
            "Each finding: .findings.table, or .findings_of(number)"
        )


def _scalars(record: Mapping[str, Any], without: Sequence[str] = ()) -> dict[str, Any]:
    """The fields whose values fit into a cell of a table."""
    plain = {name: value for name, value in record.items() if not isinstance(value, (list, dict, tuple))}
    return {name: value for name, value in plain.items() if name not in without}
