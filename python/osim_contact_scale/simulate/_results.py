"""The results of a run."""

from __future__ import annotations

import operator
from pathlib import Path

import pandas as pd

from .._errors import RequestError
from .._text import printable
from ._store import read_series


class Results:
    """The results of a run.

    Attributes
    ----------
    table : pandas.DataFrame
        A row for each point: its columns, `key`, `status` (`done`, `failed`, `crashed`, `time limit`, `lost`, `refused`; missing where
        it was not run), `error`, and the numbers of the task, with their units in their names.
    runs : pandas.DataFrame
        A row for each simulation: seconds of the task and of its process, memory in MB, and the machine.
    folder : pathlib.Path
        The folder with `table.csv`, `table.parquet`, `runs.csv` and the parts.
    """

    def __init__(self, folder: Path, table: pd.DataFrame, runs: pd.DataFrame) -> None:
        self.folder = folder
        self.table = table
        self.runs = runs

    @property
    def failures(self) -> pd.DataFrame:
        """The rows whose status is not `done`."""
        return self.table[self.table["status"] != "done"]

    def series(self, row: int | str) -> pd.DataFrame:
        """The time series of one row.

        Parameters
        ----------
        row : int or str
            The index of the row in `table`, from 0, or its key.

        Raises
        ------
        RequestError
            The row has no series.
        """
        key = row if isinstance(row, str) else self._key(row)
        series = read_series(self.folder, key)
        if series is None:
            raise RequestError("usage", f"{printable(str(self.folder))} has no series of {printable(str(row))}")
        return series

    def _key(self, place: int) -> str:
        number = operator.index(place)
        if not 0 <= number < len(self):
            raise RequestError("usage", f"there is no row {number}: expected 0 to {len(self) - 1}")
        return str(self.table["key"].iloc[number])

    def __len__(self) -> int:
        return len(self.table)

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {status}" for status, count in self.table["status"].value_counts().items())
        return f"<Results of {len(self)} points in {printable(self.folder.name)}: {counts or 'nothing yet'}>"

    def _repr_html_(self) -> str:
        html: str = self.table.to_html(max_rows=20)
        return html
