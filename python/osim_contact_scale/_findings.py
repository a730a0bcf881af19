"""Findings in a model, and their remedies."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, SupportsIndex, overload

from ._errors import RequestError
from ._frames import to_frame
from ._html import heading, html_table, paragraph, preformatted
from ._keywords import MODELS, expand_home, is_path
from ._named_values import NamedValues, repr_line, repr_lines
from ._tables import table
from ._text import printable
from .types import Source, Table

if TYPE_CHECKING:
    import pandas as pd

    from ._result import Result

#: Columns of a table of findings.
COLUMNS = ("code", "severity", "message", "place", "spheres", "line", "column", "why", "advice", "command")


@dataclass(frozen=True, repr=False)
class Remedy(NamedValues):
    """A call that corrects what a finding reports.

    Attributes
    ----------
    call : str
        The call as a line of Python.
    """

    call: str
    #: The requests to make one after the other; the last one is the remedy itself.
    _requests: str = field(repr=False)
    _source: Any = field(repr=False, compare=False, default=None)
    #: The other models of the call that reported the finding, by their names in the request.
    _others: dict[str, Any] = field(repr=False, compare=False, default_factory=dict)
    #: The current folder when the finding was reported.
    _folder: str | None = field(repr=False, compare=False, default=None)

    def apply(self, source: Source | None = None) -> Result:
        """Plans the change; nothing is written before `Result.write`.

        Parameters
        ----------
        source : path, bytes, Result or opensim.Model, optional
            Another state of the model, such as the result of another remedy. By default the model that the finding is about, after
            the remedies that must be applied before this one.

        Returns
        -------
        Result

        Raises
        ------
        RequestError
            The model was named in a folder that is no longer the current one: its name may be that of another model here.
        """
        steps = json.loads(self._requests)
        model_names = steps[0].get("models", [None])
        if source is not None:
            steps = steps[-1:]
        else:
            source = self._source if self._source is not None else model_names[0]
        if is_path(source) and self._folder not in (None, os.getcwd()) and not os.path.isabs(expand_home(source)):
            message = f"{printable(os.fsdecode(source))} was named in the folder {self._folder}, which is no longer the current one"
            raise RequestError("usage", f"{message}: go back to that folder, or check it by its whole path")
        result = self._plan_step(steps[0], source)
        for step in steps[1:]:
            result = self._plan_step(step, result)
        return result

    def _plan_step(self, step: dict[str, Any], source: Any) -> Result:
        # Not at the top of the file: a result has findings, so `_result` imports this module.
        from ._result import plan

        fields = {name: value for name, value in step.items() if name not in ("verb", "models", "output")}
        others = {name: self._others[fields[name]] for name in MODELS if fields.get(name) in self._others}
        return plan(step["verb"], source, fields | others)

    def __str__(self) -> str:
        return self.call

    def __repr__(self) -> str:
        return repr_line("Remedy", self.call)

    def _repr_html_(self) -> str:
        return preformatted(self.call, ".call")


@dataclass(frozen=True, repr=False)
class Finding(NamedValues):
    """A problem of a model, or a remark about it.

    Attributes
    ----------
    code : str
        Stable short name, which `explain` explains.
    severity : str
        `error`, `warning` or `remark`.
    message : str
        A description of this case.
    why, advice : str
        Why it matters and what to do about it, for every case of this code.
    place : str or None
        Component path of the force or sphere.
    places : tuple of str
        Component paths of all elements concerned, `place` first, as far as they are known.
    spheres : tuple of str
        Names of all spheres concerned.
    line, column : int or None
        Where it is in the model's file.
    details : tuple of str
        Sentences about single spheres, such as where each belongs; empty if the message says all.
    had_before : bool
        Of the result of a change: the model before it, or the reference, has this finding, too.
    as_published : bool
        The known contacts were published with the finding.
    remedy : Remedy or None
        A call that corrects it, if there is one.
    """

    code: str
    severity: str
    message: str
    why: str
    advice: str
    place: str | None
    places: tuple[str, ...]
    spheres: tuple[str, ...]
    line: int | None
    column: int | None
    details: tuple[str, ...]
    had_before: bool
    as_published: bool
    remedy: Remedy | None

    @classmethod
    def _from_record(
        cls, record: dict[str, Any], request: str | None, source: Any, others: dict[str, Any], folder: str | None
    ) -> Finding:
        command = record["command"]
        remedy = Remedy(command, request, source, others, folder) if command and request else None
        lists = {key: tuple(record[key]) for key in ("places", "spheres", "details")}
        values = {key: value for key, value in record.items() if key != "command"}
        return cls(**values | lists, remedy=remedy)

    def __str__(self) -> str:
        return f"{self.severity}: {self.code}: {self.message}"

    def __repr__(self) -> str:
        return repr_line("Finding", str(self))

    def _repr_html_(self) -> str:
        names = ("severity", "code", "message", "place", "line", "column", "why", "advice", "remedy")
        fields = ((name, getattr(self, name)) for name in names)
        return html_table(("", "finding"), [(name, value) for name, value in fields if value is not None])


class Findings(tuple[Finding, ...], NamedValues):
    """Findings from the worst to the least; in a notebook a table.

    By its name a column has the values of all: `findings.code`, or `findings["code"]`.
    """

    __slots__ = ()

    @classmethod
    def _from_records(
        cls, records: Any, requests: Any, source: Any, others: dict[str, Any] | None = None, folder: str | None = None
    ) -> Findings:
        requests = list(requests) + [None] * (len(records) - len(requests))
        pairs = zip(records, requests)
        return cls(Finding._from_record(record, request, source, others or {}, folder) for record, request in pairs)

    @overload
    def __getitem__(self, index: SupportsIndex, /) -> Finding: ...

    @overload
    def __getitem__(self, index: slice, /) -> Findings: ...

    @overload
    def __getitem__(self, index: str, /) -> Any: ...

    def __getitem__(self, index: Any, /) -> Any:
        if isinstance(index, str):
            return self._get_by_name(index)
        item = super().__getitem__(index)
        return Findings(item) if isinstance(index, slice) else item

    def _values(self) -> Mapping[str, Any]:
        return {name: tuple(row[name] for row in self._rows()) for name in COLUMNS}

    def _rows(self) -> list[dict[str, Any]]:
        rows = []
        for finding in self:
            row = {name: getattr(finding, name) for name in COLUMNS if name != "command"}
            row["spheres"] = " ".join(finding.spheres)
            row["command"] = None if finding.remedy is None else finding.remedy.call
            rows.append(row)
        return rows

    @property
    def table(self) -> Table:
        """The findings as a table: a DataFrame where pandas is there, else a list of dictionaries."""
        return table(self._rows(), COLUMNS)

    def frame(self) -> pd.DataFrame:
        """The findings, always as a DataFrame, with a row for each.

        Examples
        --------
        >>> check.findings.frame()["code"].value_counts()
        """
        return to_frame(lambda: self.table)

    def __str__(self) -> str:
        return "\n".join(str(finding) for finding in self) or "no findings"

    def __repr__(self) -> str:
        return repr_lines(f"Findings: {len(self)}", (str(finding) for finding in self), len(self))

    def _repr_html_(self) -> str:
        return self._html_table("")

    def _html_table(self, title: str, where: str = ".findings.table has all") -> str:
        """A table of the findings with their remedies, under a title; a sentence if there are none.

        If not all have room, `where` says where all are.
        """
        if not self:
            return paragraph(f"{title}: none" if title else "no findings")
        names = ("severity", "code", "message", "place", "remedy")
        rows = ([getattr(finding, name) for name in names] for finding in self)
        return (heading(title) if title else "") + html_table(names, rows, where)
