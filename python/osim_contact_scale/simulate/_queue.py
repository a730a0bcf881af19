"""Sends models to the workers and stores their outcomes."""

from __future__ import annotations

import hashlib
import logging
import queue
from collections.abc import Iterable
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future
from dataclasses import dataclass
from pathlib import Path

from .._errors import ContactScaleError
from .._progress import Callback
from .._text import printable
from . import _worker
from ._error_text import describe_error
from ._job import Job, Outcome, RowStatus, Versions
from ._points import Point
from ._store import FLUSH_SECONDS, Store
from ._task import Task, base_key, row_key

log = logging.getLogger("osim_contact_scale")

#: Models that are sent to the workers ahead of their results: enough for thousands of workers, and a limit of memory.
AHEAD = 4000

#: Names of Dask's exceptions if the scheduler is lost.
_LOST_ERRORS = {"CommClosedError", "FutureCancelledError", "CancelledError"}


#: Messages instead of Dask's messages, which are about its tasks and addresses.
_DASK_MESSAGES = {
    "KilledWorker": "the workers that had this model died one after the other: out of memory, or ended from outside"
}


class WorkersLost(ContactScaleError):
    """The scheduler or the workers ended before the run did. Finished rows are kept: run again with `resume`."""


@dataclass(frozen=True)
class RerunRule:
    """Says which rows of an earlier run are simulated again."""

    failed: bool
    time_limit: float | None

    def __contains__(self, row: RowStatus) -> bool:
        if row.status in ("lost", "refused"):
            return True
        if row.status == "time limit":
            return self.failed or self.time_limit is None or self.time_limit > (row.time_limit or 0)
        return self.failed and row.status != "done"


class Queue:
    """The models of one run that wait, run or are finished."""

    def __init__(
        self,
        run: str,
        executor: Executor,
        task: Task,
        store: Store,
        statuses: dict[str, RowStatus],
        rerun: RerunRule,
        callback: Callback,
    ) -> None:
        self._executor = executor
        self._task = task
        self._store = store
        self._statuses = statuses
        self._rerun = rerun
        self._callback = callback or (lambda count, failed: None)
        self.run = run
        self._pending: dict[Future[Outcome], tuple[str, Point]] = {}
        self._waiting: dict[str, int] = {}
        self._ready: queue.SimpleQueue[Future[Outcome]] = queue.SimpleQueue()
        #: The key of each row of the points.
        self.keys: dict[int, str] = {}
        self._done_keys: set[str] = set()

    def simulate(self, points: Iterable[Point]) -> None:
        """Simulates every point that has no outcome yet.

        Raises
        ------
        WorkersLost
            The workers ended.
        OutputError
            Outcomes cannot be written.
        """
        try:
            self._simulate(points)
        except BaseException:
            # Jobs that no worker has begun are cancelled.
            for future in list(self._pending):
                future.cancel()
            raise

    def _simulate(self, points: Iterable[Point]) -> None:
        versions = self._versions()
        blob, modules = self._task.pickled()
        base = base_key(self._task.identity, versions)
        for point in points:
            job = self._job(point, base, versions, blob, modules)
            if job is not None:
                self._submit(job, point)
            self._take_ready(wait=len(self._pending) >= AHEAD)
        while self._pending:
            self._take_ready(wait=True)

    def _versions(self) -> Versions:
        """The versions at a worker, because this program may not have OpenSim."""
        try:
            return self._executor.submit(_worker.versions, self.run).result()
        except Exception as error:
            raise _workers_lost(error) from error

    def _job(self, point: Point, base: str, versions: Versions, blob: bytes, modules: tuple[str, ...]) -> Job | None:
        """The job of a point; None if its row has an outcome or is running."""
        values = self._task.arguments(point.values)
        try:
            digest = hashlib.sha256(Path(point.path).read_bytes()).hexdigest()
        except OSError as error:
            key = row_key(point.path, base, values)
            self._record_outcome(Outcome(key, "refused", f"the model cannot be read: {error.strerror}"), point, 1)
            self.keys[point.row] = key
            return None
        key = row_key(digest, base, values)
        self.keys[point.row] = key
        if key in self._waiting:
            self._waiting[key] += 1
            return None
        status = self._statuses.get(key)
        if status is not None and (key in self._done_keys or status not in self._rerun):
            self._callback(1, status.status != "done")
            return None
        return Job(self.run, key, point.path, digest, values, blob, modules, versions, self._rerun.time_limit)

    def _submit(self, job: Job, point: Point) -> None:
        try:
            future = self._executor.submit(_worker.work, job)
        except (BrokenExecutor, RuntimeError) as error:
            raise _workers_lost(error) from error
        self._pending[future] = job.key, point
        self._waiting[job.key] = 1
        future.add_done_callback(self._ready.put)

    def _take_ready(self, wait: bool) -> None:
        """Stores an outcome that is ready; with `wait`, waits a moment for one."""
        try:
            future = self._ready.get(timeout=FLUSH_SECONDS if wait else 0)
        except queue.Empty:
            pass
        else:
            key, point = self._pending.pop(future)
            self._record_outcome(_future_outcome(future, key, self._rerun.time_limit), point, self._waiting.pop(key))
        if self._store.is_due():
            self._store.flush()

    def _record_outcome(self, outcome: Outcome, point: Point, count: int) -> None:
        self._store.add(outcome)
        self._statuses[outcome.key] = RowStatus(outcome.status, outcome.time_limit)
        self._done_keys.add(outcome.key)
        self._callback(count, outcome.status != "done")
        if outcome.status != "done":
            log.warning(
                "%s: row %d, %s", outcome.status, point.row, point.with_file_name(printable(outcome.error or ""))
            )


def _future_outcome(future: Future[Outcome], key: str, time_limit: float | None) -> Outcome:
    """The outcome of a future.

    Raises
    ------
    WorkersLost
        The workers are gone, so that no outcome will come.
    """
    try:
        return future.result()
    except (CancelledError, BrokenExecutor) as error:
        raise _workers_lost(error) from error
    except Exception as error:
        if type(error).__name__ in _LOST_ERRORS:
            raise _workers_lost(error) from error
        return Outcome(
            key, "lost", _DASK_MESSAGES.get(type(error).__name__) or describe_error(error), time_limit=time_limit
        )


def _workers_lost(error: BaseException) -> WorkersLost:
    text = printable(str(error).strip().splitlines()[0]) if str(error).strip() else type(error).__name__
    return WorkersLost("workers-lost", f"the workers are gone ({text}); what was done is kept: run again with resume")
