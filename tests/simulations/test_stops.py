"""If any process is killed, no written row is lost, and `resume` gives the same table."""

import os
import signal
import socket
import subprocess
import threading
import time

import osim_contact_scale as ocs
import pyarrow.parquet as pq
import pytest
import tasks
from conftest import models, needs_unshare, processes, script, table_bytes, wait_for
from osim_contact_scale import simulate

COUNT = 24

PROGRAM = """
import json, sys
import tasks
from osim_contact_scale import simulate

rows, folder, results, scheduler = json.loads(sys.argv[1])
if __name__ == "__main__":
    task = simulate.Function(tasks.marks, {"folder": folder, "seconds": 0.25})
    done = simulate.run(rows, task, results=results, scheduler=scheduler, resume=True)
    print(len(done.failures))
"""


class Case:
    """A table of points, a folder for marks of the task, and the tables of an uninterrupted run."""

    def __init__(self, folder, client):
        self.folder = folder
        self.rows = models(folder / "models", COUNT)
        self.marks = folder / "marks"
        self.marks.mkdir()
        self.task = simulate.Function(tasks.marks, {"folder": str(self.marks), "seconds": 0.25})
        self.quick = folder / "marks.quick"
        self.quick.touch()
        simulate.run(self.rows, self.task, results=folder / "whole", scheduler=client)
        self.quick.unlink()
        for mark in self.marks.iterdir():
            mark.unlink()
        self.results = folder / "results"

    def words(self, scheduler):
        import json

        return json.dumps([self.rows, str(self.marks), str(self.results), scheduler])

    def marked(self, count):
        return lambda: len(list(self.marks.iterdir())) >= count

    def written(self):
        """Keys of the rows in complete part files."""
        return set(simulate._store.read_statuses(self.results))

    def finish(self, client):
        """Resumes the run, and compares its tables with those of an uninterrupted run."""
        self.quick.touch()
        before = self.written()
        marks = set(self.marks.iterdir())
        results = simulate.run(self.rows, self.task, results=self.results, scheduler=client, resume=True)
        # All but what was written was done again: by indices, as a row that was being done at the stop leaves its mark late.
        second = {int(mark.name.split(".")[0]) for mark in set(self.marks.iterdir()) - marks}
        assert second == {
            row["index"] for row, key in zip(self.rows, results.table["key"], strict=True) if key not in before
        }
        assert table_bytes(self.results) == table_bytes(self.folder / "whole")
        assert [list(results.series(place)["index_back"]) for place in (0, COUNT - 1)] == [[1, 1], [COUNT, COUNT]]
        return before


@pytest.fixture
def case(tmp_path, client):
    import osim_contact_scale.simulate._store  # noqa: F401

    return Case(tmp_path, client)


def test_a_worker_is_killed(case):
    import distributed

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", silence_logs=50) as cluster,
        distributed.Client(cluster) as client,
    ):

        def kill():
            wait_for(case.marked(4))
            for pid in client.run(os.getpid).values():
                os.kill(pid, signal.SIGKILL)
                break

        killer = threading.Thread(target=kill)
        killer.start()
        results = simulate.run(case.rows, case.task, results=case.results, scheduler=client)
        killer.join()
    assert not len(results.failures)
    assert table_bytes(case.results) == table_bytes(case.folder / "whole")


def test_the_scheduler_is_killed(case, client, start, tmp_path):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"
    scheduler = start(
        "-m", "distributed.cli.dask_scheduler", "--port", port, "--no-dashboard", stderr=subprocess.DEVNULL
    )
    start("-m", "distributed.cli.dask_worker", address, "--nthreads", 1, "--no-dashboard", stderr=subprocess.DEVNULL)
    program = start(script(tmp_path, PROGRAM), case.words(address), stderr=subprocess.PIPE)
    wait_for(case.marked(6))
    os.kill(scheduler.pid, signal.SIGKILL)
    _, output = program.communicate(timeout=60)
    assert program.returncode != 0
    assert "WorkersLost: the workers are gone" in output.splitlines()[-1]
    assert len(case.finish(client)) >= 4


def session_of(pid):
    """The session of a process; None if it has just ended."""
    try:
        return os.getsid(pid)
    except ProcessLookupError:
        return None


def test_the_program_is_killed(case, client, start, tmp_path):
    program = start(script(tmp_path, PROGRAM), case.words("here"))
    wait_for(case.marked(12))
    os.kill(program.pid, signal.SIGKILL)
    program.wait()
    # The processes of the models end with it.
    wait_for(lambda: not [pid for pid in processes("simulate._server") if session_of(pid) == program.pid], 10)
    assert len(case.finish(client)) >= 4


def test_ctrl_c_keeps_what_was_done(case, client, start, tmp_path):
    program = start(script(tmp_path, PROGRAM), case.words("here"), stderr=subprocess.PIPE)
    wait_for(case.marked(12))
    begin = time.monotonic()
    os.kill(program.pid, signal.SIGINT)
    _, output = program.communicate(timeout=30)
    assert time.monotonic() - begin < 10
    assert program.returncode != 0 and output.splitlines()[-1] == "KeyboardInterrupt"
    assert len(case.finish(client)) >= 8


def test_who_reads_along_sees_whole_parts(case):
    visited, wrong = set(), []
    ended = threading.Event()

    def read():
        while not ended.is_set():
            for path in case.results.glob("parts/*.parquet"):
                try:
                    visited.update(pq.read_table(path, columns=["key"])["key"].to_pylist())
                except FileNotFoundError:
                    pass  # Merged with others since.
                except Exception as error:
                    wrong.append(error)

    reader = threading.Thread(target=read)
    reader.start()
    results = simulate.run(case.rows, case.task, results=case.results, scheduler="here", workers=2)
    ended.set()
    reader.join()
    assert not wrong
    assert 0 < len(visited & set(results.table["key"])) == len(visited)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_models_that_run_end_with_the_program(case, start, tmp_path, number):
    """This holds for models of any duration, and for the programs that their tasks started."""
    text = PROGRAM.replace('"seconds": 0.25', '"seconds": 600').replace("import json, sys", "import json, signal, sys")
    text = text.replace("rows, folder", "signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))\nrows, folder")
    program = start(script(tmp_path, text), case.words("here"), stderr=subprocess.DEVNULL)
    wait_for(case.marked(2))
    os.kill(program.pid, number)
    program.wait(timeout=20)
    wait_for(lambda: not [pid for pid in processes("simulate._server") if session_of(pid) == program.pid], 10)


def test_what_was_not_begun_is_taken_back(case, client):
    """A notebook's workers are free for the next call after an interruption."""
    pool = client.get_executor(pure=False)

    def interrupt(count, failed):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        simulate.run(case.rows, case.task, results=case.results, scheduler=pool, progress=interrupt)
    time.sleep(2)
    assert len(list(case.marks.iterdir())) < COUNT - 8


def test_a_part_that_was_damaged_is_done_again(case, client, caplog):
    simulate.run(case.rows[:8], case.task, results=case.results, scheduler=client)
    simulate.run(case.rows, case.task, results=case.results, scheduler=client, resume=True)
    first = min(case.results.glob("parts/*.rows.parquet"))
    first.write_bytes(first.read_bytes()[:100])
    marks = len(list(case.marks.iterdir()))
    simulate.run(case.rows, case.task, results=case.results, scheduler=client, resume=True)
    assert len(list(case.marks.iterdir())) - marks == 8
    assert "is left out, its rows are simulated again" in caplog.text
    assert table_bytes(case.results) == table_bytes(case.folder / "whole")


def test_a_time_limit_that_is_over_at_once(tmp_path, points):
    rows = points(6)
    task = simulate.Function(tasks.by_index, {"spoil": {str(index): "endless" for index in range(1, 7)}})
    results = simulate.run(rows, task, results=tmp_path / "r", scheduler="here", workers=2, time_limit=1e-9)
    assert set(results.table["status"]) == {"time limit"}


@needs_unshare
def test_the_disk_is_full(case, client):
    """A disk of its own for the results, with hardly any room; what is on it is there when it has grown."""
    case.results.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=12k", "none", case.results], check=True)
    try:
        with pytest.raises(ocs.OutputError, match=r"No space left on device.*run again with resume"):
            simulate.run(case.rows, case.task, results=case.results, scheduler=client)
        kept = case.written()
        assert 0 < len(kept) < COUNT
        subprocess.run(["mount", "-o", "remount,size=20m", case.results], check=True)
        assert case.finish(client) == kept
    finally:
        subprocess.run(["umount", case.results], check=True)


def test_time_limits_that_are_longer_are_tried_again(tmp_path, points, client):
    rows = points(2)
    marks = tmp_path / "marks"
    marks.mkdir()
    task = simulate.Function(tasks.marks, {"folder": str(marks), "seconds": 1.5})

    def statuses(limit, **more):
        results = simulate.run(
            rows, task, results=tmp_path / "r", scheduler=client, resume=True, time_limit=limit, **more
        )
        return list(results.table["status"]), len(list(marks.iterdir()))

    assert statuses(0.5) == (["time limit"] * 2, 2)
    assert statuses(0.5) == (["time limit"] * 2, 2)
    assert statuses(0.5, retry_failed=True) == (["time limit"] * 2, 4)
    assert statuses(30) == (["done"] * 2, 6)


def test_a_stop_in_the_middle_of_writing_loses_no_row(tmp_path, monkeypatch):
    from osim_contact_scale.simulate import _store
    from osim_contact_scale.simulate._job import Outcome

    store = _store.Store(tmp_path)
    store.add(Outcome("a", "done", numbers={"x": 1.0}, series={"time_s": [0.0]}))
    real_replace, calls = os.replace, []

    def interrupted(*paths):
        calls.append(paths)
        if len(calls) == 2:
            raise KeyboardInterrupt
        real_replace(*paths)

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        store.flush()
    assert _store.read_statuses(tmp_path) == {}
    store.flush()
    assert list(_store.read_statuses(tmp_path)) == ["a"]
    assert list(_store.read_series(tmp_path, "a")["time_s"]) == [0.0]
    assert not list(tmp_path.rglob("*.partial"))
