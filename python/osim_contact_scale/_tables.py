"""Tables that go out: a pandas DataFrame where pandas is there, else a list of dictionaries with the same keys."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Mapping, Sequence
from typing import Any, cast

from .types import Table

#: Names of columns that hold numbers, also where all of them are missing.
_NUMBERS = re.compile(
    r"old|new|factor|set|line|column|row|x|y|value|(old|new)_[xyz]|dimensionless_.*|relative_indentation_.*"
    r"|.*_(from|to|factor|kg|m|m_s|s_m|m_s2|n|n_m|n_m2|hz)"
)


def table(rows: Sequence[Mapping[str, Any]], columns: Sequence[str]) -> Table:
    """Rows under these columns. What a row does not have is missing: None, and NaN in a column of numbers."""
    filled = [{column: row.get(column) for column in columns} for row in rows]
    if importlib.util.find_spec("pandas") is None:
        return cast("Table", filled)
    import pandas as pd

    frame = pd.DataFrame(filled, columns=list(columns))
    for column in columns:
        values = [row[column] for row in filled]
        known = [value for value in values if value is not None]
        # A column of numbers with gaps is one of float64, also where the numbers are whole or all of them are missing.
        of_numbers = all(_is_number(value) for value in known) if known else _NUMBERS.fullmatch(column) is not None
        if of_numbers and (not known or len(known) < len(values)):
            frame[column] = frame[column].astype("float64")
    return frame


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def columns_of(first: Sequence[str], rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Those that are always there, then the others in the order in which they come."""
    names = dict.fromkeys(first)
    for row in rows:
        names.update(dict.fromkeys(row))
    return list(names)
