"""The folder of results: whole part files while a run goes on, and tables at its end.

A part has the rows that came since the last one. It gets its name when all of it is on the disk, so who reads along meets whole parts
only, and a kill loses what came within the last moment, never a file.
"""

from __future__ import annotations

import errno
import json
import logging
import os
import re
import socket
import time
import uuid
from collections.abc import Callable, Container, Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from .._errors import OutputError
from .._text import printable
from ._job import Outcome, RowStatus

log = logging.getLogger("osim_contact_scale")

#: Seconds after which rows go to the disk.
FLUSH_SECONDS = 1.0
#: Rows that are never kept back.
FLUSH_ROWS = 1000

PARTS = "parts"
_SERIES = ".series.parquet"
_ROWS = ".rows.parquet"

_ROW_SCHEMA = pa.schema(
    [
        ("key", pa.string()),
        ("status", pa.string()),
        ("error", pa.string()),
        # A JSON object: tasks have numbers of any name, and parts must go together whatever is in them.
        ("numbers", pa.string()),
        ("task_seconds", pa.float64()),
        ("process_seconds", pa.float64()),
        ("memory_mb", pa.float64()),
        ("host", pa.string()),
        ("time_limit", pa.float64()),
    ]
)


class Store:
    """Writes the parts of one run."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.parts = folder / PARTS
        try:
            self.parts.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise _cannot_write(folder, error) from error
        #: Many runs may write into one folder, from many machines.
        host = re.sub(r"[^A-Za-z0-9.-]", "-", socket.gethostname())[:60]
        self._run = f"{time.strftime('%Y%m%dT%H%M%S')}-{host}-{os.getpid()}-{uuid.uuid4().hex[:6]}"
        self._count = 0
        self._waiting: list[Outcome] = []
        self._since = 0.0

    def add(self, outcome: Outcome) -> None:
        """Takes a row; it is on the disk after `SOON`."""
        if not self._waiting:
            self._since = time.monotonic()
        self._waiting.append(outcome)
        if len(self._waiting) >= FLUSH_ROWS:
            self.flush()

    def is_due(self) -> bool:
        """Whether rows wait for long enough."""
        return bool(self._waiting) and time.monotonic() - self._since >= FLUSH_SECONDS

    def flush(self) -> None:
        """Writes what waits, as a whole part.

        Raises
        ------
        OutputError
            It cannot be written. Parts that are there stay whole.
        """
        if not self._waiting:
            return
        rows, self._waiting = self._waiting, []
        self._count += 1
        name = f"{self._run}-{self._count:06d}"
        try:
            series = _series_table(rows)
            # Series first: a row that is there has its series.
            if series is not None:
                self._write(name + _SERIES, series)
            self._write(name + _ROWS, pa.Table.from_pylist([_record(row) for row in rows], schema=_ROW_SCHEMA))
        except BaseException:
            # Stopped in the middle of it, by Ctrl-C or a full disk: the end of the run tries again.
            self._waiting = rows + self._waiting
            raise

    def merge(self) -> None:
        """Makes one part of those that this run wrote: a long run has thousands.

        Raises
        ------
        OutputError
            It cannot be written. Parts that are there stay whole.
        """
        names = [f"{self._run}-{count:06d}" for count in range(1, self._count + 1)]
        for kind in (_SERIES, _ROWS):
            paths = [path for name in names if (path := self.parts / (name + kind)).exists()]
            if len(paths) > 1:
                merged = pa.concat_tables([pq.read_table(path) for path in paths], promote_options="default")
                # For a moment both files have the rows; there is no moment without them.
                self._write(self._run + kind, merged.unify_dictionaries())
                for path in paths:
                    path.unlink()

    def _write(self, name: str, table: pa.Table) -> None:
        replace(self.parts / name, lambda path: pq.write_table(table, path))


def replace(path: Path, write: Callable[[Path], Any]) -> None:
    """Writes a file that gets its name when it is whole.

    Raises
    ------
    OutputError
        It cannot be written; nothing is left of it.
    """
    partial = path.with_name(f".{path.name}.{uuid.uuid4().hex[:12]}.partial")
    try:
        try:
            write(partial)
            with open(partial, "rb+") as file:
                os.fsync(file.fileno())
            os.replace(partial, path)
            _sync_folder(path.parent)
        except BaseException:
            partial.unlink(missing_ok=True)
            raise
    except OSError as error:
        raise _cannot_write(path, error) from error


def _sync_folder(folder: Path) -> None:
    """Names are on the disk, too. Windows has no way to ask for it, and some network file systems neither."""
    if os.name == "posix":
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            with suppress(OSError):
                os.fsync(descriptor)
        finally:
            os.close(descriptor)


def _cannot_write(path: Path, error: OSError) -> OutputError:
    message = f"cannot be written: {error.strerror or error}"
    if error.errno in (errno.ENOSPC, getattr(errno, "EDQUOT", errno.ENOSPC)):
        message += ". Rows of earlier parts are kept: make room and run again with resume"
    return OutputError("output", message, path=str(path))


def _record(outcome: Outcome) -> dict[str, Any]:
    names = [name for name in _ROW_SCHEMA.names if name != "numbers"]
    return {**{name: getattr(outcome, name) for name in names}, "numbers": json.dumps(outcome.numbers)}


def _series_table(rows: Iterable[Outcome]) -> pa.Table | None:
    """All series below each other, with the key of their row."""
    tables = [
        pa.table({"key": pa.array([row.key] * length).dictionary_encode(), **row.series})
        for row in rows
        if (length := max(map(len, row.series.values()), default=0))
    ]
    return pa.concat_tables(tables, promote_options="default").unify_dictionaries() if tables else None


def read_statuses(folder: Path) -> dict[str, RowStatus]:
    """The outcomes of the rows that are there, by their keys; of two with one key the better one.

    Without their numbers: each job of an array asks, and there may be millions.
    """
    statuses: dict[str, RowStatus] = {}
    for table in _part_tables(folder, _ROWS, columns=["key", "status", "time_limit"]):
        for key, status, limit in zip(*(table[name].to_pylist() for name in ("key", "status", "time_limit"))):
            if key not in statuses or statuses[key].status != "done":
                statuses[key] = RowStatus(status, limit)
    return statuses


def read_outcomes(folder: Path, keys: Container[str]) -> dict[str, Outcome]:
    """The rows with these keys; of two with one key the better one."""
    outcomes: dict[str, Outcome] = {}
    for table in _part_tables(folder, _ROWS, schema=_ROW_SCHEMA):
        for batch in table.to_batches(FLUSH_ROWS):
            for record in batch.to_pylist():
                key = record["key"]
                if key in keys and (key not in outcomes or outcomes[key].status != "done"):
                    outcomes[key] = Outcome(**{**record, "numbers": json.loads(record["numbers"])})
    return outcomes


def read_series(folder: Path, key: str) -> pd.DataFrame | None:
    """The series of one row; None if it has none."""
    for table in _part_tables(folder, _SERIES, filters=[("key", "=", key)]):
        if table.num_rows:
            # Other rows of this part may have other series. A series that is not a number has values all the same: they are no nulls.
            names = [name for name in table.column_names if name != "key" and table[name].null_count < table.num_rows]
            frame: pd.DataFrame = table.select(names).to_pandas()
            return frame
    return None


def _part_tables(folder: Path, kind: str, **options: Any) -> Iterator[pa.Table]:
    """What is in the parts, while other runs may write and merge theirs."""
    read_paths: set[Path] = set()
    while True:
        paths = set((folder / PARTS).glob(f"*{kind}")) - read_paths
        if not paths:
            return
        for path in sorted(paths):
            read_paths.add(path)
            try:
                table = pq.read_table(path, **options)
            except FileNotFoundError:
                continue  # It was merged since, and the next round finds where to.
            except (pa.ArrowException, OSError) as error:
                reason = printable(str(error).splitlines()[0])
                log.warning("%s is left out, its rows are simulated again: %s", printable(str(path)), reason)
                continue
            yield table
