"""Drop and Stand, tasks in the real OpenSim: a locked body does what the command's `drop-test` and `inspect` say.

The two sides share nothing but the file: the command is a process that reads it and integrates one equation of its own; the tasks
load the whole model in OpenSim. Each task has a process of its own, as in a run.
"""

import dataclasses
import json
import multiprocessing
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import task_models
from conftest import FIXTURES
from osim_contact_scale import ModelError, RequestError
from osim_contact_scale.simulate import Drop, Stand

TOLERANCE = 1e-6  # of a value, of the range of a series, and of x/R
# The command that comes with the package.
BINARY = Path(sys.executable).with_name("osim-contact-scale")
CORPUS = os.environ.get("OSIM_CORPUS")
needs_corpus = pytest.mark.skipif(not CORPUS, reason="OSIM_CORPUS is not set: models by other people are not at hand")

QUADRUPEDS = ("mouse", "horse", "giraffe")
SHORT = {"duration": 0.8, "samples": 201}
TABLE1 = sorted(path.stem for path in (FIXTURES / "table1").glob("*.osim") if not path.stem.endswith(".scaled"))

#: Two limbs of spheres, and one sphere of which nobody knows on which side it is.
LIMBS = [
    "v20302_dynamic_jumper",
    "v30000_osim_rl_gait9dof18musc_crlf",
    "v30000_scone_h0914m",
    "v40000_dhondt_2024_3seg_human",
    "v40000_dynamic_jumper",
    "v40000_falisse_2022_human",
    "v40000_human_12_hunt_crossley",
    "v40000_moco_2d_gait",
    "v40000_opencap_lai_arnold_crlf",
    "v40000_scone_h0914m",
]
ONE_SPHERE = [
    "v20001_bouncing_ball_hunt_crossley",
    "v20303_bouncing_block",
    "v30000_bouncing_block",
    "v40000_bouncing_ball_smooth",
]
#: A model whose half-space is turned by 1.5708, which is 3.7e-6 more than a right angle: the command takes it to be level.
NEARLY_LEVEL = ("v40000_human_12_hunt_crossley",)


@pytest.fixture(scope="module")
def apart():
    """Calls functions in processes of their own, which have seen no other model."""
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(
        ["opensim", "osim_contact_scale.simulate._drop", "osim_contact_scale.simulate._stand"]
    )
    with context.Pool(1, maxtasksperchild=1) as pool:
        yield lambda function, *arguments: pool.apply(function, arguments)


def command_record(*words):
    """The answer of the command, as JSON."""
    process = subprocess.run([str(BINARY), *map(str, words), "--format", "json"], capture_output=True, encoding="utf-8")
    assert process.returncode == 0, process.stdout + process.stderr
    return json.loads(process.stdout)


def drop_test(path, task, *options):
    """The result of the command for the same drop."""
    return command_record("drop-test", path, "--duration", task.duration, "--samples", task.samples, *options)


def limbs(path):
    """For each limb, the names of its forces, and x/R of its spheres when the limb carries the body at the default pose."""
    for limb in command_record("inspect", path)["figures"]["limbs"]:
        forces = tuple(dict.fromkeys(name for sphere in limb["spheres"] for name in sphere["forces"]))
        yield (
            forces,
            {sphere["sphere"]: sphere["relative_indentation_model_law_standing"] for sphere in limb["spheres"]},
        )


def same_fall(fallen, report):
    """Asserts that all numbers and series that both results have are equal."""
    figures, series = fallen
    common = [name for name in figures if name in report]
    assert len(common) >= 12
    for name in common:
        expected = None if report[name] is None else pytest.approx(report[name], rel=TOLERANCE)
        assert figures[name] == expected, name
    assert set(report["series"]) <= set(series)
    for name, theirs in report["series"].items():
        ours = np.array(series[name])
        assert ours.shape == np.shape(theirs)
        assert np.ptp(theirs) > 0
        assert np.max(np.abs(ours - theirs)) <= TOLERANCE * np.ptp(theirs), name


@pytest.mark.parametrize("name", TABLE1)
def test_a_locked_animal_falls_as_in_drop_test(name, apart):
    """Table 1's animals on all of their limbs."""
    path = FIXTURES / "table1" / f"{name}.osim"
    task = Drop(**SHORT)
    limb_count = 4 if name.startswith(QUADRUPEDS) else 2
    same_fall(apart(task, str(path)), drop_test(path, task, "--stance-limbs", limb_count))


@pytest.mark.parametrize("name", ["emu_2_spheres_hunt_crossley", "giraffe_smooth_sphere", "human_62kg_smooth_sphere"])
def test_a_locked_animal_falls_on_the_limbs_that_are_chosen(name, apart):
    path = FIXTURES / "table1" / f"{name}.osim"
    task = Drop(select="*_r", height="x0.5", **SHORT)
    limb_count = 2 if name.startswith(QUADRUPEDS) else 1
    same_fall(apart(task, str(path)), drop_test(path, task, "--stance-limbs", limb_count, "--height", "x0.5"))


@pytest.mark.parametrize("name", ["human_62kg_smooth_sphere", "emu_10_spheres_hunt_crossley"])
def test_it_falls_as_where_opensim_locks_the_joints(name, apart):
    """By constraints on the coordinates of the whole model, where the task welds the bodies together."""
    path = str(FIXTURES / "table1" / f"{name}.osim")
    lifting = "pelvis_ty" if name.startswith("human") else "trunk_ty"
    figures, series = apart(Drop(duration=0.4, samples=101, height="0.5R"), path)
    # The fixtures begin a quarter of R above the ground.
    begin = figures["height_m"] - 0.25 * figures["reference_radius_m"]
    theirs = np.array(apart(task_models.locked_fall, path, lifting, begin, series["time_s"]))
    ours = np.array(series["height_m"]) - 0.25 * figures["reference_radius_m"]
    assert np.max(np.abs(ours - theirs)) <= TOLERANCE * np.ptp(theirs)


def test_a_height_may_be_in_metres_and_a_duration_in_units_of_time(apart):
    path = FIXTURES / "table1" / "mouse_hunt_crossley.osim"
    in_metres = Drop(height=0.002, duration=0.4, samples=101)
    report = drop_test(path, in_metres, "--stance-limbs", 4, "--height", "0.002")
    same_fall(apart(in_metres, str(path)), report)
    in_units = dataclasses.replace(in_metres, duration="28T")
    figures, _ = apart(in_units, str(path))
    assert figures["duration_s"] == pytest.approx(28 * (0.002 / 9.81) ** 0.5, rel=1e-12)


def test_a_contact_with_little_dissipation_gives_contact_time_and_rebound(tmp_path, apart):
    path = tmp_path / "bouncing.osim"
    text = (FIXTURES / "table1" / "emu_2_spheres_hunt_crossley.osim").read_text()
    path.write_text(re.sub(r"<dissipation>[^<]+<", "<dissipation>0.1<", text))
    task = Drop(height="1R", **SHORT)
    report = drop_test(path, task, "--stance-limbs", 2, "--height", "x1")
    assert report["contact_time_s"] and report["rebound_speed_m_s"]
    same_fall(apart(task, str(path)), report)


@needs_corpus
@pytest.mark.parametrize("name", LIMBS)
def test_a_published_model_falls_as_in_drop_test(name, tmp_path, apart):
    """The model's spheres are moved in their bodies first, until they are level at the default pose, as `drop-test` takes them to be."""
    path = tmp_path / f"{name}.osim"
    apart(task_models.level, os.path.join(CORPUS, f"{name}.osim"), str(path))
    forces, _ = next(limbs(path))
    task = Drop(select=forces, **SHORT)
    selected = (word for force in forces for word in ("--select", force))
    same_fall(apart(task, str(path)), drop_test(path, task, *selected))


@needs_corpus
@pytest.mark.parametrize("name", ONE_SPHERE)
def test_a_published_ball_falls_as_in_drop_test(name, apart):
    path = os.path.join(CORPUS, f"{name}.osim")
    task = Drop(**SHORT)
    same_fall(apart(task, path), drop_test(path, task, "--spheres", 1))


OURS = [
    *(f"table1/{name}" for name in TABLE1),
    "walks/child",
    "scale_tool/generic_smooth",
    "scale_tool/scaled_hunt_crossley",
]


@pytest.mark.parametrize("name", OURS)
def test_our_models_stand_as_inspect_says(name, apart):
    path = FIXTURES / f"{name}.osim"
    for forces, wanted in limbs(path):
        check_standing(apart(Stand(select=forces), str(path)), wanted)


@needs_corpus
@pytest.mark.parametrize("name", LIMBS)
def test_published_models_stand_as_inspect_says(name, tmp_path, apart):
    """On one limb, at the default pose, each sphere at its own height."""
    path = os.path.join(CORPUS, f"{name}.osim")
    if name in NEARLY_LEVEL:
        published, path = path, str(tmp_path / f"{name}.osim")
        apart(task_models.level, published, path, False)
    for forces, wanted in limbs(path):
        check_standing(apart(Stand(select=forces), path), wanted)


@needs_corpus
@pytest.mark.parametrize("name", ONE_SPHERE)
def test_a_ball_stands_as_inspect_says(name, apart):
    path = os.path.join(CORPUS, f"{name}.osim")
    (limb,) = command_record("inspect", path, "--spheres", 1)["figures"]["limbs"]
    check_standing(
        apart(Stand(), path), {one["sphere"]: one["relative_indentation_model_law"] for one in limb["spheres"]}
    )


def check_standing(placed, expected):
    figures, spheres = placed
    assert len(expected) == figures["sphere_count"] == len(spheres["radius_m"])
    result = {name: figures[f"relative_indentation_{name}"] for name in expected}
    assert result == pytest.approx(expected, abs=TOLERANCE)
    assert abs(figures["residual_force_n"]) < 1e-9 * figures["weight_n"]
    assert spheres["relative_indentation"] == pytest.approx(list(result.values()), abs=0)


def test_a_locked_body_comes_to_rest_where_it_stands(apart):
    """A long fall ends at the height that `Stand` finds without integration."""
    path = str(FIXTURES / "walks" / "child.osim")
    fallen, _ = apart(Drop(duration="60T", samples=11), path)
    placed, _ = apart(Stand(), path)
    assert fallen["final_relative_indentation"] * fallen["reference_radius_m"] == pytest.approx(
        -placed["height_m"], abs=1e-8
    )


@pytest.mark.parametrize("kind", task_models.KINDS)
def test_a_free_body_on_symmetric_spheres_falls_as_in_drop_test(kind, tmp_path, apart):
    """The body has no reason to turn."""
    path = tmp_path / "model.osim"
    apart(task_models.write, str(path), {"kind": kind})
    task = Drop(joints="free", **SHORT)
    same_fall(apart(task, str(path)), drop_test(path, task, "--spheres", 4))


def test_free_joints_obey_newton(apart):
    """M d²y/dt² = F − M g of the centre of mass, from its height alone, by differences of sixth order."""
    path = str(FIXTURES / "table1" / "human_62kg_smooth_sphere.osim")
    locked, _ = apart(Drop(duration=0.2, samples=401), path)
    figures, series = apart(Drop(joints="free", duration=0.2, samples=401, accuracy=1e-10), path)
    step = series["time_s"][1]
    weights = np.array([2, -27, 270, -490, 270, -27, 2]) / 180
    accelerations = np.convolve(series["com_height_m"], weights, "valid") / step**2
    expected = np.array(series["force_n"])[3:-3] / figures["mass_kg"] - 9.81
    assert np.ptp(expected) > 9.81, "it has not touched the ground"
    assert np.max(np.abs(accelerations - expected)) < 1e-4 * np.ptp(expected)
    # It is not locked: the hinges give way.
    assert figures["peak_force_n"] < 0.99 * locked["peak_force_n"]


def test_muscles_are_at_rest_or_off(tmp_path, apart):
    """A torque of an actuator with a controller, and a spring: the controller is never heard."""
    path = str(tmp_path / "model.osim")
    apart(task_models.write, path, {"driven": True})
    at_rest, _ = apart(Drop(joints="free", **SHORT), path)
    off, _ = apart(Drop(joints="free", actuators="off", **SHORT), path)
    assert at_rest["impact_speed_m_s"] is not None
    for name, value in at_rest.items():
        assert value == (None if off[name] is None else pytest.approx(off[name], rel=1e-9)), name


WRONG = {
    "no contacts": ({"contacts": False}, "there is nothing that the body can stand on"),
    "no gravity": ({"gravity": 0.0}, "gravity is 0"),
    "a hinge": ({"joint": "pin"}, "no coordinate lifts the contact spheres straight against gravity"),
    "a tilted floor": ({"tilt": 0.1}, "is not level"),
    "contacts that are off": ({"applies": False}, "are switched off"),
    "a floor on the body": ({"floor_on": "body"}, "above a half-space that does not"),
    "no constant indentation": ({"kind": "smooth", "constant": 0.0}, "constant_contact_force is 0"),
    "no radius": ({"radius": 0.0}, "the sphere sphere0 has a radius of 0 m"),
    "no stiffness": ({"kind": "hunt_crossley", "stiffness": 0.0}, "contact force"),
}


@pytest.mark.parametrize("task", [Drop(**SHORT), Drop(joints="free", **SHORT), Stand()], ids=repr)
@pytest.mark.parametrize("what", WRONG)
def test_a_model_that_cannot_fall_is_refused_in_words(what, task, tmp_path, apart):
    change, expected = WRONG[what]
    path = str(tmp_path / "model.osim")
    apart(task_models.write, path, change)
    with pytest.raises(ModelError) as caught:
        apart(task, path)
    assert expected in str(caught.value)
    assert caught.value.path == path and caught.value.code == "simulation"


def test_of_two_animals_one_is_chosen(apart):
    """A player and a ball: both have contacts with the ground, and their own coordinates."""
    path = str(FIXTURES / "format" / "player_and_ball.osim")
    with pytest.raises(ModelError, match="select others"):
        apart(Stand(), path)
    player, _ = apart(Stand(select=("contact_*",)), path)
    ball, _ = apart(Stand(select="ball_floor"), path)
    assert player["mass_kg"] > 10 * ball["mass_kg"]
    assert (player["sphere_count"], ball["sphere_count"]) == (4, 1)


@pytest.mark.parametrize("name", ["bad/not_xml", "bad/truncated", "bad/no_document"])
def test_a_file_that_opensim_cannot_read_is_refused(name, apart):
    with pytest.raises(ModelError, match="OpenSim could not read this model"):
        apart(Drop(), str(FIXTURES / f"{name}.osim"))


def test_names_that_fit_no_force_are_refused(apart):
    with pytest.raises(ModelError, match=r"select fits no contact force: toe\*; there are contact_s1_r, contact_s2_r"):
        apart(Stand(select="toe*"), str(FIXTURES / "table1" / "human_62kg_smooth_sphere.osim"))


@pytest.mark.parametrize(
    "settings",
    [
        {"height": "0.25r"},
        {"height": -1},
        {"height": "deep"},
        {"duration": 0},
        {"duration": "3R"},
        {"joints": "loose"},
        {"actuators": "on"},
        {"samples": 1},
        {"samples": 2.5},
        {"accuracy": 0.0},
        {"accuracy": "high"},
    ],
    ids=str,
)
def test_a_wrong_setting_is_refused_at_once(settings):
    with pytest.raises(RequestError) as caught:
        Drop(**settings)
    assert caught.value.keyword in settings


def test_a_task_prints_nothing_and_leaves_no_file(tmp_path):
    path = FIXTURES / "table1" / "emu_2_spheres_smooth_sphere.osim"
    program = f"from osim_contact_scale.simulate import Drop, Stand; Stand()({str(path)!r}); Drop(duration=0.1)({str(path)!r})"
    before = {file.name for file in path.parent.iterdir()}
    process = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True)
    assert (process.returncode, process.stdout, process.stderr) == (0, "", "")
    assert list(Path(tmp_path).iterdir()) == []
    assert {file.name for file in path.parent.iterdir()} == before
