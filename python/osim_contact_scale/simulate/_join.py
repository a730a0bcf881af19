"""Makes the tables at the end of a run: every point with its outcome."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from .._cells import to_cell
from ._job import RESULT_COLUMNS, Outcome
from ._points import Point
from ._store import write_completely

TABLE = "table"
RUNS = "runs.csv"

_RUN_COLUMNS = ("key", "status", "task_seconds", "process_seconds", "memory_mb", "host", "time_limit")


def join_outcomes(points: Sequence[Point], keys: Mapping[int, str], rows: Mapping[str, Outcome]) -> pd.DataFrame:
    """A row for each point in their order: its columns, key, status, error, and the task's numbers. Points without a row have no status.

    If a number has the name of a column of the points, `_result` is added to its name.
    """
    outcomes = [rows.get(keys.get(point.row, "")) for point in points]
    point_columns = {name: None for point in points for name in point.columns}
    numbers: dict[str, str] = {}
    for row in outcomes:
        for name in row.numbers if row is not None else ():
            if name not in numbers:
                numbers[name] = _unused_name(name, {*point_columns, *RESULT_COLUMNS, *numbers.values()})
    return pd.DataFrame(
        [_row_of_point(point, keys.get(point.row), row, numbers) for point, row in zip(points, outcomes)],
        columns=[*point_columns, *RESULT_COLUMNS, *numbers.values()],
    )


def _unused_name(name: str, used: set[str]) -> str:
    """A name for a column that no other column has."""
    while name in used:
        name = f"{name}_result"
    return name


def _row_of_point(point: Point, key: str | None, row: Outcome | None, numbers: Mapping[str, str]) -> dict[str, Any]:
    record = {**point.columns, "key": key}
    if row is not None:
        # The parts do not have the name of the model, because models of equal bytes share an outcome.
        error = None if row.error is None else point.with_file_name(row.error)
        record.update(status=row.status, error=error, **{numbers[name]: value for name, value in row.numbers.items()})
    return record


def run_table(rows: Mapping[str, Outcome]) -> pd.DataFrame:
    """Duration, machine and memory of each simulation: the values that differ if a run is repeated."""
    records = [{name: getattr(row, name) for name in _RUN_COLUMNS} for row in rows.values()]
    return pd.DataFrame(records, columns=list(_RUN_COLUMNS))


def write_tables(folder: Path, table: pd.DataFrame, runs: pd.DataFrame) -> None:
    """Writes `runs.csv`, and `table.csv` and `table.parquet`, whose bytes do not depend on interruptions of the run.

    Raises
    ------
    OutputError
        One of them cannot be written. An older one stays.
    """
    write_completely(folder / f"{TABLE}.csv", lambda path: _write_csv(path, table))
    write_completely(folder / f"{TABLE}.parquet", lambda path: _plain_types(table).to_parquet(path, index=False))
    write_completely(folder / RUNS, lambda path: _write_csv(path, runs))


def _write_csv(path: Path, table: pd.DataFrame) -> None:
    texts = {name: table[name].map(_csv_cell) for name in table.columns if table[name].dtype.kind not in "ifb"}
    table.assign(**texts).to_csv(path, index=False, lineterminator="\n", quoting=csv.QUOTE_MINIMAL)


def _csv_cell(value: Any) -> Any:
    return to_cell(value) if isinstance(value, str) else value


def _plain_types(table: pd.DataFrame) -> pd.DataFrame:
    """A table for Parquet, in which a column has one type: a column with numbers and texts becomes texts."""
    mixed = {
        name: table[name].map(lambda value: None if pd.isna(value) else str(value))
        for name in table.columns
        if len({_type_for_parquet(value) for value in table[name] if not pd.isna(value)}) > 1
    }
    return table.assign(**mixed)


def _type_for_parquet(value: Any) -> str:
    return "number" if isinstance(value, (int, float)) and not isinstance(value, bool) else type(value).__name__
