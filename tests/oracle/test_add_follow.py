"""On a copy that the real OpenSim has scaled, `remove` and `add --from GENERIC --radius follow` give what `transfer --follow-bodies` with
the same radii gives.

Forces with several spheres have one modulus there and one for each sphere here: theirs are compared where all bodies have one factor.
"""

import numpy as np
import pytest

import command
import placing
from test_follow import ALL, bodies_of, mass_of, opensim_scales, uneven

TOLERANCE = 1e-12
S = 0.83


def contacts(reading):
    """`{sphere: (place, radius, parameters, how many spheres the force has)}`"""
    found = list(placing.reference_contacts(reading))
    count = {}
    for force, _ in found:
        count[force["path"]] = count.get(force["path"], 0) + 1
    return {
        sphere["name"]: (
            placing.vector(sphere["centre_in_base"]),
            float.fromhex(sphere["radius"]),
            {name: float.fromhex(value) for name, value in force["parameters"].items()},
            count[force["path"]],
        )
        for force, sphere in found
    }


def both_ways(path, factors, mass, folder, readings):
    """The contacts of both ways, as OpenSim reads them. In a scaled copy the bodies of the generic model count, which `add` asks
    about where its contacts are known ones that were made for another mass."""
    mass_options = ("--reference-mass", repr(mass_of(readings[path]))) if path.stem in command.NEEDS_MASS else ()
    scaled, _, _ = opensim_scales(path, folder, factors, mass)
    bare, added, followed = (folder / f"{name}.osim" for name in ("bare", "added", "followed"))
    for options in (
        ("remove", scaled, "-o", bare),
        ("add", bare, "--from", path, *mass_options, "--radius", "follow", "-o", added),
        ("transfer", scaled, "--from", path, "--follow-bodies", "--radius", "follow", "-o", followed),
    ):
        outcome = command.run(*options)
        assert outcome.status == 0, (options[0], outcome)
    return contacts(readings[added]), contacts(readings[followed])


def check_near(value, expected, where):
    """Asserts that values are equal relative to the longest vector."""
    assert np.max(np.abs(value - expected)) <= TOLERANCE * np.max(np.abs(expected)), (where, value, expected)


def cases():
    """All models, scaled unevenly; and models with several spheres in a force, scaled evenly."""
    for one in ALL:
        yield pytest.param(*one.values, "uneven", id=f"{one.id}-uneven", marks=one.marks)
        if one.id in ("generic_hunt_crossley", "v30000_osim_rl_gait9dof18musc_crlf"):
            yield pytest.param(*one.values, "even", id=f"{one.id}-even", marks=one.marks)


@pytest.mark.parametrize("path, how", list(cases()))
def test_both_ways_lead_to_the_same_contacts(path, how, tmp_path, readings):
    generic = readings[path]
    bodies = bodies_of(generic)
    factors, mass = (uneven(bodies), 0.8) if how == "uneven" else ({body: [S] * 3 for body in bodies}, S**3)
    added, followed = both_ways(path, factors, mass * mass_of(generic), tmp_path, readings)
    assert set(added) == set(followed) and added
    for sphere, (place, radius, numbers, count) in followed.items():
        here = added[sphere]
        check_near(here[0], place, sphere)
        check_near(here[1], radius, sphere)
        assert here[3] == 1 and set(here[2]) == set(numbers)
        if count == 1 or how == "even":
            for name, number in numbers.items():
                check_near(here[2][name], number, (sphere, name))
