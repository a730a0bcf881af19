"""Tests `python -m osim_contact_scale.simulate`: its output and exit status, which agree with the function `run`."""

import re
import signal
import subprocess

import osim_contact_scale as ocs
import pandas as pd
import pytest
from conftest import HERE, HUMAN, models, wait_for
from osim_contact_scale import simulate


@pytest.fixture
def command(start):
    """Runs it to its end: status, what it printed, and its messages."""

    def run(*words, **options):
        process = start(
            "-m", "osim_contact_scale.simulate", *words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options
        )
        out, err = process.communicate(timeout=120)
        return process.returncode, out, err

    return run


@pytest.fixture
def table(tmp_path):
    sweep = ocs.sweep(HUMAN, grid={"stiffness": ["x0.5", "x2"]}, output_dir=tmp_path / "human.sweep")
    return sweep.manifest


def test_it_is_the_function(tmp_path, command, table, client):
    words = ("--task", "drop", "--set", "duration=0.3", "--set", "height=0.5R", "--set", "samples=11")
    status, out, err = command(table, *words, "--results", tmp_path / "r", "--workers", 2)
    assert (status, out, err) == (0, f"2 done: {tmp_path / 'r' / 'table.csv'}\n", "")
    task = simulate.Drop(duration=0.3, height="0.5R", samples=11)
    simulate.run(table, task, results=tmp_path / "same", scheduler=client)
    for name in ("table.csv", "table.parquet"):
        assert (tmp_path / "r" / name).read_bytes() == (tmp_path / "same" / name).read_bytes()


def test_a_function_of_a_file(tmp_path, command, table):
    words = (
        "--task",
        f"{HERE / 'tasks.py'}:size",
        "--set",
        "factor=3",
        "--scheduler",
        "here",
        "--results",
        tmp_path / "r",
    )
    assert command(table, *words)[0] == 0
    assert list(pd.read_csv(tmp_path / "r" / "table.csv")["scaled"]) == [6.0, 6.0]
    # A second run is refused; with --resume there is nothing to do.
    status, _, err = command(table, *words)
    assert status == 2 and "has results already" in err and len(err.splitlines()) == 1
    assert command(table, *words, "--resume")[0] == 0


def test_failures_are_in_the_status(tmp_path, command):
    rows = models(tmp_path / "models", 3)
    pd.DataFrame(rows).to_csv(tmp_path / "points.csv", index=False)
    spoil = 'spoil={"2": "raise"}'
    words = (tmp_path / "points.csv", "--task", f"{HERE / 'tasks.py'}:by_index", "--set", spoil, "--scheduler", "here")
    status, out, err = command(*words, "--results", tmp_path / "r")
    assert status == 1
    assert out.startswith("2 done, 1 failed: ")
    (line,) = err.splitlines()
    said = r"ValueError: it does not\\u\{1b\}\[31m stand in \. \(tasks\.py, line \d+, in by_index\)"
    assert re.fullmatch(rf"failed: row 2, model_00002\.osim: {said}", line)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--task", "fly"], "--task fly: expected drop, stand or FILE.py:FUNCTION"),
        (["--task", "none.py:run"], "there is no file none.py"),
        (["--task", f"{HERE / 'tasks.py'}:none"], "has no function none"),
        (["--task", "drop", "--set", "speed=3"], "--set speed: drop has height, duration"),
        (["--task", "drop", "--set", "speed"], "expected NAME=VALUE"),
        (["--task", "drop", "--set", "height=1", "--set", "height=2"], "height: said twice"),
        (["--task", "drop", "--set", "=1"], "expected NAME=VALUE"),
        (["--task", "drop", "--shard", "3/2"], "expected I/N"),
        (["--task", "drop", "--set", "joints=loose"], "joints"),
    ],
)
def test_wrong_calls_say_so_in_one_line(tmp_path, command, table, words, message):
    status, out, err = command(table, *words, "--scheduler", "here", "--results", tmp_path / "r", cwd=tmp_path)
    assert status == 2 and not out
    assert message in err and len(err.splitlines()) == 1


def test_no_table(tmp_path, command):
    status, _, err = command(tmp_path / "none.csv", "--task", "drop", "--results", tmp_path / "r")
    assert status == 2 and len(err.splitlines()) == 1 and "none.csv" in err


@pytest.mark.parametrize(("number", "expected"), [(signal.SIGTERM, 143), (signal.SIGINT, 130)])
def test_it_stops_when_it_is_asked_to(tmp_path, start, number, expected):
    rows = models(tmp_path / "models", 40)
    pd.DataFrame(rows).to_csv(tmp_path / "points.csv", index=False)
    marks = tmp_path / "marks"
    marks.mkdir()
    words = (
        "--task",
        f"{HERE / 'tasks.py'}:marks",
        "--set",
        f'folder="{marks}"',
        "--set",
        "seconds=0.3",
        "--scheduler",
        "here",
    )
    process = start(
        "-m",
        "osim_contact_scale.simulate",
        tmp_path / "points.csv",
        *words,
        "--results",
        tmp_path / "r",
        stderr=subprocess.PIPE,
    )
    wait_for(lambda: len(list(marks.iterdir())) > 8)
    process.send_signal(number)
    _, err = process.communicate(timeout=20)
    assert process.returncode == expected
    assert err.splitlines()[-1].endswith("what was done is kept: run again with --resume")
    assert list((tmp_path / "r" / "parts").glob("*.rows.parquet"))


def test_a_file_may_be_called_like_a_module_of_python(tmp_path, command, table):
    (tmp_path / "tasks").mkdir()
    (tmp_path / "tasks" / "calendar.py").write_text("import beside\ndef f(path):\n    return {'v': beside.K}\n")
    (tmp_path / "tasks" / "beside.py").write_text("K = 5\n")
    task = f"{tmp_path / 'tasks' / 'calendar.py'}:f"
    status, _, err = command(table, "--task", task, "--scheduler", "here", "--results", tmp_path / "r")
    assert (status, err) == (0, "")
    assert list(pd.read_csv(tmp_path / "r" / "table.csv")["v"]) == [5, 5]
