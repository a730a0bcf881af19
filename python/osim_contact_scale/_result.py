"""A planned change of one model."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _live, _native, _plan_tables
from ._errors import OutputError, RequestError, warn
from ._findings import Findings
from ._frames import to_frame
from ._html import heading, html_table, paragraph
from ._keywords import UNNAMED, Memory, expand_home, to_fields, to_model, with_companions
from ._named_values import NamedValues, clipped
from ._text import printable
from .types import LiveModel, Source, Table

if TYPE_CHECKING:
    import pandas as pd

log = logging.getLogger("osim_contact_scale")

#: Columns of the verdicts before and after the change.
_VERDICT_FIELDS = ("verdict", "before", "after", "says")

#: The field that names the model, for verbs in which it is not `models`.
_MODEL_FIELDS = {"fit": "file"}


def plan(verb: str, source: Source, keywords: Mapping[str, Any], tables: Mapping[str, bytes] | None = None) -> Result:
    """Plans a change of one model and writes nothing. `tables` are files in memory that keywords name.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.
    """
    memory = Memory()
    memory.update(tables or {})
    model = to_model(source, memory)
    fields = to_fields(verb, with_companions(source, keywords, memory), memory)
    fields[_MODEL_FIELDS.get(verb, "models")] = model
    is_whole = not isinstance(model, str) or model in memory or os.path.isabs(model)
    planned = Result(fields, _native.plan(fields, memory, True), None if is_whole else os.getcwd())
    for remark in planned.remarks:
        log.info("%s: %s", printable(planned.path), remark)
    for finding in planned.findings:
        message = f"{printable(planned.path)}: {finding.message}"
        if finding.severity != "remark" and not finding.had_before:
            warn(message)
        else:
            log.info("%s", message)
    return planned


class Result(NamedValues):
    """A planned change of one model. The file of the model does not change before `write`.

    Attributes
    ----------
    path : str
        The name of the model's file.
    changes : pandas.DataFrame or list of dict
        Every number that changes: `property` (OpenSim's name), component `path`, `old`, `new`, `factor`, `unit`, `equation` of the paper.
    moves : pandas.DataFrame or list of dict
        Every sphere that moves, metres in its frame.
    objects : pandas.DataFrame or list of dict
        Whole objects that are added or removed.
    contacts_mass_kg : dict or None
        The mass that the contacts were made for before: its `value` and its `source`; None if it is not known.
    target_mass_kg : float or None
        The mass that the contacts are made for afterwards.
    findings : Findings
        What the user should know about this change, as `findings` of the command's JSON.
    findings_before, findings_after : Findings
        What `check` finds in the model as it is, and in the new model.
    remarks : tuple of str
        Remarks on every change of this kind.
    record : dict
        The whole plan, as in the command's JSON.
    """

    __slots__ = ("_checked", "_fields", "_folder", "_planned", "_record")

    def __init__(self, fields: dict[str, Any], planned: _native.Planned, folder: str | None = None) -> None:
        self._fields = fields
        self._planned = planned
        self._record: dict[str, Any] | None = None
        self._checked: tuple[Findings, Findings] | None = None
        # The folder that a relative path of its file begins in.
        self._folder = folder

    @property
    def record(self) -> dict[str, Any]:
        if self._record is None:
            self._record = self._planned.record()
        return self._record

    @property
    def path(self) -> str:
        path: str = self.record["model"]
        return path

    @property
    def verb(self) -> str:
        """The verb that made this plan."""
        verb: str = self._fields["verb"]
        return verb

    @property
    def contacts_mass_kg(self) -> dict[str, Any] | None:
        mass: dict[str, Any] | None = self.record["contacts_mass_kg"]
        return mass

    @property
    def target_mass_kg(self) -> float | None:
        mass: float | None = self.record["target_mass_kg"]
        return mass

    @property
    def changes(self) -> Table:
        return _plan_tables.table_of_changes(self.record)

    @property
    def moves(self) -> Table:
        return _plan_tables.table_of_moves(self.record)

    @property
    def objects(self) -> Table:
        return _plan_tables.table_of_objects(self.record)

    @property
    def remarks(self) -> tuple[str, ...]:
        return tuple(self.record["remarks"])

    @property
    def findings(self) -> Findings:
        return Findings._from_records(self.record["findings"], (), None)

    @property
    def findings_before(self) -> Findings:
        return self._check()[0]

    @property
    def findings_after(self) -> Findings:
        return self._check()[1]

    def _check(self) -> tuple[Findings, Findings]:
        if self._checked is None:
            states = self._planned.checked()
            (before, before_requests), (after, after_requests) = states[0], states[-1]
            self._checked = (
                Findings._from_records(before["findings"], before_requests, _ModelBefore(self)),
                Findings._from_records(after["findings"], after_requests, self),
            )
        return self._checked

    @property
    def text(self) -> str:
        """The changes, as the command prints them."""
        return self._planned.text()

    def diff(self, output: str | os.PathLike[str] | None = None) -> str:
        """The changes as a unified diff; `output` is how the new model is called in it."""
        return self._planned.diff(None if output is None else os.fspath(output))

    def to_bytes(self) -> bytes:
        """The new model, byte for byte as `write` writes it."""
        files = self._planned.results()
        return files[0][1] if files else self._planned.old()

    def _companions(self) -> dict[str, tuple[str, bytes]]:
        """The other files of a standalone ForceSet after the change, by the keywords that name them."""
        new, old = self.files, self._planned.read()
        names = {name: self._fields[name] for name in ("geometry", "model") if isinstance(self._fields.get(name), str)}
        return {name: (path, new[path] if path in new else old[Path(path)]) for name, path in names.items()}

    @property
    def files(self) -> dict[str, bytes]:
        """The new bytes of each file that changes, by the name of the old file. A standalone ForceSet has its geometry, too."""
        return dict(self._planned.results())

    def write(
        self,
        output: str | os.PathLike[str] | None = None,
        *,
        output_dir: str | os.PathLike[str] | None = None,
        in_place: bool = False,
        no_backup: bool = False,
        force: bool = False,
        geometry_output: str | os.PathLike[str] | None = None,
    ) -> list[Path]:
        """Writes the new model. If that fails, no part of it is written.

        Parameters
        ----------
        output : path, optional
            The new file; by default NAME.scaled.osim beside the model.
        output_dir : path, optional
            The folder for the new file, instead of `output`.
        in_place : bool
            Change the model itself, and keep the old one as NAME.osim.bak.
        no_backup : bool
            With `in_place`: keep no backup.
        force : bool
            Replace existing files.
        geometry_output : path, optional
            Where the changed ContactGeometrySet of a standalone ForceSet goes.

        Returns
        -------
        list of pathlib.Path
            The files that were written. The list is empty if nothing changes and no output is named.

        Raises
        ------
        OutputError
            A file exists already or cannot be written. Nothing was replaced.
        """
        options = {
            "output": output,
            "output_dir": output_dir,
            "in_place": in_place,
            "no_backup": no_backup,
            "force": force,
            "geometry_output": geometry_output,
        }
        is_named = output is not None or output_dir is not None or in_place
        if self.path == UNNAMED and self._folder is None and not is_named:
            message = "this model came from memory, and has no file yet: name one with output="
            raise OutputError("output", message, keywords=("output",))
        self._check_current_folder(output, output_dir)
        fields = to_fields(self.verb, {name: value for name, value in options.items() if value is not False})
        del fields["verb"]
        paths, backups, remarks = self._planned.write(fields)
        for path in backups:
            log.info("%s: the old model is kept as %s", printable(self.path), printable(str(path)))
        for remark in remarks:
            warn(f"{printable(self.path)}: {remark}")
        return list(paths)

    def _check_current_folder(self, *outputs: Any) -> None:
        """Raises an error if the model has a relative path and the current folder is another one now."""
        if self._folder is None or self._folder == os.getcwd():
            return
        if not any(output is not None and os.path.isabs(expand_home(output)) for output in outputs):
            message = f"{self.path} was named in the folder {self._folder}, which is no longer the current one"
            raise RequestError("usage", f"{message}: write to a whole path, or go back to that folder")

    def apply(self, model: LiveModel) -> None:
        """Applies the change to a live `opensim.Model`, so that it equals the new file.

        Call `initSystem()` afterwards, as after every change of a property.

        Raises
        ------
        ContactScaleError
            This is another model than the plan is for, or it was changed since. Nothing was changed then.
        """
        _live.apply_record(self.record, self._planned.masses(), self.to_bytes(), model)

    def report(self, output: str | os.PathLike[str], *, force: bool = False) -> Path:
        """Writes a web page about this change: tables, plots, and findings before and after.

        Raises
        ------
        OutputError
            The file exists already and `force` is not given.
        """
        path = Path(expand_home(output))
        _native.write_file(path, self.html().encode("utf-8"), force)
        return path

    def html(self) -> str:
        """The page that `report` writes."""
        return self._planned.page(self.verb, self._call())

    def _call(self) -> str:
        keywords = {name: value for name, value in self._fields.items() if name not in ("verb", "models", "file")}
        # Python's `set` has a keyword for each property.
        keywords |= keywords.pop("set", {})
        words = ", ".join(
            f"{name}_={value!r}" if name in ("from", "class") else f"{name}={value!r}"
            for name, value in keywords.items()
        )
        return f"ocs.{self.verb.replace('-', '_')}({', '.join(filter(None, (repr(self.path), words)))})"

    def frame(self) -> pd.DataFrame:
        """The table `changes`, always as a DataFrame. The unit of each number is in the column `unit`.

        Examples
        --------
        >>> result.frame().groupby("property")["factor"].first()
        """
        return to_frame(lambda: self.changes)

    def _summary(self) -> str:
        """How many numbers and objects change, as a text."""
        record = self.record
        counts = [(len(record["changes"]), "number", "numbers"), (len(record["objects"]), "object", "objects")]
        counted = [f"{count} {one if count == 1 else several}" for count, one, several in counts if count]
        return f"{' and '.join(counted) or 'nothing'} to change"

    def __repr__(self) -> str:
        return f"<Result of {self.verb}: {clipped(self.path, 200)}: {self._summary()}>"

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        record = self.record
        parts = [heading(f"{self.verb}: {self.path}: {self._summary()}")]
        grouped, moves = _plan_tables.grouped_changes(record), _plan_tables.move_rows(record)
        parts += _section("", _plan_tables.GROUPED, grouped, ".changes")
        parts += _section("Spheres that move", _plan_tables.MOVES[:8], moves, ".moves")
        parts += _section("Objects", _plan_tables.OBJECTS[:5], record["objects"], ".objects")
        parts += _section("Verdicts, as it is and after the change", _VERDICT_FIELDS, self._verdicts(), ".report(path)")
        findings = Findings((*self.findings, *self.findings_after))
        where = ".findings and .findings_after have all"
        parts.append(findings._html_table("Findings of the change and of the new model", where))
        parts += [paragraph(remark) for remark in self.remarks[:5]]
        parts.append(paragraph("The whole page, with figures: .report(path). To write the new model: .write()"))
        return "".join(parts)

    def _verdicts(self) -> list[dict[str, Any]]:
        """A row for each verdict: its sign before and after, and its sentence after the change."""
        states = [record["verdicts"] for record, _ in self._planned.checked()]
        if not states:
            return []
        before = {verdict["on"]: verdict for verdict in states[0]}
        return [
            {
                "verdict": verdict["on"],
                "before": before.get(verdict["on"], {}).get("sign"),
                "after": verdict["sign"],
                "says": verdict["text"],
            }
            for verdict in states[-1]
        ]

    def __reduce__(self) -> tuple[Any, ...]:
        # The pickle has all files of the plan, because the process that loads it may not have them.
        return _unpickled, (self._fields, self._planned.read(), self._folder)


def _section(title: str, columns: Sequence[str], rows: Sequence[Mapping[str, Any]], where: str) -> list[str]:
    """A table with its title; nothing if there are no rows."""
    if not rows:
        return []
    cells = ([row.get(column) for column in columns] for row in rows)
    return [*([heading(title)] if title else []), html_table(columns, cells, where)]


class _ModelBefore:
    """The model of a result before the change, for the remedies of its findings."""

    def __init__(self, result: Result) -> None:
        self._result = result
        self.path = result.path

    def to_bytes(self) -> bytes:
        return self._result._planned.old()

    def _companions(self) -> dict[str, tuple[str, bytes]]:
        return {
            name: (path, self._result._planned.read()[Path(path)])
            for name, (path, _) in self._result._companions().items()
        }


def _unpickled(fields: dict[str, Any], files: dict[Path, bytes], folder: str | None) -> Result:
    return Result(fields, _native.plan(fields, files, False), folder)
