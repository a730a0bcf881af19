"""Where bodies rest on smoothed contacts: the real OpenSim finds the weight there, and leaves a falling body there.

At rest (C.9) keeps the factor 1/2 + 1/2 tanh(2 bv / (3 alpha)), which is far from 1 where alpha is large against bv. The
program is given models without any motion; OpenSim's forces are those at speed 0, and its drops run until nothing moves.
"""

from itertools import product

import pytest

import command
import models
from opensim_drops import drops
from opensim_forces import forces
from test_forces import SMOOTHING, Contact, model

TOLERANCE = 1e-6  # of the load, and of R
ALPHAS = (0.1, 0.5, 2.0, 8.0, 20.0, 50.0)  # s/m
SPEED_SMOOTHINGS = (5.0, 15.0, 50.0, 150.0, 500.0)  # s/m
GRAVITY = 9.81  # m/s2, of `test_forces.model`
MASS = 62.0  # kg
EVERY_BODY = ("--select", "*")  # each sphere of `test_forces.model` has a body of its own
SMOOTH = "SmoothSphereHalfSpaceForce"

# Radii of the spheres of a limb in m, and how many spheres share the weight.
STANCES = {
    "alike": ((0.032,) * 6, 6),
    "alike_on_two_limbs": ((0.032,) * 3, 6),
    "two_radii": ((0.02, 0.032), 4),
    "three_radii": ((0.015, 0.03, 0.06), 3),
    "two_limbs_of_three_radii": ((0.015, 0.03, 0.06), 6),
}


def contact(radius, alpha, bv):
    smoothing = dict(zip(SMOOTHING, (1e-5, 300.0, bv), strict=True))
    return Contact(SMOOTH, radius, 1e6, alpha, smoothing)


def written(path, contacts):
    path.write_text(model(contacts), encoding="utf-8")
    return path


def inspected(path, count):
    """The spheres of the one limb, as `inspect` gives them."""
    outcome = command.run("inspect", path, *EVERY_BODY, "--mass", MASS, "--spheres", count)
    assert outcome.status == 0, outcome
    (limb,) = outcome.report["figures"]["limbs"]
    return limb["spheres"]


def at_depths(path, contacts, relative):
    """OpenSim's force on each contact at speed 0, as deep in its radius as `relative` says."""
    heights = [[one.radius - x * one.radius, 0.0] for one, x in zip(contacts, relative, strict=True)]
    (found,) = forces(path, [heights])
    return found


@pytest.mark.parametrize("stance", STANCES)
def test_opensim_finds_the_weight_where_spheres_rest(stance, tmp_path):
    radii, count = STANCES[stance]
    cases = list(product(ALPHAS, SPEED_SMOOTHINGS))
    contacts, alone, level, touching = [], [], [], []
    for number, (alpha, bv) in enumerate(cases):
        limb = [contact(radius, alpha, bv) for radius in radii]
        figures = inspected(written(tmp_path / f"case{number}.osim", limb), count)
        assert [one["radius_m"] for one in figures] == list(radii)
        contacts += limb
        alone += [one["relative_indentation_model_law"] for one in figures]
        level += [one["relative_indentation_model_law_level"] for one in figures]
        touching += [one["force_just_touching_n"] for one in figures]
    together = written(tmp_path / "all.osim", contacts)
    share = MASS * GRAVITY / count
    for found in at_depths(together, contacts, alone):
        assert found == pytest.approx(share, rel=TOLERANCE)
    standing = at_depths(together, contacts, level)
    for number, case in enumerate(cases):
        found = sum(standing[number * len(radii) : (number + 1) * len(radii)])
        assert found == pytest.approx(share * len(radii), rel=TOLERANCE), case
    for found, figures in zip(at_depths(together, contacts, [0.0] * len(contacts)), touching, strict=True):
        assert found == pytest.approx(figures, rel=TOLERANCE)


def rests(path, *options):
    """The indentation at which the model's law rests by `drop-test`, in m."""
    outcome = command.run("drop-test", path, "--duration", 0.1, "--samples", 2, *options)
    assert outcome.status == 0, outcome
    report = outcome.report
    return report["relative_indentation_model_law"] * report["reference_radius_m"]


def opensim_leaves(mass, contacts):
    """The indentation at which a body that falls on the contacts comes to rest in OpenSim, in m; it has time until nothing moves."""
    spheres = [{"radius": one.radius, **one.material, **one.smoothing} for one in contacts]
    until = 4 + 1.1 * max(one.dissipation for one in contacts)
    job = {"class": SMOOTH, "mass": mass, "gravity": GRAVITY, "height": 0.25 * contacts[0].radius, "accuracy": 1e-10}
    (fallen,) = drops([job | {"times": [0.0, 0.9 * until, until], "spheres": spheres}])
    _, before, last = (-height for height in fallen["heights"])
    assert last == pytest.approx(before, abs=1e-8), "it still moves"
    return last


DROPS = [
    ((0.032,) * 6, 2.0, 50.0),
    ((0.032,) * 6, 20.0, 50.0),
    ((0.032,) * 6, 50.0, 5.0),
    ((0.015, 0.03, 0.06), 20.0, 15.0),
]


@pytest.mark.parametrize("case", DROPS, ids=str)
def test_a_drop_in_opensim_ends_there(case, tmp_path):
    radii, alpha, bv = case
    contacts = [contact(radius, alpha, bv) for radius in radii]
    path = written(tmp_path / "model.osim", contacts)
    figures = rests(path, *EVERY_BODY, "--mass", MASS, "--spheres", len(radii))
    assert figures == pytest.approx(opensim_leaves(MASS, contacts), abs=TOLERANCE * min(radii))


def test_the_2d_gait_model_rests_at_0_45143(readings, tmp_path):
    """Moco's gait model with a dissipation of 20 s/m. By (C.3) alone it would rest at x/R = 0.44033."""
    source = next((path for path in models.corpus() if path.name == "v40000_moco_2d_gait.osim"), None)
    if source is None:
        pytest.skip(models.NO_CORPUS)
    path = tmp_path / "damped.osim"
    assert command.run("set", source, "dissipation=20", "-o", path).status == 0
    reading = readings[path]
    spheres = {one["path"]: float.fromhex(one["radius"]) for one in reading["spheres"]}
    contacts = []
    for force in reading["forces"]:
        values = {name: float.fromhex(value) for name, value in force["parameters"].items()}
        (radius,) = [spheres[path] for path in force["geometry"] if path in spheres]
        smoothing = {name: values[name] for name in SMOOTHING}
        if force["path"].endswith("_r"):
            contacts.append(Contact(SMOOTH, radius, values["stiffness"], values["dissipation"], smoothing))
    # What x/R of spheres of two radii is told with.
    radius = (sum(one.radius**2 for one in contacts) / len(contacts)) ** 0.5
    gravity = -float.fromhex(reading["gravity"][1])
    # `opensim_leaves` has the fixtures' gravity: the mass makes up for the difference of the weight.
    leaves = opensim_leaves(float.fromhex(reading["mass_sum"]) * gravity / GRAVITY, contacts)
    assert leaves / radius == pytest.approx(0.45143, abs=5e-6)
    assert rests(path) == pytest.approx(leaves, abs=TOLERANCE * radius)
