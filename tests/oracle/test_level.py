"""Feet that `set --level` and `add --level` make level: in OpenSim all bottoms of a foot are at the height of its lowest bottom."""

import numpy as np
import pytest

import command
import models
from apart import run_one_job

HEIGHT = 1e-9  # m
UNEVEN = models.FIXTURES / "check/uneven_bottoms.osim"
# Published models with one floor whose feet lie flat at the default pose.
FEET = ("v20302_dynamic_jumper", "v40000_dhondt_2024_3seg_human", "v40000_falisse_2022_human", "v40000_human_12_hunt_crossley")
CORPUS = {path.stem: path for path in models.corpus()}


def bottoms(path):
    """`{side: {sphere: height of its lowest point over the floor}}` at the default pose, in m, along the floor's normal."""
    known = run_one_job("opensim_scene", str(path))
    (floor,) = known["floors"]
    sides = {"r": {}, "l": {}}
    for sphere in known["spheres"]:
        (side,) = [side for side in sides if sphere["name"].startswith(f"{side}_") or sphere["name"].endswith(f"_{side}")]
        sides[side][sphere["name"]] = np.dot(np.subtract(sphere["centre"], floor["at"]), floor["normal"]) - sphere["radius"]
    return sides


def is_level(heights):
    return max(heights.values()) - min(heights.values()) < HEIGHT


@pytest.mark.parametrize("path", [UNEVEN, *(CORPUS[name] for name in FEET if name in CORPUS)], ids=lambda path: path.stem)
def test_set_brings_bottoms_to_the_lowest_of_their_foot(path, tmp_path):
    level = tmp_path / "level.osim"
    outcome = command.run("set", path, "--level", "-o", level)
    assert outcome.status == 0, outcome
    before, after = bottoms(path), bottoms(level)
    assert not all(is_level(heights) for heights in before.values())
    for side, heights in after.items():
        assert is_level(heights), heights
        assert min(heights.values()) == pytest.approx(min(before[side].values()), abs=HEIGHT)


@pytest.mark.skipif(not CORPUS, reason=models.NO_CORPUS)
@pytest.mark.parametrize("name", ["v40000_rajagopal_2016_without_contacts", "v40000_gait2392_without_contacts"])
def test_added_feet_are_level(name, tmp_path):
    made = {}
    for how in ([], ["--level"]):
        made[bool(how)] = tmp_path / f"{bool(how)}.osim"
        outcome = command.run("add", CORPUS[name], "--from", "falisse2022", *how, "-o", made[bool(how)])
        assert outcome.status == 0, outcome
    before, after = bottoms(made[False]), bottoms(made[True])
    assert all(is_level(heights) for heights in after.values()) and not all(is_level(heights) for heights in before.values())
    for side, heights in after.items():
        assert min(heights.values()) == pytest.approx(min(before[side].values()), abs=HEIGHT)
