"""Spheres on bodies that are welded to ground, directly or through others, are fixed: those that OpenSim holds on ground, and no others."""

import random

import compare
import pytest
from models import FIXTURES
from opensim_reads import read_models

import command

import sys

sys.path.insert(0, str(FIXTURES))

from quirks import base  # noqa: E402  (the fixtures' own building blocks)

SEEDS = range(1, 25)


def tree(seed):
    """A model: two feet, and rocks that joints of several classes hold on ground, on each other or on the pelvis, written from either end."""
    draw = random.Random(seed)
    bodies, joints, forces, geometry = list(base.FEET[0]), list(base.FEET[1]), [], [base.half_space(), *base.spheres("r"), *base.spheres("l")]
    forces += [base.smooth(f"contact_{name}_{side}", f"{name}_{side}") for side in "rl" for name in ("heel", "toe")]
    under = ["/ground"]
    for index in range(draw.randint(1, 4)):
        name = f"rock_{index}"
        kind = draw.choice(["WeldJoint", "WeldJoint", "WeldJoint", "PinJoint"])
        ends = [draw.choice([*under, "/bodyset/pelvis"]), f"/bodyset/{name}"]
        if draw.random() < 0.5:
            ends.reverse()
        bodies.append(base.body(name, "1"))
        joints.append(
            f'<{kind} name="joint_{index}">\n\t<socket_parent_frame>{ends[0]}</socket_parent_frame>\n'
            f"\t<socket_child_frame>{ends[1]}</socket_child_frame>\n</{kind}>"
        )
        geometry.append(base.sphere(f"stone_{index}", f"/bodyset/{name}", "0.3"))
        forces.append(base.smooth(f"contact_stone_{index}", f"stone_{index}"))
        under.append(f"/bodyset/{name}")
    return base.model(bodies, joints, forces, geometry, name="rocks")


@pytest.fixture(scope="module")
def readings_and_reports(tmp_path_factory):
    folder = tmp_path_factory.mktemp("fixed")
    paths = {seed: folder / f"{seed}.osim" for seed in SEEDS}
    for seed, path in paths.items():
        path.write_text(tree(seed))
    readings = read_models(paths.values())
    return {seed: (readings[str(path)], command.inspect(path).report) for seed, path in paths.items()}


@pytest.mark.parametrize("seed", SEEDS)
def test_fixed_bodies_are_those_that_opensim_holds_on_ground(seed, readings_and_reports):
    reading, report = readings_and_reports[seed]
    assert reading["builds"], reading
    compare.inspect_equals_opensim(report, reading)
    fixed = {sphere["name"] for sphere in reading["spheres"] if sphere["base"] in reading["fixed"]}
    terrain_findings = [finding for finding in report["findings"] if finding["code"] == "terrain"]
    sphere_findings = [finding for finding in terrain_findings if finding.get("spheres")]
    assert len(sphere_findings) == (1 if fixed else 0)
    assert {name for finding in sphere_findings for name in finding["spheres"]} == fixed
    # Rocks on which others hang by a joint count, those alone do not: `compare` sums what is left.
    assert len(terrain_findings) - len(sphere_findings) == (1 if reading["uncounted"] else 0)
    assert not fixed & {name for limb in report["limbs"] or [] for name in limb["spheres"]}


def test_there_are_models_with_and_without_fixed_bodies(readings_and_reports):
    kinds = {(len(reading["fixed"]) > 1, len(reading["uncounted"]) == len(reading["fixed"]) - 1) for reading, _ in readings_and_reports.values()}
    assert kinds == {(True, True), (True, False), (False, True)}
