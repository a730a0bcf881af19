"""Loads OpenSim and the task of the jobs in a server."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

from .. import _native
from ._job import Job, Versions


class Loaded:
    """OpenSim, if it is installed, and the last task."""

    def __init__(self) -> None:
        self.versions = Versions(_opensim_version(), _native.VERSION)
        self._bytes: bytes | None = None
        self._task: Callable[..., Any] | None = None
        self._error: BaseException | None = None

    def task(self, job: Job) -> Callable[..., Any] | None:
        """The task of a job; None if it cannot be loaded."""
        if job.task != self._bytes:
            self._bytes, self._task, self._error = job.task, None, None
            try:
                self._task = _load_task(job)
            except BaseException as error:
                # A module may end its process, too.
                self._error = error
        return self._task

    @property
    def error(self) -> BaseException | None:
        """Why the last task could not be loaded."""
        return self._error


def _opensim_version() -> str:
    """OpenSim's version; empty if it is not installed, because not every task needs it."""
    try:
        import opensim
    except ImportError:
        return ""
    # Otherwise OpenSim writes opensim.log into the folder of each task.
    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Error")
    return str(opensim.GetVersion())


def _load_task(job: Job) -> Callable[..., Any]:
    import cloudpickle

    # Modules of the program that started the run are found here, too, after those of the library.
    sys.path.extend(folder for folder in job.modules if folder not in sys.path)
    task: Callable[..., Any] = cloudpickle.loads(job.task)
    return task
