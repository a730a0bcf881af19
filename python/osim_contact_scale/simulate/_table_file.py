"""Reads a table of points from a CSV file."""

from __future__ import annotations

import csv
import re
from pathlib import Path
from typing import Any

from .._cells import from_cell
from .._errors import RequestError
from .._sweep import number_or_text
from .._text import printable

#: A whole number. Digits that begin with 0 are the name of a subject, and a longer number would lose digits as a float.
_WHOLE_NUMBER = re.compile(r"-?(0|[1-9]\d{0,17})")
_LOOKS_WHOLE = re.compile(r"[-+]?\d+")


def read_rows(path: Path) -> list[dict[str, Any]]:
    """The rows of a CSV file: numbers, true and false, texts, and None for an empty cell.

    Raises
    ------
    RequestError
        The file is not CSV in UTF-8, or a row has more cells than the table has columns.
    OSError
        The file cannot be read.
    """
    printed_name = printable(str(path))
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            lines = list(csv.reader(file))
    except UnicodeDecodeError:
        raise _table_error(f"{printed_name}: it is not in UTF-8: save it as CSV UTF-8") from None
    except csv.Error as error:
        raise _table_error(f"{printed_name}: it is no table in CSV: {error}") from None
    if not lines:
        raise _table_error(f"{printed_name}: it is empty: expected a first line with the names of columns")
    names = [from_cell(name) for name in lines[0]]
    repeated = next((name for name in names if names.count(name) > 1), None)
    if repeated is not None:
        raise _table_error(f"{printed_name}: the column {printable(repeated)!r} appears twice")
    rows = []
    for line, cells in enumerate(lines[1:], 2):
        if len(cells) > len(names):
            raise _table_error(f"{printed_name}: line {line} has {len(cells)} cells, expected {len(names)}")
        if cells:
            rows.append({name: parse_cell(from_cell(cell)) for name, cell in zip(names, cells)})
    return rows


def parse_cell(text: str) -> Any:
    """The value of a cell."""
    if _WHOLE_NUMBER.fullmatch(text):
        return int(text)
    if _LOOKS_WHOLE.fullmatch(text):
        return text
    if text in ("true", "True", "TRUE", "false", "False", "FALSE"):
        return text.lower() == "true"
    return number_or_text(text)


def _table_error(message: str) -> RequestError:
    return RequestError("usage", message, keywords=("points",))
