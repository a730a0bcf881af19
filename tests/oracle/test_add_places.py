"""Contacts that `add` makes at places of the model's own, in the real OpenSim: those of a table, MuSkeMo's among them, and those under
bones. Places come from the tables and from OpenSim's frames in NumPy; a foot carries the body at the indentation that was wanted.
"""

import csv
import io

import numpy as np
import pytest

import command
import models
import placing
import rules
from opensim_anatomy import anatomies
from opensim_shifts import at, shifted
from test_stands import bottoms, limb, weight

TABLES = models.FIXTURES / "contact_tables"
FEET = models.FIXTURES / "feet"
EXACT = 1e-12  # of a number, and m
LEVEL = 1e-9  # m
TOLERANCE = 1e-6  # of the load
INDENTATION = 0.16  # x/R
RADIUS = 0.03  # m
PAD = 0.01  # m
BODIES = "calcn_r,toes_r,calcn_l,toes_l"
COUNTS = (2, 4, 6)


def with_bones():
    """Models without contacts whose feet have meshes at hand."""
    corpus = [path for path in models.corpus() if "without_contacts" in path.name and b'name="toes_r"' in path.read_bytes()]
    return [FEET / "human_30000.osim", FEET / "human_40000.osim", *corpus]


@pytest.fixture(scope="module")
def under_bones(tmp_path_factory, readings):
    """`{(model, count): (path, reading, anatomy)}`, Hunt-Crossley forces of a wanted indentation."""
    folder = tmp_path_factory.mktemp("bones")
    paths = {}
    for model in with_bones():
        for count in COUNTS:
            path = paths[model.stem, count] = folder / f"{model.stem}_{count}.osim"
            options = ["--feet", BODIES, "--count", count, "--pad", PAD, "--radius", RADIUS, "--class", "hunt-crossley"]
            outcome = command.run("add", model, *options, "--indentation", INDENTATION, "--restitution", 0.5, "-o", path)
            assert outcome.status == 0, outcome
            back = folder / "back.osim"
            assert command.run("remove", path, "-o", back, "--force").status == 0
            assert back.read_bytes() == model.read_bytes(), path
    readings.fetch(paths.values())
    known = anatomies(paths.values())
    return {key: (path, readings[path], known[str(path)]) for key, path in paths.items()}


CASES = [(model.stem, count) for model in with_bones() for count in COUNTS]


@pytest.mark.parametrize(("name", "count"), CASES)
def test_spheres_under_bones_are_level_and_mirrored(name, count, under_bones):
    _, reading, anatomy = under_bones[name, count]
    own = {sphere["name"]: (sphere["base"], placing.vector(sphere["centre_in_base"])) for sphere in reading["spheres"]}
    assert len(own) == 2 * count
    for side in "rl":
        heights = bottoms(anatomy, list(limb(reading, side)))
        assert len(heights) == count
        assert np.ptp(list(heights.values())) < LEVEL, heights
    for sphere, (body, place) in own.items():
        if sphere.endswith("_r"):
            other, image = own[f"{sphere[:-1]}l"]
            assert other == f"{body[:-1]}l"
            assert np.max(np.abs(place * [1, 1, -1] - image)) < LEVEL, sphere


@pytest.mark.parametrize(("name", "count"), CASES)
def test_a_foot_on_spheres_under_bones_carries_the_body_where_it_was_wanted(name, count, under_bones):
    path, reading, anatomy = under_bones[name, count]
    spheres = list(limb(reading, "r"))
    load = weight(reading)
    stiffness = 2**1.5 * 3 * load / count / (4 * RADIUS**2 * INDENTATION**1.5)  # (11), (A.4)
    for _, kind, radius, numbers, *_ in spheres:
        assert (kind, radius) == ("HuntCrossleyForce", RADIUS)
        assert numbers["stiffness"] == pytest.approx(stiffness, rel=EXACT)
        assert [numbers[one] for one in ("static_friction", "dynamic_friction", "viscous_friction")] == [0, 0, 0]
    (bottom, *_) = bottoms(anatomy, spheres).values()
    ((state,),) = shifted([(path, at([-bottom - INDENTATION * RADIUS]))])
    assert sum(state["forces"][force][on] for *_, force, on in spheres) == pytest.approx(load, rel=TOLERANCE)


def rows(table):
    """`{sphere: (body, place in ground or None, place in the body or None, radius or None)}` of a table with commas."""
    result = {}
    for row in csv.DictReader(io.StringIO((TABLES / table).read_text(encoding="utf-8"))):
        if "name" in row:
            place = np.array([float(row[axis]) for axis in "xyz"])
            result[row["name"]] = (row["body"], None, place, float(row["radius"]))
            continue
        in_ground, local = ([float(row[f"pos_{axis}_in_{frame}{unit}"]) for axis, unit in (("x", "(m)"), ("y", ""), ("z", ""))]
                         for frame in ("global", "local"))
        local = None if np.isnan(local).any() else np.array(local)
        result[row["CONTACT_name"]] = (row["parent_body"], np.array(in_ground), local, None)
    return result


@pytest.mark.parametrize(
    ("model", "table", "more"),
    [
        (FEET / "human_30000.osim", "own.csv", []),
        (FEET / "human_40000.osim", "own.csv", []),
        (FEET / "human_30000.osim", "muskemo_local.csv", []),
        (FEET / "human_40000.osim", "muskemo_local.csv", []),
        (FEET / "human_40000.osim", "muskemo_global.csv", ["--default-pose"]),
        (TABLES / "global_mode.osim", "muskemo_global.csv", []),
    ],
)
def test_contacts_of_a_table_are_where_it_says(model, table, more, tmp_path, readings):
    path = tmp_path / "added.osim"
    outcome = command.run("add", model, "--contacts", TABLES / table, "--from", "falisse2022", *more, "-o", path)
    assert outcome.status == 0, outcome
    reading = readings[path]
    anatomy = anatomies([path])[str(path)]
    expected = rows(table)
    result = {sphere["name"]: (force, sphere) for force, sphere in placing.reference_contacts(reading)}
    assert set(result) == set(expected)
    mass = float.fromhex(reading["mass_sum"])
    for name, (body, in_ground, local, radius) in expected.items():
        force, sphere = result[name]
        assert sphere["base"] == f"/bodyset/{body}"
        place = local if local is not None else placing.seen_from(anatomy, body, "ground", in_ground)
        assert np.max(np.abs(placing.vector(sphere["centre_in_base"]) - place)) < EXACT, name
        # Falisse's: 62 kg on 6 spheres of 0.032 m; here on 2 of a limb.
        radius = radius or 0.032 * (mass / 62) ** (1 / 3)
        assert float.fromhex(sphere["radius"]) == pytest.approx(radius, rel=EXACT)
        numbers = {key: float.fromhex(value) for key, value in force["parameters"].items()}
        ratio = radius / 0.032
        assert force["type"] == rules.SMOOTH_SET
        assert numbers["stiffness"] == pytest.approx(1e6 * mass / 62 * 3 / ratio**2, rel=EXACT)  # (10)
        assert numbers["dissipation"] == pytest.approx(2 / ratio**0.5, rel=EXACT)  # (14)
        assert numbers["constant_contact_force"] == pytest.approx(1e-5 * ratio**2, rel=EXACT)  # (C.2)
        assert numbers["hertz_smoothing"] == pytest.approx(300 / ratio, rel=EXACT)  # (C.5)
        assert numbers["hunt_crossley_smoothing"] == pytest.approx(50 / ratio**0.5, rel=EXACT)  # (C.10)
        frictions = [numbers[one] for one in ("static_friction", "dynamic_friction", "viscous_friction", "transition_velocity")]
        assert frictions == [0.8, 0.8, 0.5, 0.2]


def test_what_is_in_ground_in_a_table_is_there_in_opensim():
    """The fixtures say of `human_40000.osim` what OpenSim says."""
    anatomy = anatomies([FEET / "human_40000.osim"])[str(FEET / "human_40000.osim")]
    for body, in_ground, local, _ in rows("muskemo_local.csv").values():
        assert np.max(np.abs(placing.placed(anatomy, body, local) - in_ground)) < 1e-12
