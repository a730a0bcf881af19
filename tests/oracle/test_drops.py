"""Drops of Table 1's animals, by both laws, against the real OpenSim; and how far the animals fall alike.

Down to one vertical degree of freedom the two sides share nothing: OpenSim integrates a body on a slider with one force
per sphere, made from the numbers it reads in the fixture (`opensim_drops.py`); the command is given the fixture.
"""

from itertools import pairwise, permutations

import numpy as np
import pytest

import command
import models
from opensim_drops import drops
from test_table1 import KINDS, TABLE

TOLERANCE = 1e-6  # of the range of a series
ACCURACY = 1e-10  # of OpenSim's integrator
DURATION = 2.0  # s
SAMPLES = 401
BASE = 2.0  # s/m, alpha of the 62 kg human
ALPHAS = ("base", "scaled")
QUADRUPEDS = ("mouse", "horse", "giraffe")

GRAVITY = 9.81  # m/s2, of the fixtures
SIMILARITY = 1e-6  # of the range of a dimensionless series
UNTIL = 30  # dimensionless time
EVERY = 20  # samples per unit of it
SETTLING = 8  # the unit of it after which the 62 kg human has nearly come to rest


def fixture(animal, kind):
    return models.FIXTURES / "table1" / f"{animal}_{kind}.osim"


def drop_test(model, animal, duration, samples):
    """The report of `drop-test`."""
    limbs = 2 if animal in QUADRUPEDS else 1
    options = ["--stance-limbs", limbs, "--duration", repr(duration), "--samples", samples]
    outcome = command.run("drop-test", model, *options)
    assert outcome.status == 0, outcome
    return outcome.report


def with_alpha(animal, kind, alpha, folder):
    """The animal's model, its alpha that of the 62 kg human or its own."""
    if alpha == "scaled":
        return fixture(animal, kind)
    output = folder / f"{animal}_{kind}_{alpha}.osim"
    outcome = command.run("set", fixture(animal, kind), f"dissipation={BASE!r}", "-o", output)
    assert outcome.status == 0, outcome
    return output


def job(reading, kind, alpha):
    """The drop as OpenSim computes it, on half of the spheres: one limb of two, two limbs of four."""
    material = {}
    for force in reading["forces"]:
        for path in force["geometry"]:
            material[path] = {name: float.fromhex(value) for name, value in force["parameters"].items()}
    stance = reading["spheres"][: len(reading["spheres"]) // 2]
    spheres = [material[sphere["path"]] | {"radius": float.fromhex(sphere["radius"])} for sphere in stance]
    if alpha == "base":
        spheres = [sphere | {"dissipation": BASE} for sphere in spheres]
    return {
        "class": KINDS[kind],
        "mass": float.fromhex(reading["mass_sum"]),
        "gravity": -float.fromhex(reading["gravity"][1]),
        "height": 0.25 * spheres[0]["radius"],
        "accuracy": ACCURACY,
        "times": [DURATION * k / (SAMPLES - 1) for k in range(SAMPLES)],
        "spheres": spheres,
    }


CASES = [(animal, kind, alpha) for animal in TABLE for kind in KINDS for alpha in ALPHAS]


@pytest.fixture(scope="module")
def fallen(readings):
    """`{case: (job, what OpenSim makes of it)}`"""
    readings.fetch([fixture(animal, kind) for animal in TABLE for kind in KINDS])
    jobs = {case: job(readings[fixture(*case[:2])], *case[1:]) for case in CASES}
    return {case: (jobs[case], found) for case, found in zip(CASES, drops(list(jobs.values())), strict=True)}


@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_series_are_opensims(case, fallen, tmp_path):
    animal, kind, alpha = case
    asked, theirs = fallen[case]
    report = drop_test(with_alpha(animal, kind, alpha, tmp_path), animal, DURATION, SAMPLES)
    assert (len(asked["spheres"]), asked["spheres"][0]["radius"]) == TABLE[animal][1:3]
    assert report["sphere_count"] == len(asked["spheres"])
    assert np.allclose(report["series"]["time_s"], asked["times"], rtol=1e-15, atol=0)
    for name, their in (("height_m", theirs["heights"]), ("force_n", theirs["forces"])):
        assert largest_difference(report["series"][name], their) <= TOLERANCE, name


def largest_difference(ours, theirs):
    """The largest difference of two series as a share of the second one's range."""
    assert len(ours) == len(theirs)
    return np.max(np.abs(np.subtract(ours, theirs))) / np.ptp(theirs)


def curves(model, animal):
    """Height over R and force over body weight at equal steps of t / sqrt(R/g)."""
    mass, _, radius = TABLE[animal][:3]
    weight, unit = mass * GRAVITY, (radius / GRAVITY) ** 0.5
    series = drop_test(model, animal, UNTIL * unit, UNTIL * EVERY + 1)["series"]
    return np.divide(series["height_m"], radius), np.divide(series["force_n"], weight)


@pytest.mark.parametrize("kind", KINDS)
def test_scaled_animals_fall_alike(kind):
    """Fig. 4 B."""
    heights, forces = curves(fixture("human_62kg", kind), "human_62kg")
    assert np.ptp(heights) > 0.5 and np.ptp(forces) > 2
    for animal in TABLE:
        height, force = curves(fixture(animal, kind), animal)
        assert largest_difference(height, heights) <= SIMILARITY, animal
        assert largest_difference(force, forces) <= SIMILARITY, animal


@pytest.mark.parametrize("kind", KINDS)
def test_with_one_alpha_the_smaller_swings_the_longer(kind, tmp_path):
    """Fig. 4 A: "smaller models being progressively more underdamped", the mouse most of all."""
    forces = {animal: curves(with_alpha(animal, kind, "base", tmp_path), animal)[1] for animal in TABLE}
    unrest = {animal: np.max(np.abs(force[SETTLING * EVERY :] - 1)) for animal, force in forces.items()}
    for one, other in permutations(TABLE, 2):
        if TABLE[one][2] < TABLE[other][2]:
            assert unrest[one] > 1.01 * unrest[other], (one, other)
    assert unrest["mouse"] > 50 * unrest["giraffe"]
    assert swings(forces["mouse"]) > 2 * swings(forces["giraffe"])
    assert largest_difference(forces["mouse"], forces["giraffe"]) > 0.2


def swings(force):
    """How often a force passes body weight with at least a thousandth of it on either side of the passage."""
    side = [value > 1 for value in force if abs(value - 1) > 1e-3]
    return sum(one != next_one for one, next_one in pairwise(side))
