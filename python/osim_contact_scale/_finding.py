"""What is wrong with a model, and what puts it right."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, SupportsIndex, overload

from ._errors import RequestError
from ._request import MODELS, at_home, is_path
from ._tables import table
from ._text import printable

if TYPE_CHECKING:
    from ._result import Result

#: Columns of a table of findings.
COLUMNS = ("code", "severity", "message", "place", "spheres", "line", "why", "advice", "command")


@dataclass(frozen=True)
class Remedy:
    """What puts a finding right: a call that is ready to be made.

    Attributes
    ----------
    call : str
        The call as one would write it.
    """

    call: str
    _request: str = field(repr=False)
    _source: Any = field(repr=False, compare=False, default=None)
    #: The other models of the call that found it, by the names that they have in the request.
    _others: dict[str, Any] = field(repr=False, compare=False, default_factory=dict)
    #: Where names of files began when it was found.
    _folder: str | None = field(repr=False, compare=False, default=None)

    def apply(self, source: Any = None) -> Result:
        """Plans the change; nothing is written before `Result.write`.

        Parameters
        ----------
        source : path, bytes, Result or opensim.Model, optional
            Another state of the model, such as the result of another remedy. By default the model that the finding is about.

        Returns
        -------
        Result

        Raises
        ------
        RequestError
            The model was named in a folder that is no longer the current one: its name may be that of another model here.
        """
        from ._result import plan

        fields = json.loads(self._request)
        verb = fields.pop("verb")
        named = fields.pop("models", [None])
        if source is None:
            source = self._source if self._source is not None else named[0]
        if is_path(source) and self._folder not in (None, os.getcwd()) and not os.path.isabs(at_home(source)):
            message = f"{printable(os.fsdecode(source))} was named in the folder {self._folder}, which is no longer the current one"
            raise RequestError("usage", f"{message}: go back to that folder, or check it by its whole path")
        others = {name: self._others[fields[name]] for name in MODELS if fields.get(name) in self._others}
        return plan(verb, source, fields | others)

    def __str__(self) -> str:
        return self.call


@dataclass(frozen=True)
class Finding:
    """Something that is wrong with a model, or worth knowing.

    Attributes
    ----------
    code : str
        Stable short name, which `explain` explains.
    severity : str
        `error`, `warn` or `info`.
    message : str
        This case, in words.
    why, advice : str
        Why it matters and what to do about it, the same for every case.
    place : str or None
        Component path of the force or sphere.
    spheres : tuple of str
        Names of all spheres concerned.
    line : int or None
        Line in the model.
    remedy : Remedy or None
        What puts it right, where that can be proposed.
    """

    code: str
    severity: str
    message: str
    why: str
    advice: str
    place: str | None
    spheres: tuple[str, ...]
    line: int | None
    remedy: Remedy | None

    @classmethod
    def _of(
        cls, record: dict[str, Any], request: str | None, source: Any, others: dict[str, Any], folder: str | None
    ) -> Finding:
        command = record["command"]
        remedy = Remedy(command, request, source, others, folder) if command and request else None
        own = {key: value for key, value in record.items() if key not in ("command", "spheres")}
        return cls(**own, spheres=tuple(record["spheres"]), remedy=remedy)

    def __str__(self) -> str:
        return f"{self.severity}: {self.code}: {self.message}"


class Findings(tuple[Finding, ...]):
    """Findings from the worst to the least; in a notebook a table."""

    __slots__ = ()

    @classmethod
    def _of(
        cls, records: Any, requests: Any, source: Any, others: dict[str, Any] | None = None, folder: str | None = None
    ) -> Findings:
        requests = list(requests) + [None] * (len(records) - len(requests))
        both = zip(records, requests)
        return cls(Finding._of(record, request, source, others or {}, folder) for record, request in both)

    @overload
    def __getitem__(self, index: SupportsIndex, /) -> Finding: ...

    @overload
    def __getitem__(self, index: slice, /) -> Findings: ...

    def __getitem__(self, index: Any, /) -> Any:
        found = super().__getitem__(index)
        return Findings(found) if isinstance(index, slice) else found

    @property
    def table(self) -> Any:
        """The findings as a table: a DataFrame where pandas is there, else a list of dictionaries."""
        rows = []
        for finding in self:
            row = {name: getattr(finding, name) for name in COLUMNS if name != "command"}
            row["spheres"] = " ".join(finding.spheres)
            row["command"] = None if finding.remedy is None else finding.remedy.call
            rows.append(row)
        return table(rows, COLUMNS)

    def __str__(self) -> str:
        return "\n".join(str(finding) for finding in self) or "no findings"

    def _repr_html_(self) -> str:
        from ._html import html_table

        names = ("severity", "code", "message", "place")
        rows = [[getattr(finding, name) for name in names] for finding in self]
        rows = [row + [finding.remedy.call if finding.remedy else None] for row, finding in zip(rows, self)]
        return html_table((*names, "remedy"), rows)
