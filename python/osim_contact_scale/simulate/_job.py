"""A model to simulate and its outcome, as messages to and from a worker."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

#: How a run of a model ended.
#:
#: `done`: the task returned. `failed`: it raised an error, or returned something that cannot be a row. `crashed`: its process died.
#: `time limit`: its process was ended. `lost`: each worker that tried it died. `refused`: it was not started.
Status = Literal["done", "failed", "crashed", "time limit", "lost", "refused"]

#: Columns of a table of results that come neither from the points nor from the task.
RESULT_COLUMNS = ("key", "status", "error")

Value = float | int | str | bool | None


@dataclass(frozen=True)
class Versions:
    """Versions of the programs that results depend on."""

    opensim: str
    package: str


@dataclass(frozen=True)
class Job:
    """A model and the task to run on it."""

    #: The run that it belongs to. Runs do not share processes, because the second run may have another version of a module.
    run: str
    key: str
    path: str
    #: SHA-256 of the model's bytes at the time when the key was made.
    digest: str
    values: Mapping[str, Any]
    #: The task by cloudpickle, and where Python looks for its modules.
    task: bytes
    modules: tuple[str, ...]
    versions: Versions
    #: Seconds.
    time_limit: float | None


class RowStatus(NamedTuple):
    """The status of a row in this run or an earlier one."""

    status: Status
    time_limit: float | None


@dataclass(slots=True)
class Outcome:
    """The outcome of a job."""

    key: str
    status: Status
    error: str | None = None
    numbers: dict[str, Value] = field(default_factory=dict)
    series: dict[str, list[float]] = field(default_factory=dict)
    #: Duration of the task alone, and of its process from its start to its end; in s.
    task_seconds: float | None = None
    process_seconds: float | None = None
    #: The most memory that the process had; in MB.
    memory_mb: float | None = None
    host: str | None = None
    time_limit: float | None = None
