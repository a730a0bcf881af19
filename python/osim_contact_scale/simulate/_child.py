"""Runs the task of one model in the process of that model."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ._error_text import describe_error
from ._job import Job, Outcome, Value
from ._loaded import Loaded
from ._values import to_value


def simulate_job(job: Job, loaded: Loaded, folder: str) -> Outcome:
    """Runs the task on the model of a job."""
    refusal = _refusal_of_job(job, loaded)
    if refusal is not None:
        return Outcome(job.key, "refused", refusal)
    task = loaded.task(job)
    if task is None:
        reason = "" if loaded.error is None else f": {describe_error(loaded.error, folder)}"
        return Outcome(job.key, "failed", f"the task cannot be loaded here{reason}")
    begin = time.perf_counter()
    try:
        numbers, series = _numbers_and_series(task(job.path, **job.values))
    except BaseException as error:
        ended = "the task ended its process: " if isinstance(error, (KeyboardInterrupt, SystemExit)) else ""
        return Outcome(
            job.key, "failed", ended + describe_error(error, folder), task_seconds=time.perf_counter() - begin
        )
    return Outcome(job.key, "done", None, numbers, series, task_seconds=time.perf_counter() - begin)


def _refusal_of_job(job: Job, loaded: Loaded) -> str | None:
    """Why the job must not run here: its result would not belong to its key."""
    if loaded.versions != job.versions:
        here, there = loaded.versions, job.versions
        return (
            f"this worker has opensim {here.opensim or 'not at all'} and osim-contact-scale {here.package}, the others have "
            f"{there.opensim or 'none'} and {there.package}: results would differ; use one environment for all workers"
        )
    try:
        digest = hashlib.sha256(Path(job.path).read_bytes()).hexdigest()
    except OSError as error:
        return f"the model cannot be read here: {error.strerror}"
    return None if digest == job.digest else "the model was changed after this run had begun; run again with resume"


def _numbers_and_series(returned: Any) -> tuple[dict[str, Value], dict[str, list[float]]]:
    """The numbers and series that a task returned.

    Raises
    ------
    TypeError, ValueError
        The task returned something else.
    """
    expectation = "a task returns a dictionary of numbers, or that and a dictionary of series"
    numbers, series = returned if isinstance(returned, tuple) and len(returned) == 2 else (returned, {})
    if not isinstance(numbers, Mapping) or not isinstance(series, Mapping):
        raise TypeError(f"{expectation}, not {type(returned).__name__}")
    rows = {_column_name(name): _column_value(str(name), value) for name, value in numbers.items()}
    columns = {_column_name(name): [float(value) for value in values] for name, values in series.items()}
    if len({len(column) for column in columns.values()}) > 1:
        lengths = ", ".join(f"{name} {len(column)}" for name, column in columns.items())
        raise ValueError(f"series must be equally long: {lengths}")
    return rows, columns


def _column_name(name: Any) -> str:
    if not isinstance(name, str) or not name.isidentifier():
        raise ValueError(f"{name!r} cannot be the name of a column: use letters, digits and _, such as peak_force_n")
    return name


def _column_value(name: str, value: Any) -> Value:
    try:
        return to_value(value)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name} is {error}") from None
