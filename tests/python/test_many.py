"""Many models: tables, folders, sweeps, progress, Ctrl-C."""

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN, program

pd = pytest.importorskip("pandas", reason="pandas is not installed: tables are lists of dictionaries")


@pytest.fixture
def lab(tmp_path):
    """A folder with ten models, and a table with a target mass for each."""
    rows = []
    for number in range(1, 11):
        path = Path(shutil.copy(HUMAN, tmp_path / f"subject {number}.osim"))
        rows.append({"model": path, "target_mass": 50.0 + number / 3, "#group": "a" if number < 6 else "b"})
    return pd.DataFrame(rows)


def test_a_table_gives_what_batch_gives(lab, tmp_path):
    frame = ocs.rescale_many(lab, output_dir=tmp_path / "python", report=tmp_path / "report.html")
    assert list(frame["status"]) == ["written"] * 10 and list(frame["#group"]) == list(lab["#group"])
    lab.to_csv(tmp_path / "lab.csv", index=False)
    command = [
        program(),
        "batch",
        tmp_path / "lab.csv",
        "-d",
        tmp_path / "command",
        "--summary",
        tmp_path / "lab.ndjson",
    ]
    subprocess.run(command, check=True, capture_output=True)
    lines = [json.loads(line) for line in (tmp_path / "lab.ndjson").read_text().splitlines()]
    for name in ("stiffness_to", "stiffness_factor", "radius_to_m", "target_mass_kg"):
        assert list(frame[name]) == [line[name] for line in lines]
        assert frame[name].dtype == "float64"
    for path in (tmp_path / "command").iterdir():
        assert path.read_bytes() == (tmp_path / "python" / path.name).read_bytes()
    assert len(list((tmp_path / "python").iterdir())) == 10
    assert (tmp_path / "report.html").stat().st_size > 10_000


@pytest.mark.parametrize("form", ["frame", "records", "columns", "csv"])
def test_forms_of_tables(form, lab, tmp_path):
    lab = lab.drop(columns="#group")
    lab["model"] = lab["model"].map(str)
    lab.to_csv(tmp_path / "lab.csv", index=False)
    table = {
        "frame": lab,
        "records": lab.to_dict("records"),
        "columns": lab.to_dict("list"),
        "csv": tmp_path / "lab.csv",
    }[form]
    frame = ocs.rescale_many(table, output_dir=tmp_path / "new")
    assert list(frame["status"]) == ["written"] * 10


def test_missing_cells_say_nothing(lab, tmp_path):
    lab["contacts_mass"] = [70.0] + [float("nan")] * 9
    frame = ocs.rescale_many(lab, output_dir=tmp_path / "new")
    assert frame["contacts_mass_kg"][0] == 70 and set(frame["contacts_mass_kg"][1:]) == {62.0}


def test_wrong_rows_are_all_named_and_nothing_is_written(lab, tmp_path):
    lab.loc[2, "target_mass"] = -5
    lab.loc[4, "model"] = tmp_path / "nobody.osim"
    with pytest.raises(ocs.RequestError, match="2 rows are wrong") as caught:
        ocs.rescale_many(lab, output_dir=tmp_path / "new")
    assert "nobody.osim" in str(caught.value) and not (tmp_path / "new").exists()


def test_a_bad_model_does_not_stop_the_others(lab, tmp_path):
    (tmp_path / "subject 3.osim").write_bytes(b"<OpenSimDocument")
    frame = ocs.rescale_many(lab, output_dir=tmp_path / "new")
    assert list(frame["status"]) == ["written"] * 2 + ["failed"] + ["written"] * 7
    assert frame["error"].notna().sum() == 1


def test_a_folder_with_one_change(lab, tmp_path):
    frame = ocs.many("rescale", tmp_path, target_mass=80, output_dir=tmp_path / "new", jobs=1)
    assert len(frame) == 10 and set(frame["status"]) == {"written"}
    planned = ocs.many("transfer", [tmp_path / "subject 1.osim"], from_="falisse2022", spheres=6, dry_run=True)
    assert list(planned["status"]) == ["dry-run"]


def test_properties_are_set_in_a_folder_as_in_one_model(lab, tmp_path):
    ocs.many("set", tmp_path, stiffness="x2", radius=0.03, contacts_mass=61.0, output_dir=tmp_path / "new")
    one = ocs.set(tmp_path / "subject 1.osim", stiffness="x2", radius=0.03, contacts_mass=61.0)
    assert len(one.changes) == 24
    assert (tmp_path / "new" / "subject 1.osim").read_bytes() == one.to_bytes()


def test_a_run_goes_on_where_it_stopped(lab, tmp_path):
    options = {"output_dir": tmp_path / "new", "summary": tmp_path / "lab.ndjson"}
    ocs.rescale_many(lab.iloc[:4], **options)
    frame = ocs.rescale_many(lab, **options, resume=True)
    assert list(frame["status"]) == ["written"] * 10
    assert dict(zip(frame["model"], frame["#group"])) == dict(zip(lab["model"].map(str), lab["#group"]))


def test_progress_is_called_for_every_model(lab, tmp_path):
    calls = []
    ocs.rescale_many(lab, output_dir=tmp_path / "new", progress=lambda count, failed: calls.append((count, failed)))
    assert calls == [(1, False)] * 10
    calls.clear()
    ocs.inspect(tmp_path / "new", progress=lambda count, failed: calls.append(count))
    assert calls == [1] * 10


def test_an_exception_of_the_callback_ends_the_run(lab, tmp_path):
    def refuse(count, failed):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        ocs.rescale_many(lab, output_dir=tmp_path / "new", jobs=1, progress=refuse)
    assert len(list((tmp_path / "new").iterdir())) == 1


@pytest.mark.parametrize("jobs", [1, 4])
def test_a_run_that_was_stopped_goes_on(lab, tmp_path, jobs):
    # Many more than threads have begun when the first is reported.
    for number in range(11, 301):
        shutil.copy(HUMAN, tmp_path / f"subject {number}.osim")
    models = [tmp_path / f"subject {number}.osim" for number in range(1, 301)]
    table = [{"model": model, "target_mass": 50 + number / 100} for number, model in enumerate(models)]
    options = {"output_dir": tmp_path / "new", "summary": tmp_path / "lab.csv", "jobs": jobs}
    count = []

    def stop(*_):
        count.append(1)
        if len(count) == 20:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        ocs.rescale_many(table, **options, progress=stop)
    first = set(os.listdir(tmp_path / "new"))
    assert 20 <= len(first) < 300
    # Stopped once more: what the first run did is not forgotten.
    count.clear()
    with pytest.raises(RuntimeError, match="enough"):
        ocs.rescale_many(table, **options, resume=True, progress=stop)
    results = ocs.rescale_many(table, **options, resume=True)
    assert list(results["status"]) == ["written"] * 300
    assert len(os.listdir(tmp_path / "new")) == 300


def test_a_folder_as_data_frames(tmp_path):
    inspection = ocs.inspect(FIXTURES / "table1")
    assert len(inspection.models) == len(inspection) > 10
    assert len(inspection.spheres) == sum(len(record["spheres"]) for record in inspection)
    assert inspection.spheres["radius_m"].dtype == "float64"
    check = ocs.check(FIXTURES)
    assert len(check.errors) > 10 and all(isinstance(error, ocs.ModelError) for error in check.errors)
    assert len(check.table) == len(check.findings)


def test_a_sweep(human, tmp_path):
    calls = []
    sweep = ocs.sweep(
        human, grid={"stiffness": "x0.1..x10/3", "dissipation": [0.5, 2]}, progress=lambda *call: calls.append(call)
    )
    frame = sweep.table
    assert len(sweep) == len(frame) == len(calls) == 6
    assert all(Path(path).is_file() for path in frame["path"])
    stiffness = [ocs.inspect(path).forces["stiffness"][0] for path in frame["path"]]
    assert stiffness == list(frame["stiffness"]) if "stiffness" in frame else len(set(stiffness)) == 3


def test_parts_of_a_sweep_are_rows_of_the_whole(human, tmp_path):
    call = {"grid": {"stiffness": "x0.1..x10/3", "dissipation": [0.5, 2]}, "output_dir": tmp_path / "out"}
    (one,) = rows(ocs.sweep(human, **call, point=3))
    assert one["index"] == 3 and os.path.basename(one["path"]).startswith("human_3_stiffness-x1_")
    second = ocs.sweep(human, **call, point=3, resume=True)
    assert (second.record["points"], second.record["file"], second.record["done_before"]) == (6, one["file"], 1)
    share = rows(ocs.sweep(human, **call, shard="2/2"))
    assert [row["index"] for row in share] == [2, 4, 6]
    whole = ocs.sweep(human, **call, resume=True)
    assert whole.record["done_before"] == 4 and [row["index"] for row in rows(whole)] == [1, 2, 3, 4, 5, 6]
    assert [row for row in rows(whole) if row["index"] in (2, 4, 6)] == share
    assert [path for path in (tmp_path / "out").iterdir() if path.suffix == ".csv"] == [whole.manifest]
    none = ocs.sweep(human, **call, shard="8/8")
    assert len(none) == len(none.table) == 0 and none.manifest is None
    with pytest.raises(ocs.RequestError, match="counted from 1 to 6") as caught:
        ocs.sweep(human, **call, point=7)
    assert caught.value.keyword == "point"


def rows(sweep):
    return sweep.table.to_dict("records")


@pytest.mark.parametrize("count", [0, -1, 2.5, "2", True, 10**30])
def test_threads_are_checked(count, human):
    calls = {
        "count": lambda: ocs.set_threads(count),
        "inspect": lambda: ocs.inspect(HUMAN, jobs=count),
        "check": lambda: ocs.check(HUMAN, jobs=count),
        "many": lambda: ocs.many("rescale", human, target_mass=80, dry_run=True, jobs=count),
        "table": lambda: ocs.rescale_many([{"model": human, "target_mass": 80}], dry_run=True, jobs=count),
        "sweep": lambda: ocs.sweep(human, grid={"stiffness": "x2"}, dry_run=True, jobs=count),
    }
    for name, call in calls.items():
        with pytest.raises(ocs.RequestError, match="1 or more") as caught:
            call()
        assert caught.value.keyword == ("count" if name == "count" else "jobs"), name


def test_threads_may_be_a_number_of_numpy(human):
    np = pytest.importorskip("numpy")
    ocs.set_threads(np.int64(1))
    assert len(ocs.inspect(FIXTURES / "table1")) > 10
    ocs.set_threads(None)
    assert len(ocs.inspect(human, jobs=np.int64(2))) == 1


@pytest.mark.parametrize("text", ["²", "0", "-1", "two", "9" * 5000])
def test_an_environment_that_says_nothing_useful_is_reported_once(text, monkeypatch):
    ocs.set_threads(None)
    monkeypatch.setenv("OSIM_CONTACT_SCALE_THREADS", text)
    with pytest.warns(ocs.ContactScaleWarning) as caught:
        assert len(ocs.inspect(HUMAN)) == len(ocs.inspect(HUMAN)) == 1
    said = [str(warning.message) for warning in caught]
    assert len(said) == 1 and "OSIM_CONTACT_SCALE_THREADS" in said[0] and len(said[0]) < 250


def test_progress_is_yes_no_or_a_function():
    with pytest.raises(ocs.RequestError, match="progress='yes'") as caught:
        ocs.inspect(HUMAN, progress="yes")
    assert caught.value.keyword == "progress"


def test_many_takes_models_and_verbs_that_change_them(lab, tmp_path):
    lab.to_csv(tmp_path / "lab.csv", index=False)
    for table in (lab, lab.to_dict("records"), lab.to_dict("list"), tmp_path / "lab.csv"):
        with pytest.raises(ocs.RequestError, match="rescale_many"):
            ocs.many("convert", table, to="hunt-crossley", dry_run=True)
    for verb in ("foo", "inspect", "batch", None):
        with pytest.raises(ocs.RequestError, match="rescale, transfer, add, remove, convert, design, set, note"):
            ocs.many(verb, HUMAN)
    with pytest.raises(ocs.RequestError, match="there are no models"):
        ocs.many("rescale", [], target_mass=80)
    for model in (HUMAN.read_bytes(), ocs.rescale(HUMAN, target_mass=80)):
        for models in (model, [model]):
            with pytest.raises(TypeError, match="expected the paths of models"):
                ocs.many("rescale", models, target_mass=80, dry_run=True)


@pytest.mark.parametrize("arguments", [HUMAN, "folder", [HUMAN, HUMAN], [], 12, b"x"])
def test_what_is_not_a_table_is_refused_with_both_ways_out(arguments):
    with pytest.raises(ocs.RequestError, match=r'expected a table .* ocs\.many\("rescale", models, target_mass='):
        ocs.rescale_many(arguments)


def test_other_threads_of_python_run_meanwhile():
    """While Rust works on a folder, another thread counts: the lock of the interpreter is free."""
    ticks, finished = [], threading.Event()

    def count():
        while not finished.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.0005)

    counter = threading.Thread(target=count)
    counter.start()
    begin = time.perf_counter()
    ocs.check(FIXTURES)
    end = time.perf_counter()
    finished.set()
    counter.join()
    assert sum(begin < tick < end for tick in ticks) > 5


@pytest.mark.skipif(os.name == "nt", reason="Windows sends Ctrl-C to a console, which this test has not")
def test_ctrl_c_stops_a_long_run(tmp_path):
    models = tmp_path / "models"
    models.mkdir()
    # Each takes its time: half a megabyte to write.
    one = tmp_path / "one.osim"
    one.write_bytes(HUMAN.read_bytes().rstrip() + b"<!--" + 500_000 * b"x" + b"-->")
    for number in range(3000):
        os.link(one, models / f"{number}.osim")
    code = (
        # What a shell starts in the background ignores Ctrl-C, and so would its children.
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "import osim_contact_scale as ocs\n"
        "print('begun', flush=True)\n"
        f"try: ocs.many('rescale', {str(models)!r}, target_mass=80, output_dir={str(tmp_path / 'new')!r}, jobs=1)\n"
        "except KeyboardInterrupt: print('stopped', flush=True)\n"
        f"print(len(ocs.inspect({str(HUMAN)!r})))\n"
    )
    run = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert run.stdout.readline() == "begun\n"
    while not (tmp_path / "new").exists() or len(os.listdir(tmp_path / "new")) < 20:
        time.sleep(0.005)
    run.send_signal(signal.SIGINT)
    rest, _ = run.communicate(timeout=60)
    assert rest == "stopped\n1\n"
    new = list((tmp_path / "new").iterdir())
    assert 20 <= len(new) < 3000 and all(path.read_bytes().endswith(b"x-->") for path in new)
