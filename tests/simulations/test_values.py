"""Values from tables and for tables: a value that a table cannot hold is refused before the run, or gives a failed row."""

import datetime
import os
from pathlib import Path

import numpy as np
import osim_contact_scale as ocs
import pandas as pd
import pytest
import tasks
from conftest import HUMAN, processes
from osim_contact_scale import simulate
from osim_contact_scale.simulate._points import read_points
from osim_contact_scale.simulate._table_file import read_rows


def returns(path, what):
    """A value that a task may return by mistake."""
    made = {
        "long": 2**70,
        "no text": "\udcff",
        "object": object(),
        "list": [1.0],
        "nan": float("nan"),
        "inf": float("inf"),
    }
    made |= {"numpy": np.float32(0.5), "bool": True, "text": "näher\x1b[2J", "none": None}
    return {"value": made[what]}


@pytest.mark.parametrize(
    ("what", "expected"),
    [
        ("long", "ValueError: value is 1180591620717411303424 is longer than 64 bits"),
        ("no text", "ValueError: value is '\\udcff' is no text in Unicode"),
        ("object", "TypeError: value is object, expected a number or a text"),
        ("list", "TypeError: value is list, expected a number or a text"),
    ],
)
def test_what_no_table_can_hold_is_a_failed_row(tmp_path, client, what, expected):
    rows = [{"path": str(HUMAN), "what": what}, {"path": str(HUMAN), "what": "bool"}]
    table = simulate.run(rows, returns, results=tmp_path / "r", scheduler=client).table
    assert list(table["status"]) == ["failed", "done"]
    assert table["error"][0].startswith(f"{HUMAN.name}: {expected}")
    assert (tmp_path / "r" / "table.parquet").exists()


def test_other_values_are_kept(tmp_path, client):
    rows = [{"path": str(HUMAN), "what": what} for what in ("nan", "inf", "numpy", "bool", "text", "none")]
    results = simulate.run(rows, returns, results=tmp_path / "r", scheduler=client)
    assert list(results.table["value"]) == [None, float("inf"), 0.5, True, "näher\x1b[2J", None]
    assert b"\x1b" not in (results.folder / "table.csv").read_bytes()
    assert list(pd.read_parquet(results.folder / "table.parquet")["value"].dropna()) == [
        "inf",
        "0.5",
        "True",
        "näher\x1b[2J",
    ]


def clash(path):
    return {"a": 1.0, "a_result": 2.0, "error": 3.0}


def test_columns_of_one_name_are_both_there(tmp_path, client):
    rows = [{"path": str(HUMAN), "a": 7}]
    table = simulate.run(rows, clash, results=tmp_path / "r", scheduler=client).table
    assert (table["a"][0], table["a_result"][0], table["a_result_result"][0], table["error_result"][0]) == (
        7,
        1.0,
        2.0,
        3.0,
    )
    assert table["error"][0] is None


def test_values_of_points(tmp_path):
    row = {
        "path": HUMAN,
        "day": datetime.date(2026, 1, 2),
        "folder": Path("a") / "b",
        "n": np.int64(3),
        "gap": pd.NA,
        "t": "x",
    }
    (point,) = read_points([row])
    assert point.values == {"day": "2026-01-02", "folder": os.path.join("a", "b"), "n": 3, "gap": None, "t": "x"}
    assert type(point.values["n"]) is int
    for wrong in (1j, [1, 2], object()):
        with pytest.raises(ocs.RequestError, match=r"points: row 1, column 'x': .*expected a number or a text"):
            read_points([{"path": HUMAN, "x": wrong}])


def test_a_file_says_what_is_a_number(tmp_path):
    file = tmp_path / "points.csv"
    file.write_text("path,a,b,c,d,e,f\nm.osim,007,12,1e6,false,,12345678901234567890\n\n")
    (row,) = read_rows(file)
    assert row == {"path": "m.osim", "a": "007", "b": 12, "c": 1e6, "d": False, "e": None, "f": "12345678901234567890"}
    assert type(row["b"]) is int and type(row["c"]) is float


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "it is empty"),
        (b"path,a\n", "it has no rows"),
        (b"path,a\nm.osim,\xe4\n", "save it as CSV UTF-8"),
        ("path,a\nm.osim,ä\n".encode("utf-16"), "save it as CSV UTF-8"),
        (b"path,a,a\nm.osim,1,2\n", "the column 'a' appears twice"),
        (b"path,a\nm.osim,1,2\n", "line 2 has 3 cells, expected 2"),
        (b"path,a\n,1\n", "row 1 has no path"),
    ],
)
def test_files_that_are_no_table(tmp_path, content, message):
    file = tmp_path / "points.csv"
    file.write_bytes(content)
    with pytest.raises(ocs.RequestError, match=message):
        read_points(file)


def task_with_argument(path, stiffness):
    return {"stiffness_n_m2": stiffness}


def takes_all(model, **values):
    return {"count": len(values)}


def test_parameters_and_columns(tmp_path, client):
    rows = [{"path": str(HUMAN), "grid_stiffness": 1e6, "model": "a"}]
    with pytest.raises(
        ocs.RequestError, match="needs 'stiffness', which is neither a column nor a setting; there are: grid_stiff"
    ):
        simulate.run(rows, task_with_argument, results=tmp_path / "r", scheduler=client)
    # A column that is called like the parameter of the path does not reach it.
    assert list(simulate.run(rows, takes_all, results=tmp_path / "r", scheduler=client).table["count"]) == [1]


def no_number(path):
    return {}, {"time_s": [0.0, 1.0], "force_n": [float("nan")] * 2}


def test_series_are_found_by_any_whole_number(tmp_path, client):
    rows = [{"path": str(HUMAN), "index": 3}, {"path": str(HUMAN), "index": 4}]
    results = simulate.run(rows, tasks.series, results=tmp_path / "r", scheduler=client)
    assert list(results.series(np.int64(1))["force_n"]) == [0.0, 4.0, 3.0]
    for wrong in (2, -1):
        with pytest.raises(ocs.RequestError, match="expected 0 to 1"):
            results.series(wrong)
    results = simulate.run(rows[:1], no_number, results=tmp_path / "n", scheduler=client)
    assert results.series(0)["force_n"].isna().all()


def test_a_run_leaves_no_process(tmp_path, points):
    simulate.run(points(3), tasks.empty, results=tmp_path / "r", scheduler="here", workers=2)
    own = [
        pid
        for pid in processes("simulate._server")
        if Path(f"/proc/{pid}/stat").read_text().split()[3] == str(os.getpid())
    ]
    assert not own


def test_results_say_which_model_they_are_of(tmp_path, client):
    rows = [{"path": str(HUMAN)}, {"path": str(tmp_path / "none.osim")}]
    table = simulate.run(rows, tasks.empty, results=tmp_path / "r", scheduler=client).table
    assert list(table["path"]) == [row["path"] for row in rows]
    assert table["error"][1] == "none.osim: the model cannot be read: No such file or directory"
