"""The process that simulates the models of a worker: `python -m osim_contact_scale.simulate._server`

It imports OpenSim once, and copies itself for each job (fork), so that a model cannot change OpenSim's state for the next one, and a
crash only ends its own copy. It reads jobs from the standard input and writes outcomes to the standard output. At the end of the input
it ends itself and a running job, so that nothing keeps running when a worker is killed.

With `--once` it does one job itself and ends, for systems that cannot copy a process.
"""

from __future__ import annotations

import os
import selectors
import shutil
import signal
import sys
import tempfile
import time
from contextlib import suppress

from .._text import printable
from ._child import simulate_job
from ._error_text import describe_error
from ._job import Job, Outcome
from ._loaded import Loaded
from ._messages import MessageBuffer, receive, send

#: Seconds between two looks whether a process has died whose pipe another process keeps open.
_POLL_SECONDS = 0.2


def main(arguments: list[str]) -> None:
    """Does jobs until the input ends."""
    # After SIGTERM a running job is ended and its folder removed.
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(0))
    requests, answers = _take_pipes()
    loaded = Loaded()
    send(answers, loaded.versions)
    with suppress(EOFError, OSError):
        if arguments == ["--once"]:
            _run_only_job(requests, answers, loaded)
            return
        while True:
            job: Job = receive(requests)
            send(answers, _run_in_copy(job, loaded, requests, answers))


def _take_pipes() -> tuple[int, int]:
    """Moves the two pipes to other descriptors, so that the output of a library does not mix with the messages."""
    requests, answers = os.dup(0), os.dup(1)
    nothing = os.open(os.devnull, os.O_RDWR)
    os.dup2(nothing, 0)
    os.dup2(nothing, 1)
    os.close(nothing)
    return requests, answers


def _run_only_job(requests: int, answers: int, loaded: Loaded) -> None:
    job: Job = receive(requests)
    begin = time.perf_counter()
    # The worker removes the folder, because this process is in it or may be ended.
    outcome = simulate_job(job, loaded, folder=os.getcwd())
    outcome.process_seconds = time.perf_counter() - begin
    send(answers, outcome)


def _run_in_copy(job: Job, loaded: Loaded, requests: int, answers: int) -> Outcome:
    """Does a job in a copy of this process."""
    # The task is loaded here, so that every copy has it and its modules already.
    loaded.task(job)
    try:
        folder = tempfile.mkdtemp(prefix="osim-contact-scale-")
    except OSError as error:
        return Outcome(job.key, "refused", f"no temporary folder can be made: {error.strerror}")
    begin = time.perf_counter()
    try:
        outcome = _run_watched(job, loaded, folder, requests, answers)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    outcome.process_seconds = time.perf_counter() - begin
    return outcome


def _run_watched(job: Job, loaded: Loaded, folder: str, requests: int, answers: int) -> Outcome:
    reading, writing = os.pipe()
    parent = os.getpid()
    child = os.fork()
    if child == 0:
        _run_as_copy(job, loaded, folder, (requests, reading, answers), writing, parent)
    os.close(writing)
    # The copy makes this call, too. One of the two calls comes first, and both come before the copy is ended.
    with suppress(OSError):
        os.setpgid(child, child)
    try:
        pieces, ended_by = _wait_for_outcome(child, reading, requests, job.time_limit)
    finally:
        os.close(reading)
        # The whole group is ended, with programs that the task started. The group may outlive the child.
        for end in (os.killpg, os.kill):
            with suppress(ProcessLookupError, PermissionError):
                end(child, signal.SIGKILL)
        _, status, usage = os.wait4(child, 0)
    if ended_by == "input":
        sys.exit(0)
    if pieces.is_complete():
        outcome = _read_outcome(job, pieces)
    elif ended_by == "time limit":
        outcome = Outcome(job.key, "time limit", f"it did not end within {job.time_limit:g} s")
    else:
        outcome = Outcome(job.key, "crashed", f"its process died: {_exit_text(status)}{_last_line(folder)}")
    # Linux counts in kilobytes, macOS in bytes.
    outcome.memory_mb = usage.ru_maxrss / (1e6 if sys.platform == "darwin" else 1e3)
    return outcome


def _read_outcome(job: Job, pieces: MessageBuffer) -> Outcome:
    try:
        outcome: Outcome = pieces.take_message()
    except Exception:
        # Two processes wrote into the pipe: the task copied itself, and both went on.
        return Outcome(job.key, "crashed", "its answer cannot be read: did the task copy its process?")
    return outcome


def _wait_for_outcome(child: int, reading: int, requests: int, limit: float | None) -> tuple[MessageBuffer, str]:
    """Waits for the outcome or the end of a child, and says which came: `outcome`, `death`, `time limit` or `input`."""
    pieces = MessageBuffer()
    until = None if limit is None else time.monotonic() + limit
    with selectors.DefaultSelector() as selector:
        selector.register(reading, selectors.EVENT_READ)
        selector.register(requests, selectors.EVENT_READ)
        while True:
            timeout = _POLL_SECONDS if until is None else max(0.0, min(_POLL_SECONDS, until - time.monotonic()))
            ready = {key.fd for key, _ in selector.select(timeout)}
            if reading in ready:
                piece = os.read(reading, 1 << 20)
                pieces.add(piece)
                if pieces.is_complete():
                    return pieces, "outcome"
                if not piece:
                    return pieces, "death"
            elif requests in ready:
                # A worker sends no job before it has an answer: its pipe was closed.
                return pieces, "input"
            elif os.waitid(os.P_PID, child, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None:
                return pieces, _read_remaining(selector, reading, pieces)
            if until is not None and time.monotonic() >= until:
                return pieces, "time limit"


def _read_remaining(selector: selectors.BaseSelector, reading: int, pieces: MessageBuffer) -> str:
    """Reads what a copy that has ended left in its pipe, without waiting: another process may keep the pipe open."""
    while reading in {key.fd for key, _ in selector.select(0)}:
        piece = os.read(reading, 1 << 20)
        pieces.add(piece)
        if pieces.is_complete():
            return "outcome"
        if not piece:
            break
    return "death"


def _run_as_copy(job: Job, loaded: Loaded, folder: str, others: tuple[int, ...], writing: int, parent: int) -> None:
    """Does the job and ends, whatever happens."""
    try:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        os.setpgid(0, 0)
        _die_with_parent(parent)
        for descriptor in others:
            os.close(descriptor)
        printed = os.open(os.path.join(folder, _PRINTED), os.O_WRONLY | os.O_CREAT | os.O_APPEND)
        os.dup2(printed, 1)
        os.dup2(printed, 2)
        work = os.path.join(folder, "work")
        os.mkdir(work)
        os.chdir(work)
        send(writing, simulate_job(job, loaded, folder=work))
    except BaseException as error:
        with suppress(OSError):
            send(writing, Outcome(job.key, "failed", describe_error(error, folder)))
    finally:
        # sys.exit() would run what the server registered for its own end.
        os._exit(0)


#: The file with the printed output of a job, beside the job's folder.
_PRINTED = "printed.txt"


def _die_with_parent(parent: int) -> None:
    """Asks Linux to end the copy with its server, also if the server is killed; other systems let the copy finish."""
    if sys.platform == "linux":
        import ctypes

        PR_SET_PDEATHSIG = 1
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:
            os._exit(0)


def _exit_text(status: int) -> str:
    code = os.waitstatus_to_exitcode(status)
    if code >= 0:
        return f"exit status {code}"
    try:
        return f"signal {-code} ({signal.Signals(-code).name})"
    except ValueError:
        return f"signal {-code}"


def _last_line(folder: str) -> str:
    """The last line that a job printed."""
    try:
        with open(os.path.join(folder, _PRINTED), errors="replace") as file:
            lines = [line.strip() for line in file.read()[-4096:].splitlines() if line.strip()]
    except OSError:
        return ""
    return f"; it last printed: {printable(lines[-1][:500])}" if lines else ""


if __name__ == "__main__":
    main(sys.argv[1:])
