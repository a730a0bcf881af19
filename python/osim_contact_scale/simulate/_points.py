"""Reads the table of a run, which has a row for each model."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .._errors import RequestError
from .._rows import to_rows
from .._sweep import Sweep
from .._text import printable
from ._job import RESULT_COLUMNS, Value
from ._table_file import read_rows
from ._values import to_value


@dataclass(frozen=True)
class Point:
    """A model and its row of the table."""

    #: Row of the table, from 1.
    row: int
    #: The absolute path of the model's file.
    path: str
    #: The row without the path.
    values: Mapping[str, Any]
    #: The row for the table of results, with the path as in the given table.
    columns: Mapping[str, Any]

    def with_file_name(self, error: str) -> str:
        """An error with the name of the model's file before it."""
        return f"{printable(os.path.basename(self.path))}: {error}"


def read_points(source: Any) -> list[Point]:
    """The points of a `Sweep`, of a file of CSV, or of a table with a column `path`.

    In a file, `path` may also be called `file`; both are relative to the folder of the table.

    Raises
    ------
    RequestError
        There is no such column, or a row without a path.
    OSError
        The file cannot be read.
    """
    if isinstance(source, Sweep):
        if source.manifest is None:
            raise RequestError("usage", "points: this sweep made no models", keywords=("points",))
        source = source.manifest
    if isinstance(source, (str, os.PathLike)):
        table = Path(source)
        return _points_of_rows(read_rows(table), table.parent, printed_name=printable(str(table)))
    return _points_of_rows(to_rows(source), Path.cwd(), printed_name="points")


def _points_of_rows(rows: Sequence[Mapping[str, Any]], folder: Path, printed_name: str) -> list[Point]:
    if not rows:
        raise RequestError("usage", f"{printed_name}: it has no rows", keywords=("points",))
    for column in rows[0]:
        if column in RESULT_COLUMNS:
            message = f"{printed_name}: the column {column!r} is one of those that results have: leave out {', '.join(RESULT_COLUMNS)}"
            raise RequestError("usage", message, keywords=("points",))
    return [_point_of_row(number, row, folder, printed_name) for number, row in enumerate(rows, 1)]


def _point_of_row(number: int, row: Mapping[str, Any], folder: Path, printed_name: str) -> Point:
    column = next((name for name in ("path", "file") if name in row), None)
    if column is None:
        message = f"{printed_name}: expected a column path (or file) with the files of the models"
        raise RequestError("usage", message, keywords=("points",))
    path = row[column]
    if not isinstance(path, (str, os.PathLike)) or not os.fspath(path):
        raise RequestError("usage", f"{printed_name}: row {number} has no {column}", keywords=("points",))
    columns = {
        name: _table_value(value, f"{printed_name}: row {number}, column {name!r}") for name, value in row.items()
    }
    values = {name: value for name, value in columns.items() if name != "path"}
    return Point(number, os.path.abspath(folder / os.fsdecode(path)), values, columns)


def _table_value(value: Any, place: str) -> Value:
    try:
        return to_value(value)
    except (TypeError, ValueError) as error:
        raise RequestError("usage", f"{place}: {error}", keywords=("points",)) from None


def select_shard(points: list[Point], shard: str | None) -> list[Point]:
    """The points of one share: `"2/8"` is the second of eight shares, every eighth point from the second on.

    Raises
    ------
    RequestError
        `shard` does not have this form.
    """
    if shard is None:
        return points
    first, _, count = str(shard).partition("/")
    if not (first.isdecimal() and count.isdecimal() and 1 <= int(first) <= int(count)):
        raise RequestError(
            "usage", f"shard={shard!r}: expected I/N with I from 1 to N, such as 2/8", keywords=("shard",)
        )
    return points[int(first) - 1 :: int(count)]
