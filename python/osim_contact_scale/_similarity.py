"""Numbers of a model other than contacts that depend on body size: `check(from_=...)` and `inspect(target_mass=...)` list them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, SupportsIndex, overload

from ._frames import to_frame
from ._html import heading, html_table, paragraph
from ._named_values import repr_line
from ._tables import table
from .types import Table

if TYPE_CHECKING:
    import pandas as pd

#: Fields of a record that become three columns each: median, min and max.
_SPREAD_FIELDS = ("value", "factor")
_COLUMNS = (
    "model",
    "kind",
    "description",
    "unit",
    "count",
    "value_median",
    "value_min",
    "value_max",
    "pairs",
    "same",
    "factor_median",
    "factor_min",
    "factor_max",
    "similarity_factor",
    "similarity_formula",
    "verdict",
)


class Similarity(Sequence[dict[str, Any]]):
    """For each model, its other numbers that depend on size: a record with the ratios and a list of `kinds`, as in the JSON.

    This package never changes these numbers, and geometric similarity is one choice among several.

    Attributes
    ----------
    records : list of dict
        One for each model that was compared.
    """

    __slots__ = ("_models", "records")

    def __init__(self, records: Iterable[Mapping[str, Any]]) -> None:
        listed = [record for record in records if record.get("similarity") is not None]
        self._models: list[str] = [record["model"] for record in listed]
        self.records: list[dict[str, Any]] = [record["similarity"] for record in listed]

    @overload
    def __getitem__(self, index: SupportsIndex, /) -> dict[str, Any]: ...

    @overload
    def __getitem__(self, index: slice, /) -> list[dict[str, Any]]: ...

    def __getitem__(self, index: Any, /) -> Any:
        return self.records[index]

    def __len__(self) -> int:
        return len(self.records)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Similarity):
            return NotImplemented
        return (self._models, self.records) == (other._models, other.records)

    __hash__ = None  # type: ignore[assignment]

    @property
    def table(self) -> Table:
        """A row for each kind of number of each model: count, actual factor, factor by geometric similarity, and verdict."""
        return table(self._rows(), _COLUMNS)

    def frame(self) -> pd.DataFrame:
        """The table, always as a DataFrame.

        Examples
        --------
        >>> ocs.check("scaled.osim", from_="generic.osim").similarity.frame()[["kind", "factor_median", "verdict"]]
        """
        return to_frame(lambda: self.table)

    def _rows(self) -> list[dict[str, Any]]:
        rows = []
        for model, record in zip(self._models, self.records):
            for kind in record["kinds"]:
                row = {"model": model, **{name: value for name, value in kind.items() if name not in _SPREAD_FIELDS}}
                for spread in _SPREAD_FIELDS:
                    parts = kind[spread] or {}
                    row |= {f"{spread}_{part}": parts.get(part) for part in ("median", "min", "max")}
                rows.append({name: row[name] for name in _COLUMNS})
        return rows

    def __repr__(self) -> str:
        return repr_line("Similarity", f"{sum(len(record['kinds']) for record in self.records)} kinds of numbers")

    def _repr_html_(self) -> str:
        if not self.records:
            return paragraph("nothing was compared: name the original with from_, or a target_mass")
        names = ("description", "count", "factor_median", "similarity_factor", "verdict")
        rows = ([row[name] for name in names] for row in self._rows())
        return heading("What else follows size") + html_table(names, rows, ".table has all")
