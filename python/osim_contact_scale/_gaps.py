"""Gaps in tables of models: an option whose cell is empty is left out, and the log says where."""

from __future__ import annotations

import json
import logging
import numbers
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from ._errors import RequestError, warn
from ._rows import is_blank, is_missing
from ._text import printable

log = logging.getLogger("osim_contact_scale")


class Gaps(NamedTuple):
    """The rows in which a column has no value."""

    #: Rows, from 0.
    places: set[int]
    #: The rows that have NaN, NaT or NA, which may be the result of a failed calculation.
    nan: set[int]
    #: Whether all other values of the column are numbers.
    is_numeric: bool


def find_gaps(rows: Sequence[Mapping[str, Any]], count_none: bool) -> dict[str, Gaps]:
    """The gaps of each column that has gaps.

    Columns whose names begin with # are left out, and so are empty rows. None only counts with `count_none`: in a list somebody wrote it,
    in a DataFrame it may be a gap.
    """
    gaps: dict[str, Gaps] = {}
    for index, row in enumerate(rows):
        missing = [name for name, value in row.items() if is_missing(value) and not name.startswith("#")]
        if len(missing) == len(row):
            continue
        for name in missing:
            is_nan = row[name] is not None
            if is_nan or count_none:
                if name not in gaps:
                    gaps[name] = Gaps(set(), set(), _is_numeric(other.get(name) for other in rows))
                gaps[name].places.add(index)
                gaps[name].nan.update([index] if is_nan else [])
    return gaps


def _is_numeric(values: Iterable[Any]) -> bool:
    return all(
        isinstance(value, numbers.Number) and not isinstance(value, bool) for value in values if value is not None
    )


def log_gaps(gaps: Mapping[str, Gaps], rows: Sequence[Mapping[str, Any]]) -> None:
    """Logs where an option is left out because its value is missing.

    pandas fills gaps with NaN. In a column of numbers, a gap thus looks like a failed calculation, which is a warning.
    """
    for name, gap in gaps.items():
        empty = "empty (NaN)" if gap.nan else "empty"
        count = _count_phrase(len(gap.places), len(rows))
        message = f"column {printable(name)}: {count} {empty}: the option is left out there"
        if gap.nan and gap.is_numeric:
            warn(message)
        else:
            log.info("%s", message)
    if blank := sum(map(is_blank, rows)):
        log.info("%s empty and left out", _count_phrase(blank, len(rows)))


def _count_phrase(some: int, rows: int) -> str:
    return f"{some} of {rows} rows {'is' if some == 1 else 'are'}" if rows > 1 else "the row is"


def explain_gaps(error: Exception, gaps: Mapping[str, Gaps], row_names: Sequence[str]) -> Exception:
    """An error about a table, with the names and the empty columns of the rows in it, and with the way to keep own columns.

    In the table that Rust reads, the first row is row 2; a DataFrame has no such lines.
    """

    def with_empty_columns(match: re.Match[str]) -> str:
        place, column = int(match["row"]) - 2, match["column"]
        empty_gaps = {name: gap for name, gap in gaps.items() if place in gap.places and column in (None, name)}
        empty = ", ".join(f"{name} (NaN)" if place in gap.nan else name for name, gap in empty_gaps.items())
        row_name = row_names[place] if 0 <= place < len(row_names) else f"row {match['row']}"
        named = match[0].replace(f"row {match['row']}", row_name, 1)
        return f"{named} (empty there: {empty})" if empty_gaps else named

    pattern = r"^table: row (?P<row>\d+)(, column '(?P<column>[^']*)')?:.*$"
    message = re.sub(pattern, with_empty_columns, str(error), flags=re.MULTILINE)
    if unknown := re.findall(r"the column '([^']*)' is not an option of", message):
        message += f"; columns of your own are kept by their names, keep={json.dumps(unknown, ensure_ascii=False)}"
    if message == str(error):
        return error
    if isinstance(error, RequestError):
        return RequestError(error.code, message, keywords=error.keywords)
    return TypeError(message)
