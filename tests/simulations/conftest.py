"""Fixtures of the tests of simulations: a table of our models, and workers for all tests."""

import os
import shutil
import signal
import subprocess
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

# A run in the background ignores Ctrl-C, and so would the programs that tests interrupt.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

TOP = Path(__file__).resolve().parents[2]
FIXTURES = TOP / "fixtures"
HUMAN = FIXTURES / "table1" / "human_62kg_smooth_sphere.osim"
HERE = Path(__file__).resolve().parent


def models(folder, count):
    """Models that differ in their name, so that no two are the same bytes: rows of a table of points."""
    folder.mkdir(exist_ok=True)
    text = HUMAN.read_text()
    rows = []
    for index in range(1, count + 1):
        path = folder / f"model_{index:05d}.osim"
        path.write_text(text.replace('name="human_62kg"', f'name="human_{index}"'))
        rows.append({"path": str(path), "index": index})
    assert count < 2 or Path(rows[0]["path"]).read_text() != Path(rows[1]["path"]).read_text()
    return rows


@pytest.fixture
def points(tmp_path):
    """Returns a function that makes a table of `count` models."""
    return lambda count: models(tmp_path / "models", count)


@pytest.fixture(scope="session")
def client():
    """A client with two Dask workers, shared by all tests that do not kill workers."""
    import distributed

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


@contextmanager
def programs():
    """A function that starts programs; after the test they are ended with all their child processes."""
    running = []

    def start(*words, **options):
        paths = [str(HERE), *filter(None, [os.environ.get("PYTHONPATH")])]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths), **options.pop("env", {})}
        process = subprocess.Popen(
            [sys.executable, *map(str, words)], start_new_session=True, env=environment, text=True, **options
        )
        running.append(process)
        return process

    try:
        yield start
    finally:
        for process in running:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()


@pytest.fixture
def start():
    with programs() as start:
        yield start


def wait_for(condition, seconds=60):
    """Until something is true.

    Raises
    ------
    AssertionError
        It is not, after so many seconds.
    """
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if condition():
            return
        time.sleep(0.02)
    raise AssertionError("it did not happen")


def processes(word):
    """Numbers of the processes with this word in their command line."""
    result = []
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal():
            try:
                if word in (folder / "cmdline").read_bytes().decode(errors="replace"):
                    result.append(int(folder.name))
            except OSError:
                pass
    return result


def script(folder, text):
    """A program in a folder of its own."""
    path = folder / "program.py"
    path.write_text(text)
    return path


def table_bytes(folder):
    """The bytes of the tables at the end of a run."""
    return (folder / "table.csv").read_bytes(), (folder / "table.parquet").read_bytes()


needs_unshare = pytest.mark.skipif(
    sys.platform != "linux" or shutil.which("unshare") is None or os.geteuid() != 0,
    reason="a full disk: some systems let nobody but root mount a small disk",
)
