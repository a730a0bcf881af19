"""The study of `docs/studies/muscles.md`: sizes and their problem in the real OpenSim; one of its walks searched once more."""

import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import opensim
import pytest
from conftest import TOP

HERE = TOP / "demonstrations" / "muscles"
PAGE = TOP / "docs" / "studies" / "muscles.md"
CORPUS = os.environ.get("OSIM_CORPUS")
needs_moco = pytest.mark.skipif(not CORPUS, reason="OSIM_CORPUS is not set: models by other people are not at hand")
MOCO = Path(CORPUS or ".") / ".." / "trials" / "example2DWalking"
LENGTHS = ("pelvis_tx", "pelvis_ty")
# Tables of the page: their names, and what makes them of which files.
TABLES = [("muscles", "block", ("TABLE", "CURVES")), ("predictions", "predicted", ("PREDICTIONS", "PREDICTED"))]


def in_study(program):
    """The output of a program that has the study's modules; other studies have modules of the same names."""
    process = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, cwd=HERE, check=False)
    assert process.returncode == 0, process.stderr
    return process.stdout


def written(folder, mass):
    """The two models of a mass."""
    in_study(
        f"import sizes; from pathlib import Path; "
        f"sizes.scale_to_mass(Path({str(MOCO / '2D_gait.osim')!r}), Path({str(folder)!r}), sizes.Size({mass}))"
    )
    return {kind: folder / f"{kind}_{mass:g}.osim" for kind in ("rescaled", "left")}


def accelerations(path, length):
    """Accelerations of all coordinates over those of similarity, in a moving pose with both feet in the ground and active muscles."""
    walker = opensim.Model(str(path))
    state = walker.initSystem()
    chosen = np.random.default_rng(1)
    coordinates = [walker.getCoordinateSet().get(index) for index in range(walker.getNumCoordinates())]
    for one in coordinates:
        value, speed = chosen.uniform(0, 0.2, 2)
        value = {"pelvis_ty": 0.9}.get(one.getName(), -value if "knee" in one.getName() else value)
        size = length if one.getName() in LENGTHS else 1
        one.setValue(state, value * size, False)
        one.setSpeedValue(state, speed * size / math.sqrt(length))
    for muscle in walker.getMuscleList():
        same = opensim.DeGrooteFregly2016Muscle.safeDownCast(walker.getComponent(muscle.getAbsolutePathString()))
        same.setActivation(state, chosen.uniform(0.1, 0.9))
    walker.realizeAcceleration(state)
    return {
        one.getName(): one.getAccelerationValue(state) * (1 if one.getName() in LENGTHS else length)
        for one in coordinates
    }


@needs_moco
@pytest.mark.parametrize("mass", [0.125, 8.0])
def test_a_walker_of_another_mass_moves_alike_on_transferred_contacts(mass, tmp_path):
    """All of it is in these accelerations: masses, muscles, contacts. Friction of the smooth class is similar only nearly."""
    original, length = accelerations(MOCO / "2D_gait.osim", 1.0), mass ** (1 / 3)
    paths, largest = written(tmp_path, mass), max(map(abs, original.values()))
    transferred, left = (accelerations(paths[kind], length) for kind in ("rescaled", "left"))
    assert max(abs(transferred[name] - original[name]) for name in original) < 1e-4 * largest
    assert max(abs(left[name] - original[name]) for name in original) > 0.1 * largest


RATES = """
import opensim
opensim.Logger.setLevelString("Off")
def rate(path):
    model = opensim.Model(path)
    state = model.initSystem()
    model.realizeAcceleration(state)
    muscle = next(iter(model.getMuscleList()))
    return muscle.getStateVariableDerivativeValue(state, "activation")
print(*map(rate, {paths}))
"""


@needs_moco
def test_each_size_needs_a_process_of_its_own(tmp_path):
    """Activation of a body 64 times heavier takes twice as long; OpenSim 4.6 gives a second body the times of the first one.

    When this fails since OpenSim no longer does, `_alone` in muscles.py may go.
    """
    paths = [str(MOCO / "2D_gait.osim"), str(written(tmp_path, 64.0)["rescaled"])]
    alone = [float(in_study(RATES.format(paths=[path]))) for path in paths]
    assert alone[0] == pytest.approx(2 * alone[1], rel=1e-6)
    together = list(map(float, in_study(RATES.format(paths=paths)).split()))
    assert together[0] == together[1]


@needs_moco
@pytest.mark.studies
def test_the_heavy_walk_is_found_again(tmp_path):
    """A walk from the reference, at the first mesh: the cost is that of the table, and that of the original."""
    words = ["solve", "--moco", MOCO, "--results", tmp_path, "--mass", 8, "--contacts", "rescaled", "--meshes", 15]
    words += ["--table", tmp_path / "muscles.csv", "--curves", tmp_path / "curves.csv"]
    process = subprocess.run([sys.executable, HERE / "muscles.py", *map(str, words)], capture_output=True, text=True)
    assert process.returncode == 0, process.stderr
    (found,) = table(tmp_path / "muscles.csv")
    by_key = {(float(row["mass"]), row["contacts"], row["mesh"]): row for row in table(HERE / "muscles.csv")}
    assert found["solved"] == "1"
    for mass in (8.0, 1.0):
        assert float(found["cost"]) == pytest.approx(float(by_key[mass, "rescaled", "15"]["cost"]), rel=2e-3)


@needs_moco
@pytest.mark.studies
def test_the_predicted_walk_is_one_at_another_mass(tmp_path):
    """A walk is tracked, predicted and then scaled. By similarity this is a predicted walk of the heavy body, at the same cost."""
    files = ["--table", tmp_path / "rows.csv", "--curves", tmp_path / "curves.csv"]
    tracked = ["--table", tmp_path / "tracked.csv", "--curves", tmp_path / "tracked_curves.csv"]
    for verb, mass, more in (("solve", 1, tracked), ("predict", 1, files), ("predict", 8, files)):
        words = [verb, "--moco", MOCO, "--results", tmp_path, "--mass", mass, "--contacts", "rescaled", "--meshes", 15]
        process = subprocess.run(
            [sys.executable, HERE / "muscles.py", *map(str, [*words, *more])], capture_output=True, text=True
        )
        assert process.returncode == 0, process.stderr
    original, heavy = table(tmp_path / "rows.csv")
    assert (original["solved"], heavy["solved"]) == ("1", "1")
    assert int(heavy["iterations"]) <= 10
    assert float(heavy["cost"]) == pytest.approx(float(original["cost"]), rel=1e-3)
    committed = table(HERE / "predictions.csv")[0]
    assert float(original["cost"]) == pytest.approx(float(committed["cost"]), rel=2e-3)


def table(path):
    """The rows of a table."""
    import csv

    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_the_committed_table_has_what_the_page_claims():
    """On transferred contacts it costs the same at every mass, on others not; the mesh is fine enough for the original."""
    rows = table(HERE / "muscles.csv")
    cost = {(float(row["mass"]), row["contacts"], row["mesh"], row["start"]): float(row["cost"]) for row in rows}
    original = cost[1.0, "rescaled", "15", "reference"]
    for mass in (8.0, 0.125):
        assert cost[mass, "rescaled", "15", "reference"] == pytest.approx(original, rel=1e-4)
        assert cost[mass, "left", "15", "reference"] > 1.5 * original
    assert cost[8.0, "no_friction", "15", "reference"] < original / 1.2
    held = {(row["mass"], row["mesh"]): row["forward_held"] for row in rows if row["contacts"] == "rescaled"}
    assert held["8", "60"] == held["0.125", "60"] == held["1", "60"]
    assert cost[1.0, "rescaled", "30", "half"] == pytest.approx(cost[1.0, "rescaled", "60", "half"], rel=0.02)


def test_the_committed_predictions_are_one_walk():
    """At each mesh, the walk of the original is also a walk of the other bodies."""
    rows = table(HERE / "predictions.csv")
    originals = {row["mesh"]: row for row in rows if row["mass"] == "1"}
    others = [row for row in rows if row["start"] == "original"]
    assert {row["mass"] for row in others} == {"8", "0.125"}
    for row in others:
        assert row["solved"] == "1"
        for name, alike in (("cost", 1e-3), ("half_stride_s", 1e-3), ("peak_force_bw", 1e-3)):
            assert float(row[name]) == pytest.approx(float(originals[row["mesh"]][name]), rel=alike), name


@pytest.mark.parametrize(("name", "lines", "tables"), TABLES)
def test_the_page_says_what_the_committed_tables_say(name, lines, tables):
    read = ", ".join(f"muscles.read(muscles.{table})" for table in tables)
    printed = in_study(f"import muscles, page; print(*page.{lines}({read}), sep='\\n')")
    block = PAGE.read_text(encoding="utf-8").split(f"<!-- begin {name} -->")[1].split(f"<!-- end {name} -->")[0]
    assert block.strip() == printed.strip()
