"""A sample of a sweep: OpenSim reads from each file the values that the manifest lists for it."""

import csv
import hashlib
import random
import subprocess

import pytest

import command
import models

PROPERTIES = ("radius", "stiffness", "dissipation", "constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing")
SAMPLE = 12
SWEEPS = {
    "grid": ("--grid", "stiffness=x0.1..x10/9", "--grid", "dissipation=0.1..4/9"),
    "design": ("--grid", "indentation=0.05,0.1,0.16", "--grid", "restitution=0.8,0.9"),
    "masses": ("--grid", "target_mass=0.0209..1190/7", *command.YES),
    "ladder": ("--ladder", "5", "--indentation", "0.16", "--restitution", "0.8"),
}
SWEPT = [path for path in models.fixtures("reads") if path.name in ("giraffe_smooth_sphere.osim", "mouse_hunt_crossley.osim")]
SWEPT += [path for path in models.corpus() if "falisse" in path.name]


@pytest.mark.parametrize("sweep", SWEEPS)
@pytest.mark.parametrize("model", SWEPT, ids=models.label)
def test_opensim_reads_what_the_manifest_says(model, sweep, readings, tmp_path):
    process = subprocess.run([str(command.BINARY), "sweep", str(model), *SWEEPS[sweep], "-d", str(tmp_path)], timeout=120)
    assert process.returncode == 0
    (manifest,) = tmp_path.glob("*.csv")
    with manifest.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(list(tmp_path.glob("*.osim"))) > 2
    sample = random.Random(1).sample(rows, min(SAMPLE, len(rows)))
    readings.fetch([tmp_path / row["file"] for row in sample])
    for row in sample:
        path = tmp_path / row["file"]
        assert hashlib.sha256(path.read_bytes()).hexdigest() == row["sha256"]
        reading = readings[path]
        assert reading["loads"] and reading["connects"], reading["error"]
        for name in PROPERTIES:
            seen = set(values(reading, name))
            if row[name]:
                assert seen == {float(row[name])}, (path.name, name)
            else:
                assert len(seen) != 1, (path.name, name)


def values(reading, name):
    """Every value of a property, as OpenSim has it."""
    if name == "radius":
        return [float.fromhex(sphere["radius"]) for sphere in reading["spheres"]]
    parameters = [force["parameters"] for force in reading["forces"]]
    return [float.fromhex(values_by_name[name]) for values_by_name in parameters if name in values_by_name]
