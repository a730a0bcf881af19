"""Feet as `plot feet` draws them, against the real OpenSim: places of spheres, joints and floors at the default pose.

The scene is what the example `scene` of osim-model prints, before anything is drawn.
"""

import json
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import command
from apart import run_one_job
from models import CORPUS, FIXTURES, NO_CORPUS, animals, corpus, label

PLACE = 1e-9  # m
FEET = sorted((FIXTURES / "feet").glob("*.osim")) + sorted((FIXTURES / "drawn_feet").glob("*.osim"))
MODELS = FEET + animals() + corpus()
# OpenSim needs a contact mesh that is not here.
NOT_READ = {"v30517_elastic_foundation_with_sphere.osim"}
# A constraint may move their bodies: they are drawn in their own frames.
OWN_FRAME = {"v20303_bouncing_block.osim", "v30000_bouncing_block.osim"}


@cache
def scene(path):
    """The feet of a model."""
    run = subprocess.run([command.example("foot_view"), str(path)], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return [json.loads(line) for line in run.stdout.splitlines()]


@cache
def opensim(path):
    """The answer of OpenSim, from a process of its own."""
    return run_one_job("opensim_scene", str(Path(path).absolute()))


@pytest.mark.parametrize("path", MODELS, ids=label)
def test_spheres_and_joints_are_where_opensim_has_them(path):
    if path.name in NOT_READ:
        pytest.skip("OpenSim needs a contact mesh that is not here")
    known, feet = opensim(path), scene(path)
    spheres = {sphere["name"]: sphere for sphere in known["spheres"]}
    for foot in feet:
        assert foot["in_ground"] == (path.name not in OWN_FRAME)
        if not foot["in_ground"]:
            continue
        bottoms = []
        for sphere in foot["spheres"]:
            there = spheres[sphere["name"]]
            assert np.abs(np.subtract(sphere["centre"], there["centre"])).max() < PLACE, sphere["name"]
            assert sphere["radius"] == pytest.approx(there["radius"], rel=1e-12)
            # Gravity points along -y in all of these.
            bottoms.append(there["centre"][1] - there["radius"])
        if bottoms:
            assert foot["lowest"] == pytest.approx(min(bottoms), abs=PLACE)
        for joint in foot["joints"]:
            assert np.abs(np.subtract(joint["at"], known["joints"][joint["name"]])).max() < PLACE, joint["name"]
        if foot["floor"] is not None:
            heights = [floor["at"][1] for floor in known["floors"] if floor["base"] == "ground"]
            assert any(abs(height - foot["floor"]) < PLACE for height in heights), heights


STATIONS = {"a": "0.01 -0.02 0.005", "b": "0.12 -0.01 0.02", "c": "0.03 0.04 0.09"}


@pytest.mark.parametrize("axes", [("+x", "+y"), ("-z", "+x"), ("+y", "-z")])
def test_a_frame_at_stations_is_where_opensim_has_it(axes, tmp_path):
    """A sphere and a joint on a StationDefinedFrame of the foot: its stations are on the body, on an offset frame, and a marker."""
    parents = {"a": "/bodyset/calcn_r", "b": "/jointset/mtp_r/calcn_r_offset", "c": "/bodyset/calcn_r"}
    stations = "".join(
        f'<Station name="{name}"><socket_parent_frame>{parents[name]}</socket_parent_frame><location>{at}</location></Station>'
        for name, at in STATIONS.items()
    ).replace("<Station ", "<Marker ", 1).replace("</Station>", "</Marker>", 1)
    points = zip(("point_a", "point_b", "point_c", "origin_point"), "abcb", strict=True)
    sockets = "".join(f"<socket_{socket}>/{station}</socket_{socket}>" for socket, station in points)
    frame = f'<StationDefinedFrame name="sdf"><ab_axis>{axes[0]}</ab_axis><ab_x_ac_axis>{axes[1]}</ab_x_ac_axis>{sockets}</StationDefinedFrame>'
    model = (FIXTURES / "check/known_contacts.osim").read_text()
    model = model.replace("<gravity>", f"<components>{stations}{frame}</components><gravity>", 1)
    model = model.replace("<socket_frame>/bodyset/calcn_r<", "<socket_frame>/sdf<", 1)
    model = model.replace("<socket_child_frame>/bodyset/calcn_r<", "<socket_child_frame>/sdf<", 1)
    path = tmp_path / "stations.osim"
    path.write_text(model)
    test_spheres_and_joints_are_where_opensim_has_them(path)
    assert command.inspect(path).status == 0


@pytest.mark.skipif(not CORPUS, reason=NO_CORPUS)
def test_known_feet_are_found():
    """Two feet with heel and toes in every model of a person, with or without spheres."""
    names = {path.name: [(foot["name"], len(foot["spheres"])) for foot in scene(path)] for path in corpus()}
    assert names["v40000_falisse_2022_human.osim"] == [("calcn_r", 6), ("calcn_l", 6)]
    assert names["v40000_dhondt_2024_3seg_human.osim"] == [("calcn_r", 5), ("calcn_l", 5)]
    assert names["v40000_scone_h0914m.osim"] == [("calcn_r", 2), ("calcn_l", 2)]
    for name in ("v40000_rajagopal_2016_without_contacts.osim", "v10905_gait2354_without_contacts.osim"):
        feet = scene(Path(CORPUS) / name)
        joints = [{joint["name"] for joint in foot["joints"]} for foot in feet]
        assert joints == [{"ankle_r", "subtalar_r", "mtp_r"}, {"ankle_l", "subtalar_l", "mtp_l"}], name
    assert names["v40000_double_pendulum_no_contacts.osim"] == []
