"""Folders for Moco: its initial guess has the forces of the corrected motion, and it runs from there."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import command
import numpy as np
import pytest
from models import FIXTURES
from test_motion import rows, table, trials

BW = 0.01  # difference of each component, in body weights


def moco(folder, intervals, iterations=-1):
    script = Path(__file__).with_name("opensim_moco.py")
    call = [sys.executable, str(script), str(folder), str(intervals), str(iterations)]
    process = subprocess.run(call, capture_output=True, text=True, timeout=300)
    assert process.returncode == 0, process.stdout[-2000:] + process.stderr[-2000:]
    return json.loads(process.stdout.splitlines()[-1])


def written(model, motion, plates, loads, folder, *more):
    """The corrected motion and both folders; the weight of the model, N."""
    files = ["--correct", folder / "corrected.sto", "--moco", folder / "moco", "--nmsm", folder / "nmsm"]
    outcome = command.run("motion", model, motion, "--plates", plates, "--loads", loads, *files, *more)
    assert outcome.status == 0, outcome.stderr
    return outcome.report["mass_kg"] * outcome.report["gravity_m_s2"]


def recordings():
    walker = Path(FIXTURES) / "motion"
    yield pytest.param(walker / "walker.osim", walker / "walk.mot", walker / "plates.sto", walker / "plates.xml", id="walker")
    for trial in trials():
        model, motion = trial.values
        (plates,) = [path for path in model.parent.glob("*[gG][rR][fF]*") if path.suffix != ".xml"]
        (loads,) = model.parent.glob("*[gG][rR][fF]*.xml")
        yield pytest.param(model, motion, plates, loads, id=trial.id)


@pytest.mark.parametrize(("model", "motion", "plates", "loads"), list(recordings()))
def test_the_initial_guess_has_the_forces_of_the_corrected_motion(model, motion, plates, loads, tmp_path):
    if not command.inspect(model).report["forces"]:
        command.run("add", model, "--from", "falisse2022", "-o", tmp_path / "with.osim")
        model = tmp_path / "with.osim"
    weight = written(model, motion, plates, loads, tmp_path)
    model, motion = tmp_path / "moco/model.osim", tmp_path / "moco/motion.sto"
    times, _, _ = table(motion)
    guess = moco(tmp_path / "moco", len(times) - 1)
    ours = {}
    for row in rows(model, motion):
        side = "l" if row["body"].endswith("_l") else "r"
        key = (side, round(float(row["time_s"]), 6))
        ours[key] = ours.get(key, 0.0) + np.array([float(row[f"force_{axis}_n"]) for axis in "xyz"])
    compared = 0
    for load, forces in guess["forces"].items():
        for time, force in zip(guess["time"], forces, strict=True):
            key = ("l" if load.endswith("_l") else "r", round(time, 6))
            if key in ours:
                compared += 1
                assert np.abs(ours[key] - force).max() < BW * weight, (load, time, ours[key], force)
    assert compared > len(times)


def test_ten_iterations_start_from_a_smaller_objective(tmp_path):
    """The walker's floor is 11 mm too high; the folder for NMSM has its motion without a correction."""
    model, motion, plates, loads = next(recordings()).values
    written(model, motion, plates, loads, tmp_path, "--start", "0.5", "--end", "1.1")
    corrected = moco(tmp_path / "moco", 5, 10)
    assert corrected["iterations"] == 10 and np.isfinite(corrected["objective"])
    corrected = moco(tmp_path / "moco", 20, 0)["objective"]
    shutil.copy(tmp_path / "nmsm/motion.sto", tmp_path / "moco/motion.sto")
    raw = moco(tmp_path / "moco", 20, 0)["objective"]
    print(f"objective at the start: {raw:.4g} from the raw motion, {corrected:.4g} from the corrected one")
    assert corrected < 0.02 * raw
