"""The row of a model whose task raised an error: the message, the line of the user's code, and the model."""

import asyncio
import hashlib
import logging
import os
from pathlib import Path

import numpy as np
import osim_contact_scale as ocs
import pytest
from conftest import HUMAN, models
from osim_contact_scale import simulate
from osim_contact_scale.simulate._error_text import describe_error

HERE = Path(__file__).name


class Unsayable(Exception):
    def __str__(self):
        raise ValueError("no text")


def fail_deeper(what):
    if what == "nested":
        raise KeyError("no such body")
    return fail_deeper(what)


def fail_in_task(path, what):
    """Goes wrong in the way that the row says. The mark at the end of a line says of which row it is the place."""
    if what == "plain":
        raise ValueError("no weight")  # plain
    if what == "nested":
        fail_deeper(what)
    if what == "numpy":
        np.zeros(3) + np.zeros(4)  # numpy
    if what == "opensim":
        import opensim

        opensim.Model("nowhere.osim")  # opensim
    if what == "swig":
        import opensim

        opensim.Model(1, 2, 3)  # swig
    if what == "simbody":
        import opensim

        model = opensim.Model(path)
        model.initSystem()
        model.calcMassCenterPosition(opensim.State())  # simbody
    if what == "syntax":
        compile("a = = 1", "recipe.py", "exec")  # syntax
    if what == "interrupt":
        raise KeyboardInterrupt  # interrupt
    if what == "exit":
        raise SystemExit("enough")  # exit
    if what == "cancelled":
        raise asyncio.CancelledError  # cancelled
    if what == "recursion":
        fail_deeper(what)
    if what == "huge":
        raise ValueError("<begin>" + "x" * 3_000_000 + "<end>")  # huge
    if what == "lines":
        raise RuntimeError("first\n\n  second\r\nthird\x1b[31m")  # lines
    if what == "unsayable":
        raise Unsayable  # unsayable
    if what == "folder":
        Path("missing.txt").read_text()  # folder
    if what == "ours":
        ocs.rescale(path, target_mass=-1)  # ours
    return [what]


def line_of(mark):
    """The line of this file that ends with the mark."""
    lines = Path(__file__).read_text(encoding="utf-8").splitlines()
    return next(number for number, line in enumerate(lines, 1) if line.endswith(f"# {mark}"))


EXPECTED = {
    "plain": "ValueError: no weight",
    "numpy": "ValueError: operands could not be broadcast together with shapes (3,) (4,)",
    "opensim": "RuntimeError: Object: Cannot open file nowhere.osim. It may not exist or you do not have permission to read it.",
    "swig": "TypeError: new_Model expected at most 1 arguments, got 3",
    "simbody": "RuntimeError: Expected stage to be at least Model in System::Guts::realize() but current stage was Empty",
    "syntax": "SyntaxError: invalid syntax (recipe.py, line 1)",
    "interrupt": "the task ended its process: KeyboardInterrupt",
    "exit": "the task ended its process: SystemExit: enough",
    "cancelled": "CancelledError",
    "lines": "RuntimeError: first second third\\u{1b}[31m",
    "unsayable": "Unsayable",
    "folder": "FileNotFoundError: [Errno 2] No such file or directory: 'missing.txt'",
}

ODD = ("nested", "recursion", "huge", "ours", "returned")


@pytest.fixture(scope="module")
def errors(tmp_path_factory, client):
    """The error of each row, by the fault that the row causes."""
    folder = tmp_path_factory.mktemp("errors")
    rows = [{**row, "what": what} for row, what in zip(models(folder / "models", 20), [*EXPECTED, *ODD])]
    table = simulate.run(rows, fail_in_task, results=folder / "r", scheduler=client).table
    assert set(table["status"]) == {"failed"}
    assert not table["error"].str.contains(r"_child\.py|cloudpickle|distributed|Traceback|File \"|\n").any()
    # The model first: then nothing has to be looked up in another column.
    for path, error in zip(table["path"], table["error"]):
        assert error.startswith(f"{os.path.basename(path)}: ")
    return {what: error.partition(": ")[2] for what, error in zip(table["what"], table["error"])}


@pytest.mark.parametrize("what", EXPECTED)
def test_the_line_is_the_users(errors, what):
    place = f"({HERE}, line {line_of(what)}, in fail_in_task)"
    assert errors[what] == f"{EXPECTED[what]} {place}"


def test_the_innermost_function_of_the_user_is_named(errors):
    assert errors["nested"].startswith("KeyError: 'no such body' (") and errors["nested"].endswith(", in fail_deeper)")
    assert errors["recursion"].startswith("RecursionError: maximum recursion depth exceeded")
    assert errors["recursion"].endswith(", in fail_deeper)")


def test_of_a_huge_message_both_ends_are_there(errors):
    error = errors["huge"]
    assert len(error) < 700
    assert (
        error.startswith("ValueError: <begin>xxx")
        and f"<end> ({HERE}, line {line_of('huge')}, in fail_in_task)" in error
    )
    assert "letters in all" in error


def test_a_call_of_this_package_has_its_line_too(errors):
    assert errors["ours"].startswith("RequestError: target_mass=-1: expected a mass in kg")
    assert errors["ours"].endswith(f" ({HERE}, line {line_of('ours')}, in fail_in_task)")


def test_what_is_no_line_of_yours_has_none(errors):
    assert errors["returned"] == (
        "TypeError: a task returns a dictionary of numbers, or that and a dictionary of series, not list"
    )


def test_the_log_names_row_and_model(tmp_path, client, caplog):
    rows = [{**row, "what": "plain"} for row in models(tmp_path / "models", 2)]
    with caplog.at_level(logging.WARNING, "osim_contact_scale"):
        simulate.run(rows, fail_in_task, results=tmp_path / "r", scheduler=client)
    place = f"({HERE}, line {line_of('plain')}, in fail_in_task)"
    logged = sorted(record.getMessage() for record in caplog.records if record.name == "osim_contact_scale")
    assert logged == [f"failed: row {n}, model_0000{n}.osim: ValueError: no weight {place}" for n in (1, 2)]


def test_models_with_the_same_bytes_keep_their_names(tmp_path, client):
    rows = []
    for name in ("left.osim", "right.osim"):
        (tmp_path / name).write_bytes(HUMAN.read_bytes())
        rows.append({"path": str(tmp_path / name), "what": "plain"})
    table = simulate.run(rows, fail_in_task, results=tmp_path / "r", scheduler=client).table
    assert [error.partition(": ")[0] for error in table["error"]] == ["left.osim", "right.osim"]


def test_a_cell_of_a_notebook_has_a_line_and_no_file(tmp_path):
    for file in ("/tmp/ipykernel_4711/123456.py", "<ipython-input-3-0123456789ab>"):
        names = {}
        exec(compile("def task(path):\n    raise ValueError('no weight')", file, "exec"), names)
        try:
            names["task"]("a.osim")
        except ValueError as error:
            # This test is code of the user's, too, but further out.
            assert describe_error(error) == "ValueError: no weight (line 2, in task)"


def test_a_message_of_line_ends_alone_takes_no_time():
    assert describe_error(ValueError("\n" * 1_000_000)).startswith("ValueError")


def test_a_task_that_cannot_be_loaded_says_what_is_missing(tmp_path):
    from osim_contact_scale.simulate._child import simulate_job
    from osim_contact_scale.simulate._job import Job
    from osim_contact_scale.simulate._loaded import Loaded

    loaded = Loaded()
    digest = hashlib.sha256(HUMAN.read_bytes()).hexdigest()
    job = Job("run", "key", str(HUMAN), digest, {}, b"cnowhere_at_all\nf\n.", (), loaded.versions, None)
    outcome = simulate_job(job, loaded, str(tmp_path))
    assert outcome.error == "the task cannot be loaded here: ModuleNotFoundError: No module named 'nowhere_at_all'"
