"""Results of `run`: rows, values, series, errors, and a process for each model."""

import hashlib
import os
import re
import time
from concurrent.futures import ProcessPoolExecutor

import osim_contact_scale as ocs
import pandas as pd
import pytest
import tasks
from conftest import HUMAN, models
from osim_contact_scale import simulate
from osim_contact_scale.simulate._task import prepare_task


def test_a_sweep_is_simulated_row_by_row(tmp_path, client):
    points = ocs.sweep(HUMAN, grid={"stiffness": [1e5, 1e6], "dissipation": [0.5, 1]}, output_dir=tmp_path / "a.sweep")
    results = simulate.run(points, tasks.size, results=tmp_path / "results", scheduler=client)
    table = results.table
    assert list(table["status"]) == ["done"] * 4
    assert list(table["file"]) == list(points.table["file"])
    assert list(table["stiffness_n_m2"]) == [1e5, 1e5, 1e6, 1e6]
    assert list(table["scaled"]) == [4.0] * 4
    assert list(table["size_bytes"]) == [os.path.getsize(path) for path in points.table["path"]]
    for name, read in (("table.csv", pd.read_csv), ("table.parquet", pd.read_parquet)):
        second = read(results.folder / name)
        assert list(second.columns) == list(table.columns)
        assert list(second["size_bytes"]) == list(table["size_bytes"])
    # The manifest's file says the same.
    same = simulate.run(points.manifest, tasks.size, results=tmp_path / "same", scheduler=client)
    assert list(same.table["key"]) == list(table["key"])


def test_each_model_has_a_process_of_its_own(tmp_path, points, client):
    table = simulate.run(points(6), tasks.process, results=tmp_path / "r", scheduler=client).table
    assert table["pid"].nunique() == 6
    assert not table["left_by_another"].any()
    assert not table["files"].any()


def test_series_lie_beside(tmp_path, points, client):
    results = simulate.run(points(3), tasks.series, results=tmp_path / "r", scheduler=client)
    for place, key in enumerate(results.table["key"]):
        series = results.series(place)
        assert list(series.columns) == ["time_s", "force_n"]
        assert list(series["force_n"]) == [0.0, place + 1.0, 3.0]
        assert results.series(key).equals(series)
    with pytest.raises(ocs.RequestError, match="no series"):
        results.series("0" * 64)


def test_what_goes_wrong_is_a_row(tmp_path, points, client):
    spoil = {"2": "raise", "3": "crash", "4": "endless", "5": "exit", "6": "no row", "7": "kill the server"}
    rows = points(9)
    rows[8]["path"] = str(tmp_path / "missing.osim")
    task = simulate.Function(tasks.by_index, settings={"spoil": spoil})
    results = simulate.run(rows, task, results=tmp_path / "r", scheduler=client, time_limit=3)
    table = results.table.set_index("index")
    expected = ["done", "failed", "crashed", "time limit", "failed", "failed", "lost", "done", "refused"]
    assert list(table["status"]) == expected
    assert table["error"][2].startswith(
        "model_00002.osim: ValueError: it does not\\u{1b}[31m stand in . (tasks.py, line "
    )
    # Where the pointer to nothing leads differs: SIGSEGV, or SIGABRT with the allocator's last words.
    died = r"model_00003\.osim: its process died: signal \d+ \(SIG[A-Z]+\); it last printed: \w+"
    assert re.match(died, table["error"][3])
    assert table["error"][4] == "model_00004.osim: it did not end within 3 s"
    assert "SystemExit" in table["error"][5]
    assert "returns a dictionary of numbers" in table["error"][6]
    assert "No such file" in table["error"][9]
    assert list(table["square"].dropna()) == [1, 64]
    assert len(results.failures) == 7


@pytest.mark.parametrize("kind", ["here", "processes"])
def test_any_executor_will_do(tmp_path, points, client, kind):
    rows = points(4)
    task = simulate.Function(tasks.by_index, settings={"spoil": {}})
    simulate.run(rows, task, results=tmp_path / "dask", scheduler=client)
    if kind == "here":
        simulate.run(rows, task, results=tmp_path / kind, scheduler="here", workers=2)
    else:
        with ProcessPoolExecutor(2) as pool:
            simulate.run(rows, task, results=tmp_path / kind, scheduler=pool)
    for name in ("table.csv", "table.parquet"):
        assert (tmp_path / kind / name).read_bytes() == (tmp_path / "dask" / name).read_bytes()


def test_where_no_process_can_be_copied_each_model_starts_one(tmp_path, points, monkeypatch):
    from osim_contact_scale.simulate import _messages

    monkeypatch.setattr(_messages, "CAN_FORK", False)
    task = simulate.Function(tasks.by_index, settings={"spoil": {"2": "crash", "3": "endless"}})
    monkeypatch.setattr("osim_contact_scale.simulate._worker._START_SECONDS", 1.0)
    table = simulate.run(points(3), task, results=tmp_path / "r", scheduler="here", workers=3, time_limit=12).table
    assert list(table["status"]) == ["done", "crashed", "time limit"]


def test_progress_and_the_address_of_the_dashboard(tmp_path, points, caplog, monkeypatch, capfd):
    from osim_contact_scale.simulate import _executors

    real_find_spec = _executors.importlib.util.find_spec
    # Dask's page needs bokeh, its address does not.
    monkeypatch.setattr(
        _executors.importlib.util, "find_spec", lambda name: real_find_spec("json" if name == "bokeh" else name)
    )
    caplog.set_level("INFO", logger="osim_contact_scale")
    counted = []
    task = simulate.Function(tasks.by_index, settings={"spoil": {"2": "raise"}})
    simulate.run(points(3), task, results=tmp_path / "r", workers=1, progress=lambda *step: counted.append(step))
    assert re.search(r"Dask's dashboard: http://[\w.:]+/status", caplog.text)
    assert sorted(counted) == [(1, False), (1, False), (1, True)]
    simulate.run(points(3), task, results=tmp_path / "r", workers=1, resume=True, progress=True)
    assert "simulate: 100%" in capfd.readouterr().err


def test_a_server_that_is_kept_waiting_sees_what_its_copy_wrote(tmp_path, monkeypatch):
    """The copy may write all its output and end after the server looked into the pipe, and before it looks at the process."""
    from osim_contact_scale.simulate import _server
    from osim_contact_scale.simulate._job import Job
    from osim_contact_scale.simulate._loaded import Loaded

    waitid = os.waitid

    def late(*arguments):
        time.sleep(0.5)
        return waitid(*arguments)

    monkeypatch.setattr(os, "waitid", late)
    monkeypatch.setattr(_server, "_POLL_SECONDS", 1e-6)
    loaded = Loaded()
    task = prepare_task(tasks.empty)
    digest = hashlib.sha256(HUMAN.read_bytes()).hexdigest()
    job = Job("run", "key", str(HUMAN), digest, {}, *task.pickled(), loaded.versions, None)
    ends = *os.pipe(), *os.pipe()
    outcome = _server._run_in_copy(job, loaded, ends[0], ends[3])
    for end in ends:
        os.close(end)
    assert (outcome.status, outcome.error) == ("done", None)


def test_the_same_model_twice_is_simulated_once(tmp_path, client):
    marks = tmp_path / "marks"
    marks.mkdir()
    rows = models(tmp_path / "models", 1) * 3
    task = simulate.Function(tasks.marks, settings={"folder": str(marks), "seconds": 0.1})
    table = simulate.run(rows, task, results=tmp_path / "r", scheduler=client).table
    assert list(table["square"]) == [1, 1, 1]
    assert len(list(marks.iterdir())) == 1


def test_shares_make_the_whole(tmp_path, points, client):
    rows = points(7)
    task = simulate.Function(tasks.by_index, settings={"spoil": {}})
    for share in ("1/3", "2/3", "3/3"):
        simulate.run(rows, task, results=tmp_path / "r", scheduler=client, shard=share, resume=share != "1/3")
        assert not (tmp_path / "r" / "table.csv").exists()
    table = simulate.run(rows, task, results=tmp_path / "r", scheduler=client, resume=True).table
    assert list(table["square"]) == [index * index for index in range(1, 8)]


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"points": [{"model": "a.osim"}]}, "expected a column path"),
        ({"points": [{"path": "a.osim", "key": 1}]}, "'key' is one of those that results have"),
        ({"task": {}}, "expected a function"),
        ({"task": tasks.no_path}, "its first parameter is the path"),
        ({"task": simulate.Function(tasks.empty, settings={"a": 1})}, "no parameter 'a'"),
        ({"task": simulate.Function(tasks.size, settings={"factor": object()})}, "expected numbers, texts"),
        ({"task": simulate.Drop}, "make one"),
        ({"time_limit": 0}, "seconds above 0"),
        ({"time_limit": "3"}, "seconds above 0"),
        ({"workers": 0}, "a whole number from 1"),
        ({"points": []}, "has no rows"),
        ({"task": simulate.Function(tasks.size, settings={"path": 1})}, "no parameter 'path'"),
        (
            {"points": [{"path": str(HUMAN), "factor": 1}], "task": simulate.Function(tasks.size, {"factor": 2})},
            "a setting, too",
        ),
        ({"scheduler": "nonsense"}, "no workers of Dask"),
        ({"shard": "4/3"}, "expected I/N"),
        ({"scheduler": 7}, "expected None, an address"),
        ({"workers": 2}, "has its own"),
    ],
)
def test_wrong_calls_are_refused_before_anything_runs(tmp_path, client, changed, message):
    call = {
        "points": [{"path": str(HUMAN)}],
        "task": tasks.empty,
        "results": tmp_path / "r",
        "scheduler": client,
        **changed,
    }
    points, task = call.pop("points"), call.pop("task")
    with pytest.raises(ocs.RequestError, match=message):
        simulate.run(points, task, **call)
    assert not list(tmp_path.glob("r/parts/*"))
