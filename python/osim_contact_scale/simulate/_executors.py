"""Opens the executor of a run: Dask on this machine or a cluster, any executor of `concurrent.futures`, or threads of this program."""

from __future__ import annotations

import importlib
import importlib.util
import logging
import os
import sys
from collections.abc import Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from typing import Any

from .._errors import RequestError
from .._text import printable
from ._guard import refuse_unguarded
from ._worker import close_servers, end_servers

log = logging.getLogger("osim_contact_scale")

#: The value of `scheduler` for threads of this program, without Dask.
HERE = "here"


@contextmanager
def open_executor(scheduler: Any, workers: int | None, run: str) -> Iterator[Executor]:
    """A context with an executor.

    Raises
    ------
    RequestError
        `scheduler` is of a kind that `run` does not take, or Dask is not installed.
    OSError
        No scheduler answers at this address.
    """
    if isinstance(scheduler, Executor):
        _refuse_workers(workers)
        refuse_unguarded()
        yield scheduler
    elif scheduler == HERE:
        try:
            with ThreadPoolExecutor(workers or _core_count(), "simulate") as threads:
                try:
                    yield threads
                finally:
                    threads.shutdown(wait=False, cancel_futures=True)
                    # A thread that waits for a model ends with the model's process, also after Ctrl-C.
                    end_servers(run)
        finally:
            close_servers(run)
    else:
        with _client(scheduler, workers) as client:
            yield client.get_executor(pure=False)


@contextmanager
def _client(scheduler: Any, workers: int | None) -> Iterator[Any]:
    if importlib.util.find_spec("distributed") is None:
        message = 'Dask is not installed: pip install "dask[distributed]", or say scheduler="here" to do without'
        raise RequestError("usage", message, keywords=("scheduler",))
    # Dask's functions have no types.
    distributed: Any = importlib.import_module("distributed")
    if isinstance(scheduler, distributed.Client):
        _refuse_workers(workers)
        yield scheduler
        return
    with ExitStack() as stack:
        try:
            if scheduler is None:
                refuse_unguarded()
                scheduler = stack.enter_context(
                    distributed.LocalCluster(
                        n_workers=workers, threads_per_worker=1, dashboard_address=":0", silence_logs=logging.CRITICAL
                    )
                )
            elif isinstance(scheduler, (str, distributed.deploy.Cluster)):
                _refuse_workers(workers)
            else:
                raise _unknown_scheduler(scheduler)
            client = stack.enter_context(distributed.Client(scheduler))
        except (RuntimeError, OSError, ValueError) as error:
            if isinstance(error, RequestError):
                raise
            reason = printable(str(error).strip().splitlines()[0]) if str(error).strip() else type(error).__name__
            raise RequestError("usage", f"no workers of Dask: {reason}", keywords=("scheduler",)) from error
        _log_dashboard(client)
        yield client


def _unknown_scheduler(scheduler: Any) -> RequestError:
    kinds = f"None, an address, a client or cluster of Dask, an executor, or {HERE!r}"
    return RequestError("usage", f"scheduler is {type(scheduler).__name__}, expected {kinds}", keywords=("scheduler",))


def _core_count() -> int:
    """The number of cores that this program may use: a job on a cluster often may use only a few."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def _refuse_workers(workers: int | None) -> None:
    if workers is not None:
        raise RequestError(
            "usage", "workers is for this machine alone: what was given has its own", keywords=("workers",)
        )


def _log_dashboard(client: Any) -> None:
    """Logs the address of Dask's dashboard, which exists if bokeh is installed."""
    if importlib.util.find_spec("bokeh") is not None:
        log.info("Dask's dashboard: %s", client.dashboard_link)
