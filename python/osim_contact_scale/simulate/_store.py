"""Writes and reads the folder of results: part files while a run goes on, and tables at its end.

A part has the rows that came since the last part. It gets its name when it is completely on the disk, so that readers see only complete
parts, and a kill loses the rows of the last moment, but never a file.
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
#: Number of rows that go to the disk at once.
FLUSH_ROWS = 1000

PARTS = "parts"
_SERIES = ".series.parquet"
_ROWS = ".rows.parquet"

_ROW_SCHEMA = pa.schema(
    [
        ("key", pa.string()),
        ("status", pa.string()),
        ("error", pa.string()),
        # A JSON object, because tasks name their numbers freely, and parts with other numbers must fit together.
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
        """Adds a row, which is on the disk after `FLUSH_SECONDS`."""
        if not self._waiting:
            self._since = time.monotonic()
        self._waiting.append(outcome)
        if len(self._waiting) >= FLUSH_ROWS:
            self.flush()

    def is_due(self) -> bool:
        """Whether rows have waited for `FLUSH_SECONDS`."""
        return bool(self._waiting) and time.monotonic() - self._since >= FLUSH_SECONDS

    def flush(self) -> None:
        """Writes the waiting rows as a part.

        Raises
        ------
        OutputError
            The part cannot be written. Existing parts stay complete.
        """
        if not self._waiting:
            return
        rows, self._waiting = self._waiting, []
        self._count += 1
        name = f"{self._run}-{self._count:06d}"
        try:
            series = _series_table(rows)
            # Series come first, so that every row has its series.
            if series is not None:
                self._write(name + _SERIES, series)
            self._write(name + _ROWS, pa.Table.from_pylist([_record(row) for row in rows], schema=_ROW_SCHEMA))
        except BaseException:
            # Ctrl-C or a full disk stopped the writing: the end of the run tries again.
            self._waiting = rows + self._waiting
            raise

    def merge(self) -> None:
        """Joins all parts of this run to one: a long run has thousands.

        Raises
        ------
        OutputError
            The part cannot be written. Existing parts stay complete.
        """
        names = [f"{self._run}-{count:06d}" for count in range(1, self._count + 1)]
        for kind in (_SERIES, _ROWS):
            paths = [path for name in names if (path := self.parts / (name + kind)).exists()]
            if len(paths) > 1:
                merged = pa.concat_tables([pq.read_table(path) for path in paths], promote_options="default")
                # For a moment both the old parts and the new one have the rows; they are never missing.
                self._write(self._run + kind, merged.unify_dictionaries())
                for path in paths:
                    path.unlink()

    def _write(self, name: str, table: pa.Table) -> None:
        write_completely(self.parts / name, lambda path: pq.write_table(table, path))


def write_completely(path: Path, write: Callable[[Path], Any]) -> None:
    """Writes a file that gets its name when it is complete.

    Raises
    ------
    OutputError
        The file cannot be written. No part of it stays on the disk.
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
    """Asks the system to write the names of files to the disk. Windows and some network file systems cannot do this."""
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
    """A table of all series one after the other, with the key of their row."""
    tables = [
        pa.table({"key": pa.array([row.key] * length).dictionary_encode(), **row.series})
        for row in rows
        if (length := max(map(len, row.series.values()), default=0))
    ]
    return pa.concat_tables(tables, promote_options="default").unify_dictionaries() if tables else None


def read_statuses(folder: Path) -> dict[str, RowStatus]:
    """The statuses of the rows in a folder, by their keys; if two rows have one key, the better status.

    Numbers are not read, because each job of an array calls this, and there may be millions of rows.
    """
    statuses: dict[str, RowStatus] = {}
    for table in _part_tables(folder, _ROWS, columns=["key", "status", "time_limit"]):
        for key, status, limit in zip(*(table[name].to_pylist() for name in ("key", "status", "time_limit"))):
            if key not in statuses or statuses[key].status != "done":
                statuses[key] = RowStatus(status, limit)
    return statuses


def read_outcomes(folder: Path, keys: Container[str]) -> dict[str, Outcome]:
    """The rows with these keys; if two rows have one key, the better one."""
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
            # Other rows of this part may have other series, which are null here. A series of NaN is not null.
            names = [name for name in table.column_names if name != "key" and table[name].null_count < table.num_rows]
            frame: pd.DataFrame = table.select(names).to_pandas()
            return frame
    return None


def _part_tables(folder: Path, kind: str, **options: Any) -> Iterator[pa.Table]:
    """Tables of the parts; other runs may write and merge parts at the same time."""
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
                continue  # The part was merged since; the next round finds the merged part.
            except (pa.ArrowException, OSError) as error:
                reason = printable(str(error).splitlines()[0])
                log.warning("%s is left out, its rows are simulated again: %s", printable(str(path)), reason)
                continue
            yield table
