"""Contacts that `add` makes, as the real OpenSim reads them: places, radii, parameters, class and floor by NumPy, and nothing else.

Every model of the corpus without contacts, and our own in documents of nine versions and five forms. What is expected comes from the
rules in `placing.py`, with the reference's and the model's meshes and joints as OpenSim reads them.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

import add_variants
import command
import compare
import dumps
import law
import placing
import rules
from add_cases import ALL, CASES, PRESET, VARIANTS, Case
from models import FIXTURES
from opensim_anatomy import anatomies
from opensim_shifts import at, shifted

TOLERANCE = 1e-12
DEPTH = 0.01  # m
FORCES = 1e-8  # of a force: a depth of 10 mm is a difference of two heights
MIRRORED = 1e-9  # m


@pytest.fixture(scope="module")
def variants(tmp_path_factory):
    """`{name: path}` of the models made here."""
    folder = tmp_path_factory.mktemp("documents")
    paths = {}
    for name, text in add_variants.chosen():
        paths[name] = folder / f"{name}.osim"
        paths[name].write_text(text, encoding="utf-8")
    return paths


@dataclass
class Added:
    """The model of one case after `add`, and the report of the command."""

    case: Case
    before: Path
    outcome: command.Outcome
    after: Path
    known: dict = field(default_factory=dict)

    def of(self, path):
        """OpenSim's anatomy of a model."""
        assert "error" not in self.known[str(path)], self.known[str(path)]
        return self.known[str(path)]


@pytest.fixture(scope="module")
def added_models(readings, variants, tmp_path_factory):
    """All cases, and what OpenSim reads of them, two at a time."""
    folder = tmp_path_factory.mktemp("added")
    cases = CASES | {name: Case(path) for name, path in variants.items()}
    readings.fetch({case.reference for case in cases.values()})
    done = {}
    for name, case in cases.items():
        before = case.model
        if case.bare:
            before = folder / f"{name}.bare.osim"
            assert command.run("remove", case.model, "-o", before).status == 0
        after = folder / f"{name}.osim"
        done[name] = Added(case, before, command.run("add", before, *case.options(readings[case.reference]), "-o", after), after)
    there = [added for added in done.values() if added.after.exists()]
    readings.fetch({path for added in there for path in (added.before, added.after)})
    anatomy_by_path = anatomies({path for added in done.values() for path in (added.before, added.after, added.case.reference) if path.exists()})
    for added in done.values():
        added.known = anatomy_by_path
    return done


def contacts(reading):
    """`{sphere: (force, sphere)}`, one force for one sphere."""
    result = [(force, sphere) for force, sphere in placing.reference_contacts(reading)]
    assert len({sphere["path"] for _, sphere in result}) == len({force["path"] for force, _ in result}) == len(result)
    return {sphere["name"]: (force, sphere) for force, sphere in result}


def check_near(value, expected, where):
    """Asserts that values are equal relative to the longest vector."""
    value, expected = np.asarray(value), np.asarray(expected)
    assert np.max(np.abs(value - expected)) <= TOLERANCE * np.max(np.abs(expected)), (where, value, expected)


def expected_additions(added, readings):
    """The contacts that the rules give."""
    case, reference = added.case, readings[added.case.reference]
    # A preset has no joints but one of a foot, which no model's sizes can contradict: it is no generic model.
    rule = {
        "mass": float.fromhex(readings[added.before]["mass_sum"]),
        "reference_mass": float.fromhex(reference["mass_sum"]),
        "radius": case.radius if case.radius in ("isometric", "follow") else float(case.radius),
        "given": case.given,
        "body_map": case.body_map,
        "is_copy": False if case.reference == PRESET else None,
    }
    return placing.expected((reference, added.of(case.reference)), (readings[added.before], added.of(added.before)), rule)


@pytest.mark.parametrize("name", ALL)
def test_contacts_are_those_of_the_rules(name, added_models, readings):
    added = added_models[name]
    assert added.outcome.status == 0, (added.outcome.error, added.outcome.stderr)
    reading, expected = readings[added.after], expected_additions(added, readings)
    assert reading["builds"], reading
    found = contacts(reading)
    assert set(found) == set(expected)
    for sphere, (body, place, radius, kind, numbers) in expected.items():
        force, there = found[sphere]
        assert (there["base"].rsplit("/", 1)[-1], force["type"], force["applies"]) == (body, kind, True), sphere
        check_near(placing.vector(there["centre_in_base"]), place, sphere)
        check_near(float.fromhex(there["radius"]), radius, sphere)
        assert set(force["parameters"]) == set(numbers)
        for parameter, number in numbers.items():
            check_near(float.fromhex(force["parameters"][parameter]), number, (sphere, parameter))
    planned_is_read(added.outcome.report, reading)


def planned_is_read(report, reading):
    """Each `to` of the report is what OpenSim reads, bit for bit."""
    for change in report["changes"]:
        place = change["path"], change["set"], change["property"]
        if place[2] == "location":
            sphere = next(sphere for sphere in reading["spheres"] if sphere["path"] == place[0])
            assert [compare.hexed(one) for one in change["to"]] == sphere["location"], place
        else:
            assert compare.hexed(change["to"]) == compare.value(reading, place), place


@pytest.fixture
def added(name, added_models):
    """The result of a case; that it was not refused is tested above, once."""
    if added_models[name].outcome.status != 0:
        pytest.skip(f"refused: {added_models[name].outcome.error}")
    return added_models[name]


@pytest.mark.parametrize("name", ALL)
def test_the_floor_is_the_models_or_at_height_0(added, readings):
    before, after = placing.floor_of(added.of(added.before)), placing.floor_of(added.of(added.after))
    assert after == (before or after | {"centre": [0.0, 0.0, 0.0]}), (before, after)
    planes = {plane["path"] for plane in readings[added.after]["half_spaces"]}
    assert len(planes) == len(readings[added.before]["half_spaces"]) + (before is None)
    for force in readings[added.after]["forces"]:
        assert planes & set(force["geometry"]) == {after["path"]}, force["path"]


@pytest.mark.parametrize("gravity", ["0 0 -9.81", "-9.81 0 0", "0 9.81 0", "0.5 -9.8 0.25"])
def test_the_floor_that_is_made_faces_up(gravity, tmp_path):
    """Against gravity, whichever axis of ground that is."""
    before, after = tmp_path / "before.osim", tmp_path / "after.osim"
    text = (FIXTURES / "feet" / "human_40000.osim").read_text(encoding="utf-8")
    before.write_text(re.sub("<gravity>.*</gravity>", f"<gravity>{gravity}</gravity>", text), encoding="utf-8")
    outcome = command.run("add", before, "--contacts", FIXTURES / "contact_tables" / "own.csv", "--from", "falisse2022", "-o", after)
    assert outcome.status == 0, outcome.error
    anatomy = anatomies({after})[str(after)]
    assert np.allclose(anatomy["gravity"], [float(value) for value in gravity.split()])
    assert placing.floor_of(anatomy)["centre"] == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("name", ALL)
def test_nothing_else_has_changed(added, readings):
    """All defaults spelled out: without what was added and the note in the credits, OpenSim has the model of before."""
    before, after = readings[added.before], readings[added.after]
    assert dumps.has_note(after["dump"])
    paths = {path for force in after["forces"] for path in (force["path"], *force["geometry"])}
    old = {one["path"] for kind in ("spheres", "half_spaces", "forces") for one in before[kind]}
    new = {path.rsplit("/", 1)[-1] for path in paths - old}
    kinds = ("ContactSphere", "ContactHalfSpace", rules.SMOOTH_SET, "HuntCrossleyForce")
    bare = dumps.without_elements(after["dump"], lambda tag, name: tag in kinds and name in new)
    assert bare == dumps.without_elements(before["dump"], lambda *_: False)


@pytest.fixture(scope="module")
def pushed(added_models):
    """`{name: {depth above which sphere: ...}}`: OpenSim's forces with each sphere's bottom 10 mm in the floor."""
    jobs, names = [], []
    for name, added in added_models.items():
        if added.outcome.status == 0 and "error" not in added.known[str(added.after)]:
            floor = placing.floor_of(added.of(added.after))["centre"][1]
            tops = {round(s["centre"][1] - s["radius"], 9): s for s in added.of(added.after)["spheres"]}
            jobs.append((added.after, at(floor + s["radius"] - DEPTH - s["centre"][1] for s in tops.values())))
            names.append(name)
    return dict(zip(names, shifted(jobs), strict=True))


@pytest.mark.parametrize("name", ALL)
def test_spheres_in_the_floor_are_pushed_out(name, added, readings, pushed):
    """The depths follow the law of the paper and agree with OpenSim."""
    assert "error" not in pushed[name], pushed[name]
    floor = placing.floor_of(added.of(added.after))["centre"][1]
    found, deep = contacts(readings[added.after]), set()
    for state in pushed[name]:
        for sphere, (force, there) in found.items():
            radius = float.fromhex(there["radius"])
            x = floor - (state["heights"][sphere] - radius)
            deep |= {sphere} if abs(x - DEPTH) < 1e-8 else set()
            numbers = {key: float.fromhex(value) for key, value in force["parameters"].items()}
            expected = law.force(force["type"], radius, numbers, x)
            on = "Sphere" if force["type"] == rules.SMOOTH_SET else there["base"].rsplit("/", 1)[-1]
            upward = state["forces"][force["path"]][f"{on}.force.Y"]
            assert upward == pytest.approx(expected, rel=FORCES, abs=1e-6), (sphere, x)
            assert upward > 1 or x < DEPTH / 2, (sphere, x)
    assert deep == set(found)


@pytest.mark.parametrize("name", ALL)
def test_left_is_the_mirror_image_of_right(added, readings):
    """Left spheres are mirror images of right ones if the meshes' factors and the reference's spheres are."""
    sizes = placing.Sizes(added.of(added.before), added.of(added.case.reference), added.case.given, False)
    bodies = {sphere["base"].rsplit("/", 1)[-1] for sphere in readings[added.after]["spheres"]}
    factors = [[added.case.given.get(body, sizes.mesh(body)) for body in (body, placing.other_side(body))] for body in bodies]
    if any(one is None or other is None or not np.allclose(one, other, rtol=1e-12, atol=0) for one, other in factors):
        pytest.skip("the meshes of both sides do not have the same factors")
    if asymmetry(readings[added.case.reference]) > 0:
        pytest.skip("the reference's sides are no mirror images")
    assert asymmetry(readings[added.after]) < MIRRORED


def asymmetry(reading):
    """How far the spheres of one side are from the mirror images of the others, in their bodies' frames, and how the radii differ, m."""
    spheres = {one["name"]: one for one in reading["spheres"] if one["base"] not in reading["fixed"]}
    result = []
    for name, right in spheres.items():
        other = name.replace("r_", "l_", 1) if name.startswith("r_") else f"{name[:-1]}l" if name.endswith("_r") else None
        if other in spheres:
            place, mirrored = (placing.vector(one["centre_in_base"]) for one in (right, spheres[other]))
            result += [np.abs(place * (1, 1, -1) - mirrored).max()]
            result += [abs(float.fromhex(right["radius"]) - float.fromhex(spheres[other]["radius"]))]
    assert len(result) == len(spheres), "not all spheres are of a side"
    return max(result)


FLOOR = re.compile(r"pose (\S+), the lowest sphere, is (\S+) mm too (low|high)(?:; to start there, (\S+)(?: of \S+)? = (\S+) \(now ([^;)]+)[;)])?")
PRINTED = 1e-6  # m


@pytest.mark.parametrize("name", ALL)
def test_the_way_to_the_floor_is_reported(added):
    """How far the lowest bottom is from the floor where OpenSim starts, and the coordinate with which it stands (test_standing.py: carries)."""
    anatomy = added.of(added.after)
    floor = placing.floor_of(anatomy)["centre"][1]
    spheres = [one for one in anatomy["spheres"] if one["body"] != "ground"]
    bottoms = {one["name"]: one["centre"][1] - one["radius"] - floor for one in spheres}
    (note,) = [match for note in added.outcome.report["remarks"] if (match := FLOOR.search(note))]
    sphere, distance, side, coordinate, there, now = note.groups()
    lowest = min(bottoms.values())
    assert bottoms[sphere] == pytest.approx(lowest, abs=1e-9)
    # In tenths of a millimetre, from one metre on in millimetres.
    rounding_mm = 0.06 if float(distance) < 1000 else 0.5
    assert float(distance) * (1 if side == "high" else -1) == pytest.approx(lowest * 1000, abs=rounding_mm)
    # A coordinate that has no element in the file has only OpenSim's name for it.
    if coordinate not in anatomy["coordinates"]:
        assert added.case.model.stem in VARIANTS
    else:
        assert float(now) == pytest.approx(anatomy["coordinates"][coordinate], abs=PRINTED)
        # It stands lower than where it touches, by less than the radius.
        depth = anatomy["coordinates"][coordinate] - lowest - float(there)
        assert 0 < depth < max(one["radius"] for one in spheres)


# OpenCap's: generate_model_with_contacts of opencap-processing (Apache-2.0), places of its reference spheres.
OPENCAP = {
    "s1": ("calcn", (0.0019011578840796601, -0.01, -0.00382630379623308)),
    "s2": ("calcn", (0.14838639994206301, -0.01, -0.028713422052654002)),
    "s3": ("calcn", (0.13300117060705099, -0.01, 0.051636247344956601)),
    "s4": ("calcn", (0.066234666199163503, -0.01, 0.026364160674169801)),
    "s5": ("toes", (0.059999999999999998, -0.01, -0.018760308461917698)),
    "s6": ("toes", (0.044999999999999998, -0.01, 0.061856956754965199)),
}
OPENCAP_FACTORS = 0.91392399999999996


@pytest.mark.parametrize("name", [name for name in ALL if name in VARIANTS or CASES[name].reference == PRESET])
def test_x_and_z_are_opencaps(added, readings):
    """Reference place times the body's mesh factors over the reference's; OpenCap leaves y as it is."""
    factors = {owner: np.array(values) for owner, file, values in reversed(added.of(added.before)["meshes"]) if "foot" in file}
    if added.case.given or added.case.body_map or len(factors) < 4:
        pytest.skip("OpenCap takes the body's own meshes")
    found = contacts(readings[added.after])
    for sphere, (part, place) in OPENCAP.items():
        for side, sign in (("r", 1), ("l", -1)):
            scaled = np.array(place) * (1, 1, sign) * np.abs(factors[f"{part}_{side}"]) / OPENCAP_FACTORS
            there = placing.vector(found[f"{sphere}_{side}"][1]["centre_in_base"])
            assert np.allclose(there[[0, 2]], scaled[[0, 2]], rtol=1e-12, atol=1e-15), (sphere, side)


@pytest.mark.parametrize("name, text, named", add_variants.MASS_OPTIONS, ids=[name for name, *_ in add_variants.MASS_OPTIONS])
def test_what_cannot_be_decided_is_asked(name, text, named, tmp_path):
    """Sides more than 5 % apart, or meshes of one bone more than 1 %: both are named with their factors, and nothing is written."""
    model, output = tmp_path / f"{name}.osim", tmp_path / "added.osim"
    model.write_text(text, encoding="utf-8")
    outcome = command.run("add", model, "--from", "falisse2022", "-o", output)
    assert outcome.status == 1 and not output.exists()
    assert all(one in outcome.error["message"] for one in (*named, "--body-scale")), outcome.error


def test_sources_that_differ_are_reported(added_models):
    """The mesh is taken, and both values are named: 0.231 m to the toes are 41 % more than the reference's, the mesh has 17 %."""
    warnings = [one["message"] for one in added_models["joint_farther_than_the_mesh"].outcome.report["findings"] if one["code"] == "factors-disagree"]
    assert len(warnings) == 2 and all("1.171" in one and "1.414" in one for one in warnings), warnings
    assert any("toes_l takes the factors of calcn_l" in one for one in added_models["no_toes"].outcome.report["remarks"])
