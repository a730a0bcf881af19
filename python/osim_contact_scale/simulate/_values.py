"""Converts values to cells of a table, and describes values for the key of a row."""

from __future__ import annotations

import datetime
import enum
import hashlib
import os
import re
from typing import Any

from ._job import Value

#: Limit of the whole numbers that a column can hold.
_INT64_LIMIT = 2**63


def to_value(value: Any) -> Value:
    """A value for a cell of a table: a number, a text, true or false, or None.

    Raises
    ------
    TypeError
        The value is of another type.
    ValueError
        The number is too long, or the text is not Unicode.
    """
    if hasattr(value, "tolist"):  # NumPy's numbers.
        value = value.tolist()
    if isinstance(value, (datetime.date, datetime.time)):
        value = value.isoformat()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if value is None or isinstance(value, bool) or type(value).__name__ in ("NAType", "NaTType"):
        return value if isinstance(value, bool) else None
    if isinstance(value, int):
        if not -_INT64_LIMIT <= value < _INT64_LIMIT:
            raise ValueError(f"{value} is longer than 64 bits, which a table cannot hold")
        return int(value)
    if isinstance(value, float):
        # NaN becomes a missing value: a table has only one of the two.
        return None if value != value else float(value)
    if isinstance(value, str):
        try:
            value.encode()
        except UnicodeEncodeError:
            raise ValueError(f"{value!a} is no text in Unicode") from None
        return str.__str__(value)
    raise TypeError(f"{type(value).__name__}, expected a number or a text")


def describe_value(value: Any) -> list[Any] | None:
    """A nested list of texts for a value without objects of your classes; None for all others."""
    if isinstance(value, enum.Enum):
        return ["enum", type(value).__qualname__, value.name]
    if value is None or type(value) in (bool, int, float, complex, str, bytes, range, slice, type(...)):
        return [type(value).__name__, repr(value)]
    if isinstance(value, (re.Pattern, os.PathLike, datetime.date, datetime.time, datetime.timedelta)):
        return [type(value).__name__, repr(value)]
    if hasattr(value, "dtype") and hasattr(value, "tobytes"):
        if value.dtype.hasobject:
            return ["array", repr(value.tolist())] if " at 0x" not in repr(value.tolist()) else None
        return ["array", str(value.dtype), str(value.shape), hashlib.sha256(value.tobytes()).hexdigest()]
    if hasattr(value, "to_csv") and hasattr(value, "index"):  # Of pandas.
        return [
            type(value).__name__,
            hashlib.sha256(value.to_csv(float_format="%.17g").encode()).hexdigest(),
            str(value.dtypes),
        ]
    return None
