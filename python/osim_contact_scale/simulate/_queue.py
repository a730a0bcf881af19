"""Gives models to the workers and takes what comes back."""

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
from ._job import Job, Known, Outcome, Versions
from ._points import Point
from ._store import SOON, Store
from ._task import Task, base_of, key_of
from ._why import why

log = logging.getLogger("osim_contact_scale")

#: Models that are given to the workers ahead of their results: enough for thousands of workers, and no more memory for a million models.
AHEAD = 4000

#: What Dask says where a scheduler is gone.
_GONE = {"CommClosedError", "FutureCancelledError", "CancelledError"}


#: What we say where Dask writes about its own tasks and addresses.
_OF_DASK = {
    "KilledWorker": "the workers that had this model died one after the other: out of memory, or ended from outside"
}


class WorkersLost(ContactScaleError):
    """The scheduler or the pool of workers ended before the run did. What was done is kept: run again with `resume`."""


@dataclass(frozen=True)
class Again:
    """Which rows of an earlier run are done again."""

    failed: bool
    time_limit: float | None

    def __contains__(self, row: Known) -> bool:
        if row.status in ("lost", "refused"):
            return True
        if row.status == "time limit":
            return self.failed or self.time_limit is None or self.time_limit > (row.time_limit or 0)
        return self.failed and row.status != "done"


class Queue:
    """One run."""

    def __init__(
        self,
        run: str,
        executor: Executor,
        task: Task,
        store: Store,
        known: dict[str, Known],
        again: Again,
        callback: Callback,
    ) -> None:
        self._executor = executor
        self._task = task
        self._store = store
        self._known = known
        self._again = again
        self._callback = callback or (lambda count, failed: None)
        self.run = run
        self._pending: dict[Future[Outcome], tuple[str, Point]] = {}
        self._waiting: dict[str, int] = {}
        self._ready: queue.SimpleQueue[Future[Outcome]] = queue.SimpleQueue()
        #: The key of each row of the points.
        self.keys: dict[int, str] = {}
        self._done: set[str] = set()

    def do(self, points: Iterable[Point]) -> None:
        """Has every point simulated that is not known.

        Raises
        ------
        WorkersLost
            The workers ended.
        OutputError
            What came cannot be written.
        """
        try:
            self._do(points)
        except BaseException:
            # What was given to the workers and has not begun is not begun.
            for future in list(self._pending):
                future.cancel()
            raise

    def _do(self, points: Iterable[Point]) -> None:
        versions = self._versions()
        blob, modules = self._task.packed()
        base = base_of(self._task.identity, versions)
        for point in points:
            job = self._job(point, base, versions, blob, modules)
            if job is not None:
                self._submit(job, point)
            self._take(wait=len(self._pending) >= AHEAD)
        while self._pending:
            self._take(wait=True)

    def _versions(self) -> Versions:
        """Asked of a worker: this program may be without OpenSim."""
        try:
            return self._executor.submit(_worker.versions, self.run).result()
        except Exception as error:
            raise _lost(error) from error

    def _job(self, point: Point, base: str, versions: Versions, blob: bytes, modules: tuple[str, ...]) -> Job | None:
        """What is to do; None where the row is known, or coming."""
        values = self._task.values_of(point.values)
        try:
            digest = hashlib.sha256(Path(point.path).read_bytes()).hexdigest()
        except OSError as error:
            key = key_of(point.path, base, values)
            self._arrived(Outcome(key, "refused", f"the model cannot be read: {error.strerror}"), point, 1)
            self.keys[point.row] = key
            return None
        key = key_of(digest, base, values)
        self.keys[point.row] = key
        if key in self._waiting:
            self._waiting[key] += 1
            return None
        known = self._known.get(key)
        if known is not None and (key in self._done or known not in self._again):
            self._callback(1, known.status != "done")
            return None
        return Job(self.run, key, point.path, digest, values, blob, modules, versions, self._again.time_limit)

    def _submit(self, job: Job, point: Point) -> None:
        try:
            future = self._executor.submit(_worker.work, job)
        except (BrokenExecutor, RuntimeError) as error:
            raise _lost(error) from error
        self._pending[future] = job.key, point
        self._waiting[job.key] = 1
        future.add_done_callback(self._ready.put)

    def _take(self, wait: bool) -> None:
        """Takes what is ready; waits for a moment where there is nothing else to do."""
        try:
            future = self._ready.get(timeout=SOON if wait else 0)
        except queue.Empty:
            pass
        else:
            key, point = self._pending.pop(future)
            self._arrived(_outcome(future, key, self._again.time_limit), point, self._waiting.pop(key))
        if self._store.is_due():
            self._store.flush()

    def _arrived(self, outcome: Outcome, point: Point, count: int) -> None:
        self._store.add(outcome)
        self._known[outcome.key] = Known(outcome.status, outcome.time_limit)
        self._done.add(outcome.key)
        self._callback(count, outcome.status != "done")
        if outcome.status != "done":
            log.warning("%s: row %d, %s", outcome.status, point.row, point.said(printable(outcome.error or "")))


def _outcome(future: Future[Outcome], key: str, time_limit: float | None) -> Outcome:
    """What came.

    Raises
    ------
    WorkersLost
        It comes no more, and neither will the others.
    """
    try:
        return future.result()
    except (CancelledError, BrokenExecutor) as error:
        raise _lost(error) from error
    except Exception as error:
        if type(error).__name__ in _GONE:
            raise _lost(error) from error
        return Outcome(key, "lost", _OF_DASK.get(type(error).__name__) or why(error), time_limit=time_limit)


def _lost(error: BaseException) -> WorkersLost:
    text = printable(str(error).strip().splitlines()[0]) if str(error).strip() else type(error).__name__
    return WorkersLost("workers-lost", f"the workers are gone ({text}); what was done is kept: run again with resume")
