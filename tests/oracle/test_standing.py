"""Bodies on their feet: with the coordinate that `inspect` says, the contact forces of the real OpenSim carry the weight.

As posed, on all feet, and on one limb alone; and each sphere carries what `inspect` says of it. The weight is that of the bodies which
OpenSim moves with the coordinate.
"""

from functools import cache, partial

import pytest

import command
import models
from opensim_standing import all_standings

TOLERANCE = 1e-6  # of the load
FIXTURES = [path for folder in ("feet", "drawn_feet") for path in sorted((models.FIXTURES / folder).glob("*.osim"))]
MODELS = models.fixtures("reads") + FIXTURES + models.corpus()
HOW = ("as_posed", "on_one_limb")
# In the records of a SmoothSphereHalfSpaceForce the body is called so.
SPHERE = "Sphere"


@cache
def inspected(path):
    outcome = command.inspect(path, *standing_report(path))
    return outcome.report if outcome.status == 0 else None


def standing_report(path):
    return ("--mass", "78.2") if path.stem in command.NEEDS_MASS else ()


def standing(path, how):
    """The bodies that a coordinate puts on their feet, as posed or on one limb."""
    report = inspected(path)
    if report is None or any(force["parameters"].get("constant_contact_force") == 0 for force in report["forces"]):
        # OpenSim divides 0 by 0 where cf is 0 and nothing slips.
        return []
    if path.stem == "surface_named_twice":
        # OpenSim presses each pair twice, which is why the model has a warning.
        return []
    return [body for body in report["standing"] if body["coordinate"] and body[how] and body["weight_n"]]


@cache
def opensim(path):
    """`{(how, spheres alone or None): answer of OpenSim}` where all bodies stand: all of a model at once, because starting costs most."""
    asked = {}
    for how in HOW:
        bodies = standing(path, how)
        values = [[body["joint"], body["coordinate"], body[how]["value_m"]] for body in bodies]
        spheres = [sphere["path"] for body in bodies for sphere in body[how]["spheres"]]
        for alone in {None, *map(partial(alone_of, path), spheres)} if bodies else ():
            asked[how, alone] = [values, alone and list(alone)]
    return dict(zip(asked, all_standings(path, list(asked.values())), strict=True))


def alone_of(path, sphere):
    """The spheres that press alone to see the force on this one; None where its force presses no other."""
    return (sphere,) if shares_its_force(path, sphere) else None


def pressing(path):
    """`{force path: {spheres' paths}}` of the forces that apply."""
    report = inspected(path)
    paths = {}
    for force in report["forces"]:
        own = [sphere["path"] for sphere in report["spheres"] if sphere["name"] in force["spheres"]]
        if force["applies"]:
            paths.setdefault(force["path"], (force["type"], set()))[1].update(own)
    return paths


def on_sphere(path, found, sphere):
    """The forces that press `sphere`, and those that press all others of its body."""
    body = next(one["body"] for one in inspected(path)["spheres"] if one["path"] == sphere)
    total = 0.0
    for force, (kind, spheres) in pressing(path).items():
        if sphere in spheres:
            total += found["forces"][force][SPHERE if kind.startswith("Smooth") else body]
    return total


def shares_its_force(path, sphere):
    """Whether a HuntCrossleyForce that presses it presses another sphere, too: OpenSim tells bodies apart, not spheres."""
    return any(sphere in spheres and len(spheres) > 1 for _, spheres in pressing(path).values())


def floor_of(path, found):
    """The part of gravity along the normal of the floors: of all planes that lean by less than 45 degrees, which are alike."""
    floors = [slope for slope in found["slopes"] if slope > 2**-0.5] or [1.0]
    assert max(floors) - min(floors) < 1e-9, path
    return floors[0]


def standing_models(how):
    return [path for path in MODELS if standing(path, how)]


@pytest.mark.parametrize("path", MODELS, ids=models.label)
@pytest.mark.parametrize("how", HOW)
def test_the_coordinate_puts_it_on_its_feet(path, how):
    bodies = standing(path, how)
    if not bodies:
        # Nothing stands there; the next test counts the others.
        return
    together = opensim(path)[how, None]
    slope = floor_of(path, together)
    for body, moved in zip(bodies, together["moved"], strict=True):
        assert body["mass_kg"] == pytest.approx(moved, rel=1e-12)
        rest = body[how]
        weight = body["mass_kg"] * together["gravity"] * slope
        assert rest["load_n"] == pytest.approx(weight, rel=TOLERANCE)
        total = 0.0
        for sphere in rest["spheres"]:
            force = on_sphere(path, opensim(path)[how, alone_of(path, sphere["path"])], sphere["path"])
            assert force == pytest.approx(sphere["force_n"], rel=TOLERANCE, abs=TOLERANCE * weight), sphere
            total += force
        assert total == pytest.approx(weight, rel=TOLERANCE)


@pytest.mark.parametrize("how", HOW)
def test_so_many_models_stand(how):
    """Most fixtures, and of the corpus those with limbs on a floor whose joints are understood."""
    result = [models.label(path) for path in standing_models(how)]
    corpus_models = [one for one in result if one.startswith("corpus")]
    assert len(result) - len(corpus_models) >= 190
    assert len(corpus_models) >= 11 or not models.corpus()
