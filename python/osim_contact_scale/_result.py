"""A planned change of one model, and everything that can be done with it."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import _live, _native
from ._errors import RequestError
from ._finding import Findings
from ._html import framed
from ._request import Memory, Source, at_home, fields_of, model_of, with_own_files
from ._tables import table
from ._text import printable

log = logging.getLogger("osim_contact_scale")

#: Columns of a table of changes. `old` and `new` are in `unit`.
CHANGES = ("property", "path", "old", "new", "factor", "unit", "equation", "force", "sphere", "set", "line", "inserted")
#: Columns of a table of spheres that move: metres, in their frames.
MOVES = ("path", "sphere", "old_x", "old_y", "old_z", "new_x", "new_y", "new_z", "equation", "line", "inserted")
#: Columns of a table of whole objects.
OBJECTS = ("change", "class", "name", "path", "body", "location_m", "radius_m", "parameters")


def plan(verb: str, source: Source, keywords: Mapping[str, Any]) -> Result:
    """Plans a change of one model. Nothing is written.

    Raises
    ------
    ContactScaleError
        It cannot be done: the subclass says why.
    """
    memory = Memory()
    model = model_of(source, memory)
    fields = fields_of(verb, with_own_files(source, keywords, memory), memory)
    fields["models"] = model
    is_whole = not isinstance(model, str) or model in memory or os.path.isabs(model)
    planned = Result(fields, _native.plan(fields, memory, True), None if is_whole else os.getcwd())
    for note in planned.notes:
        log.info("%s: %s", printable(planned.path), note)
    for warning in planned.warnings:
        log.warning("%s: %s", printable(planned.path), warning.message)
    return planned


class Result:
    """A planned change of one model. The model itself is as it was until `write`.

    Attributes
    ----------
    path : str
        The model as it was named.
    changes : pandas.DataFrame or list of dict
        Every number that changes: `property` (OpenSim's name), component `path`, `old`, `new`, `factor`, `unit`, `equation` of the paper.
    moves : pandas.DataFrame or list of dict
        Every sphere that moves, metres in its frame.
    objects : pandas.DataFrame or list of dict
        Whole objects that are added or removed.
    contacts_mass_kg : dict or None
        The mass that the contacts were made for before: its `value` and its `source`; None where nobody knows.
    target_mass_kg : float or None
        The mass that the contacts are made for afterwards.
    warnings : Findings
        What is to be said of this change.
    notes : tuple of str
        What else is good to know.
    findings : Findings
        The warnings, and what `check` finds in the new model.
    record : dict
        All of it, as the command's JSON has it.
    """

    __slots__ = ("_checked", "_fields", "_folder", "_planned", "_record")

    def __init__(self, fields: dict[str, Any], planned: _native.Planned, folder: str | None = None) -> None:
        self._fields = fields
        self._planned = planned
        self._record: dict[str, Any] | None = None
        self._checked: tuple[Findings, Findings] | None = None
        # Where the name of its file begins, if that is not a whole path.
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
        """What was asked for."""
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
    def changes(self) -> Any:
        units = _native.units()
        numbers = [change for change in self.record["changes"] if change["property"] != "location"]
        rows = [
            {**change, "old": change["from"], "new": change["to"], "unit": units[change["property"]]}
            for change in numbers
        ]
        return table(rows, CHANGES)

    @property
    def moves(self) -> Any:
        moved = [change for change in self.record["changes"] if change["property"] == "location"]
        axes = ("x", "y", "z")
        rows = [
            {
                **move,
                **{f"old_{axis}": value for axis, value in zip(axes, move["from"])},
                **{f"new_{axis}": value for axis, value in zip(axes, move["to"])},
            }
            for move in moved
        ]
        return table(rows, MOVES)

    @property
    def objects(self) -> Any:
        return table(self.record["objects"], OBJECTS)

    @property
    def notes(self) -> tuple[str, ...]:
        return tuple(self.record["notes"])

    @property
    def warnings(self) -> Findings:
        return Findings._of(self.record["warnings"], (), None)

    @property
    def findings(self) -> Findings:
        return Findings((*self.warnings, *self._check()[1]))

    @property
    def findings_before(self) -> Findings:
        """What `check` finds in the model as it is."""
        return self._check()[0]

    def _check(self) -> tuple[Findings, Findings]:
        if self._checked is None:
            states = self._planned.checked()
            (before, requests), (after, later) = states[0], states[-1]
            self._checked = (
                Findings._of(before["findings"], requests, _Before(self)),
                Findings._of(after["findings"], later, self),
            )
        return self._checked

    @property
    def text(self) -> str:
        """What changes, as the command prints it."""
        return self._planned.text()

    def diff(self, output: str | os.PathLike[str] | None = None) -> str:
        """The changes as a unified diff; `output` is how the new model is called in it."""
        return self._planned.diff(None if output is None else os.fspath(output))

    def to_bytes(self) -> bytes:
        """The new model, byte for byte as `write` writes it."""
        files = self._planned.results()
        return files[0][1] if files else self._planned.old()

    def _companions(self) -> dict[str, tuple[str, bytes]]:
        """The other files of a ForceSet by itself, by the keywords that name them: as they are after the change."""
        new, old = self.files, self._planned.read()
        named = {name: self._fields[name] for name in ("geometry", "model") if isinstance(self._fields.get(name), str)}
        return {name: (path, new[path] if path in new else old[Path(path)]) for name, path in named.items()}

    @property
    def files(self) -> dict[str, bytes]:
        """The new bytes of each file that changes, by the name of the old one: of a standalone set, its geometry too."""
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
        """Writes the new model: whole, or not at all.

        Parameters
        ----------
        output : path, optional
            The new file; by default NAME.scaled.osim beside the model.
        output_dir : path, optional
            A folder for it instead.
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
            The files that were written; none where nothing changes and no output is named.

        Raises
        ------
        OutputError
            Something is there, or cannot be written. Nothing was replaced.
        """
        asked = {
            "output": output,
            "output_dir": output_dir,
            "in_place": in_place,
            "no_backup": no_backup,
            "force": force,
            "geometry_output": geometry_output,
        }
        self._stay_in_folder(output, output_dir)
        fields = fields_of(self.verb, {name: value for name, value in asked.items() if value is not False})
        del fields["verb"]
        paths, kept, remarks = self._planned.write(fields)
        for path in kept:
            log.info("%s: the old model is kept as %s", printable(self.path), printable(str(path)))
        for remark in remarks:
            log.warning("%s: %s", printable(self.path), remark)
        return list(paths)

    def _stay_in_folder(self, *outputs: Any) -> None:
        """Refuses to write beside a model that was named in another folder."""
        if self._folder is None or self._folder == os.getcwd():
            return
        if not any(output is not None and os.path.isabs(at_home(output)) for output in outputs):
            message = f"{self.path} was named in the folder {self._folder}, which is no longer the current one"
            raise RequestError("usage", f"{message}: write to a whole path, or go back to that folder")

    def apply(self, model: Any) -> None:
        """Applies the change to a live `opensim.Model`, so that it equals the new file.

        Call `initSystem()` afterwards, as after every change of a property.

        Raises
        ------
        ContactScaleError
            It is another model, or was changed since. Nothing was changed then.
        """
        _live.apply(self.record, self._planned.masses(), self.to_bytes(), model)

    def report(self, output: str | os.PathLike[str], *, force: bool = False) -> Path:
        """Writes a page for browsers about this change: tables, plots, findings of both states.

        Raises
        ------
        OutputError
            It is there already and `force` is not said.
        """
        path = Path(at_home(output))
        _native.write_file(path, self.html().encode("utf-8"), force)
        return path

    def html(self) -> str:
        """The page that `report` writes."""
        return self._planned.page(self.verb, self._call())

    def _call(self) -> str:
        own = {name: value for name, value in self._fields.items() if name not in ("verb", "models")}
        # Of `set` each property is a keyword.
        own |= own.pop("set", {})
        words = ", ".join(
            f"{name}_={value!r}" if name in ("from", "class") else f"{name}={value!r}" for name, value in own.items()
        )
        return f"ocs.{self.verb.replace('-', '_')}({', '.join(filter(None, (repr(self.path), words)))})"

    def __repr__(self) -> str:
        record = self.record
        counts = [(len(record["changes"]), "number", "numbers"), (len(record["objects"]), "object", "objects")]
        said = [f"{count} {one if count == 1 else several}" for count, one, several in counts if count]
        return f"<Result of {self.verb}: {printable(self.path)}: {' and '.join(said) or 'nothing'} to change>"

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return framed(self.html(), f"{self.verb}: {self.path}")

    def __reduce__(self) -> tuple[Any, ...]:
        # Everything that the plan was made from travels along: where it arrives, the files need not be there.
        return _restored, (self._fields, self._planned.read(), self._folder)


class _Before:
    """The model of a result as it is, for remedies of what was found in it."""

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


def _restored(fields: dict[str, Any], files: dict[Path, bytes], folder: str | None) -> Result:
    return Result(fields, _native.plan(fields, files, False), folder)
