"""Models stand on the contacts that `add` makes: the body locked above one foot, in the real OpenSim.

At the default pose the spheres of a foot are not level: each is as deep as its own height says. The height at which they carry the
body is found in NumPy; OpenSim finds the weight there, and `inspect` prints the same x/R.
"""

import numpy as np
import pytest

import command
import law
import models
import placing
import rules
from add_cases import GENERIC, HUMAN
from opensim_anatomy import anatomies
from opensim_drops import drops
from opensim_shifts import at, shifted
from test_follow import bodies_of, mass_of, opensim_scales

TOLERANCE = 1e-6  # of the load, and of x/R
LEVEL = 1e-9  # m
S = 1.3


def limb(reading, side):
    """`(sphere, type, radius, parameters, force path, where the record has the force on the body)` of each contact of one side."""
    for force, sphere in placing.reference_contacts(reading):
        body = sphere["base"].rsplit("/", 1)[-1]
        if body.endswith(f"_{side}"):
            numbers = {name: float.fromhex(value) for name, value in force["parameters"].items()}
            on = "Sphere" if force["type"] == rules.SMOOTH_SET else body
            yield sphere["name"], force["type"], float.fromhex(sphere["radius"]), numbers, force["path"], f"{on}.force.Y"


def carried(spheres, heights, load, kind=None):
    """Relative indentations of spheres that together carry the load, by their own force law, or by the law of `kind`."""

    def total(down):
        return sum(law.force(kind or own, r, numbers, down - heights[name]) for name, own, r, numbers, *_ in spheres)

    down = law.resting(total, load, min(heights.values()) - 1, max(heights.values()) + 1)
    return down, {name: (down - heights[name]) / radius for name, _, radius, *_ in spheres}


CORPUS = {path.stem: path for path in models.corpus()}
STANDING = [
    ("v40000_gait2392_without_contacts", None),
    ("v40000_rajagopal_2016_without_contacts", None),
    ("v40600_moco_3d_walking_model_without_contacts", "v40000_opencap_lai_arnold_crlf"),
    ("v40000_gait10dof18musc_without_contacts", "v40000_human_12_hunt_crossley"),
]


@pytest.fixture(scope="module")
def standing(tmp_path_factory, readings):
    """`{model: (path, reading, anatomy)}` of the models with contacts."""
    if not CORPUS:
        pytest.skip(models.NO_CORPUS)
    paths = {}
    for name, reference in STANDING:
        paths[name] = tmp_path_factory.mktemp("standing") / f"{name}.osim"
        asked = ["--reference-mass", "62"] if reference in command.NEEDS_MASS else []
        outcome = command.run("add", CORPUS[name], "--from", CORPUS[reference] if reference else "falisse2022", *asked, "-o", paths[name])
        assert outcome.status == 0, outcome
    readings.fetch(paths.values())
    known = anatomies(paths.values())
    return {name: (path, readings[path], known[str(path)]) for name, path in paths.items()}


def bottoms(anatomy, spheres):
    """Heights of the lowest points above the floor at the default pose."""
    floor = placing.floor_of(anatomy)["centre"][1]
    by_key = {sphere["name"]: sphere["centre"][1] - sphere["radius"] - floor for sphere in anatomy["spheres"]}
    return {name: by_key[name] for name, *_ in spheres}


def weight(reading):
    return float.fromhex(reading["mass_sum"]) * np.linalg.norm(placing.vector(reading["gravity"]))


@pytest.mark.parametrize("side", ["r", "l"])
@pytest.mark.parametrize("name", [name for name, _ in STANDING])
def test_one_foot_carries_the_body_at_its_own_heights(name, side, standing):
    path, reading, anatomy = standing[name]
    spheres = list(limb(reading, side))
    heights = bottoms(anatomy, spheres)
    down, wanted = carried(spheres, heights, weight(reading))
    ((state,),) = shifted([(path, at([-down]))])
    floor = placing.floor_of(anatomy)["centre"][1]
    assert sum(state["forces"][force][on] for *_, force, on in spheres) == pytest.approx(weight(reading), rel=TOLERANCE)
    for sphere, _, radius, *_ in spheres:
        assert (floor - (state["heights"][sphere] - radius)) / radius == pytest.approx(wanted[sphere], abs=TOLERANCE)


def figures_by_sphere(path, side):
    """The figures of indentation that `inspect` gives for each sphere of one limb."""
    outcome = command.inspect(path)
    assert outcome.status == 0, outcome
    (own,) = [one for one in outcome.report["figures"]["limbs"] if one["side"] == {"r": "right", "l": "left"}[side]]
    return {one["sphere"]: {key: value for key, value in one.items() if key.startswith("relative_indentation")} for one in own["spheres"]}


@pytest.mark.parametrize("name", [name for name, _ in STANDING])
def test_inspect_prints_how_deep_each_sphere_is_at_its_own_height(name, standing):
    """By the Hertz law and by the model's own, among the figures of the sphere."""
    path, reading, anatomy = standing[name]
    spheres = list(limb(reading, "r"))
    heights = bottoms(anatomy, spheres)
    assert np.ptp(list(heights.values())) > 1e-4, "level: nothing to tell apart"
    figures = figures_by_sphere(path, "r")
    for kind in (None, "Hertz"):
        _, wanted = carried(spheres, heights, weight(reading), kind)
        for sphere, x in wanted.items():
            assert any(abs(x - value) < TOLERANCE for value in figures[sphere].values()), (sphere, kind, x, figures[sphere])


def test_gait2392_stands_at_0_333_and_0_392(standing):
    """By the Hertz law: the toes' spheres are 2 mm lower. (11) says 0.353 of spheres of one height."""
    path, reading, anatomy = standing["v40000_gait2392_without_contacts"]
    spheres = list(limb(reading, "r"))
    _, wanted = carried(spheres, bottoms(anatomy, spheres), weight(reading), "Hertz")
    assert [round(x, 3) for x in wanted.values()] == [0.333] * 4 + [0.392] * 2
    _, level = carried(spheres, dict.fromkeys(wanted, 0.0), weight(reading), "Hertz")
    for sphere, figures in figures_by_sphere(path, "r").items():
        assert figures["relative_indentation_hertz"] == pytest.approx(level[sphere], abs=TOLERANCE)
        assert round(level[sphere], 3) == 0.353


def test_a_level_foot_rests_where_11_says(tmp_path, readings):
    """The 62 kg human with the contacts of the 500 kg human's: x/R is the same, and OpenSim finds the weight there."""
    model, reference = HUMAN / "human_62kg_hunt_crossley.osim", HUMAN / "human_500kg_hunt_crossley.osim"
    bare, path = tmp_path / "bare.osim", tmp_path / "added.osim"
    assert command.run("remove", model, "-o", bare).status == 0
    factors = [f"--body-scale={body}_{side}={(62 / 500) ** (1 / 3)!r}" for body in ("calcn", "toes") for side in "rl"]
    outcome = command.run("add", bare, "--from", reference, *factors, "-o", path)
    assert outcome.status == 0, outcome
    reading, anatomy = readings[path], anatomies([path])[str(path)]
    spheres = list(limb(reading, "r"))
    heights = bottoms(anatomy, spheres)
    assert np.ptp(list(heights.values())) < LEVEL, heights
    _, _, radius, numbers, *_ = spheres[0]
    load = 62 * 9.81
    x = (3 * load / (4 * radius**2 * numbers["stiffness"] / 2**1.5 * len(spheres))) ** (2 / 3)
    assert round(x, 4) == 0.3533  # of the paper's Table 1
    ((state,),) = shifted([(path, at([-min(heights.values()) - x * radius]))])
    assert sum(state["forces"][force][on] for *_, force, on in spheres) == pytest.approx(load, rel=TOLERANCE)


def fall(reading, span, count=60):
    """A drop of the right foot's spheres, for `span` of the time that its size gives; and what makes it free of dimensions."""
    spheres = list(limb(reading, "r"))
    radius = float(np.mean([one[2] for one in spheres]))
    gravity = -placing.vector(reading["gravity"])[1]
    names = set(rules.PROPERTIES) & set(spheres[0][3])
    job = {
        "class": spheres[0][1],
        "mass": float.fromhex(reading["mass_sum"]),
        "gravity": gravity,
        "height": 0.25 * radius,
        "accuracy": 1e-10,
        "times": [span * (radius / gravity) ** 0.5 * k / (count - 1) for k in range(count)],
        "spheres": [{"radius": r, **{name: numbers[name] for name in names}} for _, _, r, numbers, *_ in spheres],
    }
    return job, radius, float.fromhex(reading["mass_sum"]) * gravity


@pytest.mark.parametrize("kind", ["smooth", "hunt_crossley"])
def test_it_falls_like_the_reference(kind, tmp_path, readings):
    """All bodies by one factor, mass by its cube, `--radius follow`: heights in R and forces in body weight are the same."""
    generic = GENERIC / f"generic_{kind}.osim"
    factors = {body: [S] * 3 for body in bodies_of(readings[generic])}
    scaled, _, _ = opensim_scales(generic, tmp_path, factors, mass_of(readings[generic]) * S**3)
    bare, path = tmp_path / "bare.osim", tmp_path / "added.osim"
    assert command.run("remove", scaled, "-o", bare).status == 0
    outcome = command.run("add", bare, "--from", generic, "--radius", "follow", "-o", path)
    assert outcome.status == 0, outcome
    both = [fall(readings[model], 8.0) for model in (generic, path)]
    found = drops([job for job, _, _ in both])
    for name, unit in (("heights", 1), ("forces", 2)):
        one, other = (np.array(series[name]) / known[unit] for series, known in zip(found, both, strict=True))
        assert np.ptp(one) > 0.3
        assert np.max(np.abs(one - other)) <= TOLERANCE * np.ptp(one), name
