"""Tables that this package returns: a DataFrame if pandas is installed, else a list of dictionaries with the same keys."""

from __future__ import annotations

import importlib.util
import re
import sys
from collections.abc import Mapping, Sequence
from typing import Any, cast

from .types import Table

#: Names of columns that hold numbers, even if all of them are missing.
_NUMBERS = re.compile(
    r"old|new|factor|set|line|column|row|x|y|value|(old|new)_[xyz]|dimensionless_.*|relative_indentation_.*"
    r"|.*_(from|to|factor|kg|m|m_s|s_m|m_s2|n|n_m|n_m2|hz)"
)


def table(rows: Sequence[Mapping[str, Any]], columns: Sequence[str]) -> Table:
    """A table of rows with these columns. A missing value is None, or NaN in a column of numbers."""
    if importlib.util.find_spec("pandas") is None:
        return cast("Table", [{column: row.get(column) for column in columns} for row in rows])
    import pandas as pd

    values = {column: [row.get(column) for row in rows] for column in columns}
    frame = pd.DataFrame(values, columns=list(columns))
    for column, column_values in values.items():
        # A column of numbers with gaps has the type float64, even if the numbers are whole or all of them are missing.
        if (not column_values or any(value is None for value in column_values)) and _is_numeric(column, column_values):
            frame[column] = frame[column].astype("float64")
    return frame


def polars_table(rows: Sequence[Mapping[str, Any]], columns: Sequence[str]) -> Any:
    """A DataFrame of polars, which the caller has imported. A missing value is null."""
    polars = sys.modules["polars"]
    return polars.DataFrame([_polars_column(polars, column, [row.get(column) for row in rows]) for column in columns])


def _polars_column(polars: Any, name: str, values: list[Any]) -> Any:
    if not _is_numeric(name, values):
        present = {type(value) for value in values if value is not None}
        kind = None if present - {str} else polars.String
    else:
        kind = polars.Int64 if {int} == {type(value) for value in values if value is not None} else polars.Float64
    return polars.Series(name, values, dtype=kind)


def _is_numeric(column: str, values: Sequence[Any]) -> bool:
    """Whether a column holds numbers, judged by its values, or by its name if all values are missing."""
    present = [value for value in values if value is not None]
    return all(_is_number(value) for value in present) if present else _NUMBERS.fullmatch(column) is not None


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def all_columns(first: Sequence[str], rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """The columns `first`, then all others of the rows in the order of their first appearance."""
    names = dict.fromkeys(first)
    for row in rows:
        names.update(dict.fromkeys(row))
    return list(names)
