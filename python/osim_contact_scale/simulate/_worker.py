"""Passes the jobs of a worker to a separate process.

Workers of Dask may not have children of `multiprocessing`, which would also import the user's program again. The process is therefore
a plain program (`_server`). Each thread of a worker has one.
"""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import suppress

from . import _messages
from ._guard import RUN_VARIABLE
from ._job import Job, Outcome, Versions
from ._messages import encode, receive, send

_thread_local = threading.local()

#: Servers of this process, for the end of a run.
_servers: set[Server] = set()
#: Runs that have ended.
_ended_runs: set[str] = set()
_lock = threading.Lock()

#: Each model has one thread, because many models run at the same time.
_ONE_THREAD = dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"
)

#: Seconds that a server has to end its job.
_END_SECONDS = 5.0

#: Seconds that OpenSim may take to be imported, beyond the time limit of a job.
_START_SECONDS = 120.0


def work(job: Job) -> Outcome:
    """Simulates one model."""
    outcome = _server_of_thread(job.run).run_job(job) if _messages.CAN_FORK else _run_once(job)
    outcome.host = socket.gethostname()
    outcome.time_limit = job.time_limit
    return outcome


def versions(run: str) -> Versions:
    """The versions that are installed at this worker.

    Raises
    ------
    RuntimeError
        The process that simulates models does not start here.
    """
    if _messages.CAN_FORK:
        return _server_of_thread(run).versions
    with _start_server("--once", cwd=None) as process:
        assert process.stdout is not None
        received: Versions = receive(process.stdout.fileno())
        process.kill()
    return received


class Server:
    """The process that simulates models for this thread."""

    def __init__(self, run: str) -> None:
        self.run = run
        # The lock lasts until the process is registered, so that it ends with the run.
        with _lock:
            if run in _ended_runs:
                raise RuntimeError("the run was stopped")
            self._process = _start_server(cwd=tempfile.gettempdir())
            _servers.add(self)
        assert self._process.stdin is not None and self._process.stdout is not None
        self._to, self._from = self._process.stdin.fileno(), self._process.stdout.fileno()
        try:
            self.versions: Versions = receive(self._from)
        except EOFError:
            self._process.wait()
            raise RuntimeError(
                f"{sys.executable} -m osim_contact_scale.simulate._server does not start on {socket.gethostname()} "
                f"(exit status {self._process.returncode}): run it there by hand to see why"
            ) from None

    def run_job(self, job: Job) -> Outcome:
        """Simulates one model in the process."""
        try:
            send(self._to, job)
            outcome: Outcome = receive(self._from)
        except (EOFError, OSError):
            # The server itself was killed, and its copy with it: the next job gets a new server.
            self.close()
            return Outcome(job.key, "lost", "the process that runs models was ended from outside")
        return outcome

    @property
    def is_alive(self) -> bool:
        """Whether the process runs."""
        return self._process.poll() is None

    def end(self) -> None:
        """Ends the process and its job, without waiting for the outcome."""
        self._process.terminate()

    def close(self) -> None:
        """Ends the process and closes its pipes."""
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                with suppress(OSError):
                    pipe.close()
        with _lock:
            _servers.discard(self)
        # The process ends with its input, and is killed if it does not.
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(_END_SECONDS)
        self._process.kill()
        self._process.wait()


def _server_of_thread(run: str) -> Server:
    """The server of this thread for this run."""
    server: Server | None = getattr(_thread_local, "server", None)
    if server is not None and (server.run != run or not server.is_alive):
        server.close()
        server = None
    if server is None:
        _thread_local.server = server = Server(run)
    return server


def end_servers(run: str) -> None:
    """Ends all servers of a run in this process; the run can start no others."""
    with _lock:
        _ended_runs.add(run)
        for server in list(_servers):
            if server.run == run:
                server.end()


def close_servers(run: str) -> None:
    """Closes the servers of a run that has ended, after all threads have stopped waiting for them."""
    for server in [server for server in _servers if server.run == run]:
        server.close()


def _start_server(*arguments: str, cwd: str | None) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-m", "osim_contact_scale.simulate._server", *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        bufsize=0,
        cwd=cwd,
        env={**os.environ, **_ONE_THREAD, RUN_VARIABLE: "1"},
        # Ctrl-C reaches only the program that waits; this process ends with its input.
        start_new_session=_messages.CAN_FORK,
    )


def _run_once(job: Job) -> Outcome:
    """Simulates one model in a new process, which imports OpenSim: for systems that cannot copy a process."""
    folder = tempfile.mkdtemp(prefix="osim-contact-scale-")
    begin = time.perf_counter()
    limit = None if job.time_limit is None else job.time_limit + _START_SECONDS
    try:
        with _start_server("--once", cwd=folder) as process:
            try:
                out, _ = process.communicate(encode(job), timeout=limit)
            except subprocess.TimeoutExpired:
                process.kill()
                return Outcome(job.key, "time limit", f"it did not end within {job.time_limit:g} s")
            pieces = _messages.MessageBuffer(out)
            if pieces.is_complete():
                pieces.take_message()  # The first message has the versions.
            if pieces.is_complete():
                outcome: Outcome = pieces.take_message()
            else:
                outcome = Outcome(job.key, "crashed", f"its process died: exit status {process.returncode}")
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    outcome.process_seconds = time.perf_counter() - begin
    return outcome
