"""An earlier row is used again only if everything that its result depends on is unchanged."""

import importlib
import os
import subprocess
import sys
import threading

import osim_contact_scale as ocs
import pandas as pd
import pytest
import tasks
from conftest import models
from osim_contact_scale import simulate
from osim_contact_scale.simulate._job import Versions
from osim_contact_scale.simulate._source import Source
from osim_contact_scale.simulate._task import base_key, prepare_task, row_key
from source_cases import CASES

MODULE = '''
"""A task in a module of its own."""
import math

LENGTH = 3

class Helper:
    def __call__(self, x):
        return x + 1

def inner(x):
    return Helper()(x) * LENGTH

def unused(x):
    return x

def task(path, index=0, factor=1):
    def within(x):
        return inner(x)
    return {"value": within(index) * factor, "root": math.sqrt(index)}
'''


@pytest.fixture
def task_from(tmp_path, monkeypatch):
    """The function `task` of a module with this text."""
    monkeypatch.syspath_prepend(str(tmp_path))

    def load(text):
        name = f"module_{len(list(tmp_path.glob('module_*.py')))}"
        (tmp_path / f"{name}.py").write_text(text)
        importlib.invalidate_caches()
        return importlib.import_module(name).task

    yield load
    for name in [name for name in sys.modules if name.startswith("module_")]:
        del sys.modules[name]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("* factor", "* factor * 2"),
        ("LENGTH = 3", "LENGTH = 4"),
        ("x + 1", "x + 2"),
        ("Helper()(x) * LENGTH", "Helper()(x) + LENGTH"),
        ("return inner(x)", "return inner(x) + 0"),
        ("factor=1", "factor=2"),
    ],
)
def test_a_changed_source_is_another_function(task_from, old, new):
    assert old in MODULE
    assert Source(task_from(MODULE)).digest != Source(task_from(MODULE.replace(old, new))).digest


def test_what_is_not_used_does_not_matter(task_from):
    changed = MODULE.replace("def unused(x):\n    return x", "def unused(x):\n    return 7").replace(
        "LENGTH = 3", "# Of a leg.\nLENGTH = 3"
    )
    assert changed != MODULE
    assert Source(task_from(MODULE)).digest == Source(task_from(changed)).digest


@pytest.mark.parametrize("name", CASES)
def test_what_changes_a_result_changes_the_source(task_from, name):
    text, old, new = CASES[name]
    assert old in text
    one, other = task_from(text), task_from(text.replace(old, new))
    assert one("model.osim") != other("model.osim")
    assert Source(one).digest != Source(other).digest
    assert Source(one).digest == Source(task_from(text)).digest


def test_the_source_is_the_same_in_every_process(tmp_path):
    (tmp_path / "mine.py").write_text(
        "NAMES = {'left', 'right', 'both'}\ndef task(path):\n    return {'v': len(NAMES)}\n"
    )
    code = "import mine; from osim_contact_scale.simulate._source import Source; print(Source(mine.task).digest)"
    digests = {
        subprocess.run(
            [sys.executable, "-c", code],
            cwd=tmp_path,
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "2", "3")
    }
    assert len(digests) == 1


def test_other_modules_of_yours_are_followed(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(tmp_path))
    digests = set()
    for k in (1, 2):
        (tmp_path / f"beside_{k}.py").write_text(f"K = {k}\ndef f(x):\n    return K * x\n")
        text = f"import beside_{k} as beside\ndef task(path):\n    return {{'v': beside.f(1)}}\n"
        (tmp_path / f"above_{k}.py").write_text(text)
        importlib.invalidate_caches()
        source = Source(importlib.import_module(f"above_{k}").task)
        assert source.modules == [f"above_{k}", f"beside_{k}"]
        digests.add(source.digest)
    assert len(digests) == 2


def test_what_cannot_be_compared_needs_a_version():
    lock = threading.Lock()

    def locked(path):
        with lock:
            return {}

    with pytest.raises(ocs.RequestError, match="version="):
        prepare_task(locked)
    assert prepare_task(simulate.Function(locked, version="1")).identity["version"] == "1"


def test_running_workers_simulate_an_edited_module_again(tmp_path, client, monkeypatch):
    """Workers of a notebook, or at an address, have the older module in their memory."""
    monkeypatch.syspath_prepend(str(tmp_path))
    rows = models(tmp_path / "models", 1)
    result = []
    for value in (1, 2):
        (tmp_path / "edited.py").write_text(f"V = {value}\ndef task(path):\n    return {{'v': V, 'w': {value * 10}}}\n")
        importlib.invalidate_caches()
        sys.modules.pop("edited", None)
        monkeypatch.setattr(sys, "dont_write_bytecode", True)
        task = importlib.import_module("edited").task
        table = simulate.run(rows, task, results=tmp_path / "r", scheduler=client, resume=True).table
        result.append((table["v"][0], table["w"][0]))
    import edited

    edited.V = 7
    table = simulate.run(rows, edited.task, results=tmp_path / "r", scheduler=client, resume=True).table
    assert [*result, (table["v"][0], table["w"][0])] == [(1, 10), (2, 20), (7, 20)]


def test_every_part_of_a_key_counts():
    identity = {"task": "a", "settings": {"x": 1.0}, "version": "v"}
    versions = Versions("4.6", "0.1.0")
    other = {**identity, "settings": {"x": 2.0}}, {**identity, "version": "w"}, {**identity, "task": "b"}
    bases = [base_key(one, versions) for one in (identity, *other)]
    bases += [base_key(identity, one) for one in (Versions("4.5", "0.1.0"), Versions("4.6", "0.2.0"))]
    keys = {row_key("aa", base, {"index": 1}) for base in bases}
    keys |= {row_key("ab", bases[0], {"index": 1}), row_key("aa", bases[0], {"index": 2})}
    assert len(keys) == 8


def test_what_changed_is_simulated_again_and_nothing_else(tmp_path, client):
    rows = models(tmp_path / "models", 3)
    folder = tmp_path / "marks"
    folder.mkdir()

    def ran(settings=None, version=None):
        """The number of models that a run simulates."""
        before = len(list(folder.iterdir()))
        function = simulate.Function(tasks.marks, {"folder": str(folder), "seconds": 0, **(settings or {})}, version)
        results = simulate.run(rows, function, results=tmp_path / "r", scheduler=client, resume=True)
        assert list(results.table["status"]) == ["done"] * len(rows)
        return len(list(folder.iterdir())) - before

    assert ran() == 3
    assert ran() == 0
    assert ran(settings={"seconds": 0.001}) == 3
    assert ran(version=2) == 3
    with open(rows[1]["path"], "a") as file:
        file.write("\n")
    assert ran() == 1
    rows[2]["index"] = 9
    assert ran() == 1
    assert ran() == 0


def test_a_point_has_one_key_however_it_is_given(tmp_path, client):
    """Numbers of a file, of a DataFrame with gaps, and of a list."""
    rows = [{**row, "share": 0.5 * row["index"]} for row in models(tmp_path / "models", 2)]
    pd.DataFrame(rows).to_csv(tmp_path / "points.csv", index=False)
    floats = pd.DataFrame(rows).astype({"index": float})
    keys = {
        tuple(simulate.run(table, tasks.series, results=tmp_path / "r", scheduler=client, resume=True).table["key"])
        for table in (rows, pd.DataFrame(rows), floats, {name: [row[name] for row in rows] for name in rows[0]})
    }
    from_file = simulate.run(
        tmp_path / "points.csv", tasks.series, results=tmp_path / "r", scheduler=client, resume=True
    )
    assert keys == {tuple(from_file.table["key"])}


def test_settings_of_the_packages_tasks_are_in_the_key():
    identities = [
        prepare_task(task).identity for task in (simulate.Drop(), simulate.Drop(duration=1.0), simulate.Stand())
    ]
    assert len({str(identity) for identity in identities}) == 3


def test_results_are_never_overwritten_unasked(tmp_path, points, client):
    rows = points(1)
    simulate.run(rows, tasks.empty, results=tmp_path / "r", scheduler=client)
    with pytest.raises(ocs.RequestError, match="has results already"):
        simulate.run(rows, tasks.empty, results=tmp_path / "r", scheduler=client)
