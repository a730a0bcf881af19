"""Runs a task on every point of a table."""

from __future__ import annotations

import uuid
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .._errors import RequestError
from .._progress import progress_callback
from .._sweep import Sweep
from .._text import printable
from ..types import Progress, StrPath, TableLike
from ._executors import open_executor
from ._guard import refuse_nested_run
from ._join import join_outcomes, run_table, write_tables
from ._points import read_points, select_shard
from ._queue import Queue, RerunRule
from ._results import Results
from ._store import Store, read_outcomes, read_statuses
from ._task import Function, prepare_task


def run(
    points: Sweep | StrPath | TableLike,
    task: Callable[..., object] | Function,
    *,
    results: StrPath,
    scheduler: object = None,
    workers: int | None = None,
    resume: bool = False,
    retry_failed: bool = False,
    time_limit: float | None = None,
    shard: str | None = None,
    progress: Progress = False,
) -> Results:
    """Runs a task on every model of a table, each in a process of its own that has OpenSim.

    Parameters
    ----------
    points : Sweep, path, DataFrame or list of dict
        The result of `ocs.sweep`, a table in CSV such as its manifest, or rows with a column `path`. In a file the column may also be
        `file`, and paths are relative to the table's folder.
    task : Drop, Stand, Function or callable
        The task for each model. See `Function` for functions of yours.
    results : path
        The folder for parts and tables.
    scheduler : optional
        None for Dask's `LocalCluster`; a scheduler's address; a `distributed.Client` or a cluster such as `dask_jobqueue.SLURMCluster`; any
        executor of `concurrent.futures`; or `"here"` for threads of this program, without Dask.
    workers : int, optional
        How many models are simulated at the same time on this machine; all cores by default.
    resume : bool, optional
        Continue in a folder that has results: rows whose key is there are kept.
    retry_failed : bool, optional
        With `resume`, simulate rows that failed or crashed again. Rows that were lost or refused, or that had a shorter time limit, are
        always simulated again.
    time_limit : float, optional
        Seconds after which the process of a model is ended.
    shard : str, optional
        `"2/8"`: only the second share of eight, for job arrays. Tables are only written by a call without `shard`.
    progress : bool or callable, optional
        Show a bar (if tqdm is installed), or call this function for each model with 1 and whether it failed.

    Returns
    -------
    Results
        A row for each point. If a model fails, its row has the error.

    Raises
    ------
    RequestError
        The call is wrong. Nothing was simulated.
    WorkersLost
        The scheduler or the workers ended. Finished rows are kept.
    OutputError
        Results cannot be written. Rows that are in parts already are kept.
    """
    refuse_nested_run()
    _refuse_numbers(time_limit, workers)
    selected = read_points(points)
    prepared_task = prepare_task(task)
    prepared_task.check_columns(selected[0].values)
    selected = select_shard(selected, shard)
    folder = Path(results).absolute()
    statuses = read_statuses(folder)
    if statuses and not resume:
        message = f"{printable(str(folder))} has results already: say resume=True to go on, or name another folder"
        raise RequestError("usage", message, keywords=("results", "resume"))
    run_id = uuid.uuid4().hex
    with (
        open_executor(scheduler, workers, run_id) as executor,
        progress_callback(progress, "simulate", len(selected)) as callback,
    ):
        store = Store(folder)
        rerun = RerunRule(failed=retry_failed, time_limit=time_limit)
        queue = Queue(run_id, executor, prepared_task, store, statuses, rerun, callback)
        try:
            queue.simulate(selected)
        finally:
            store.flush()
    store.merge()
    rows = read_outcomes(folder, set(queue.keys.values()))
    table = join_outcomes(selected, queue.keys, rows)
    runs = run_table(rows)
    if shard is None:
        write_tables(folder, table, runs)
    return Results(folder, table, runs)


def _refuse_numbers(time_limit: Any, workers: Any) -> None:
    if time_limit is not None and (isinstance(time_limit, (bool, str)) or not time_limit > 0):
        raise RequestError("usage", f"time_limit={time_limit!r}: expected seconds above 0", keywords=("time_limit",))
    if workers is not None and (isinstance(workers, bool) or not isinstance(workers, int) or workers < 1):
        raise RequestError("usage", f"workers={workers!r}: expected a whole number from 1", keywords=("workers",))
