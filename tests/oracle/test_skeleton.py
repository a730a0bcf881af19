"""Damaged skeletons: OpenSim reads them without a word and puts feet elsewhere, `check` reports them. What holds a root carries the body."""

import re
from pathlib import Path

import numpy as np
import pytest
from apart import ask, run_each_job
from models import CORPUS, FIXTURES, NO_CORPUS

import command

HUMAN = (FIXTURES / "check/known_contacts.osim").read_text()
LOCKED = (FIXTURES / "check/root_held.osim").read_text()
DRIVEN = "<prescribed>true</prescribed><prescribed_function><Constant><value>0</value></Constant></prescribed_function>"


def with_constraint(text):
    return lambda model: model.replace("<ForceSet ", f'<ConstraintSet name="constraintset"><objects>{text}</objects></ConstraintSet>\n<ForceSet ', 1)


def with_function(function):
    coupler = (
        '<CoordinateCouplerConstraint name="height"><isEnforced>true</isEnforced>'
        f"<coupled_coordinates_function>{function}</coupled_coordinates_function>"
        "<independent_coordinate_names>pelvis_tx</independent_coordinate_names>"
        "<dependent_coordinate_name>pelvis_ty</dependent_coordinate_name></CoordinateCouplerConstraint>"
    )
    return lambda model: with_constraint(coupler)(LOCKED.replace("<locked>true</locked>", ""))


HOLDS = {
    "locked": lambda model: LOCKED,
    "prescribed": lambda model: LOCKED.replace("<locked>true</locked>", DRIVEN),
    "welded": lambda model: model.replace("FreeJoint", "WeldJoint"),
    "weld": with_constraint(
        '<WeldConstraint name="stand"><socket_frame1>/ground</socket_frame1><socket_frame2>/bodyset/pelvis</socket_frame2></WeldConstraint>'
    ),
    "point": with_constraint(
        '<PointConstraint name="stand"><socket_body_1>/ground</socket_body_1><socket_body_2>/bodyset/pelvis</socket_body_2></PointConstraint>'
    ),
    "line": with_constraint(
        '<PointOnLineConstraint name="rail"><socket_line_body>/ground</socket_line_body><socket_follower_body>/bodyset/pelvis'
        "</socket_follower_body><line_direction_vec>1 0 0</line_direction_vec></PointOnLineConstraint>"
    ),
    "level": with_function("<LinearFunction><coefficients>0 0</coefficients></LinearFunction>"),
}
FREE = {
    # OpenSim lets the coordinate move.
    "constant": with_function("<Constant><value>0</value></Constant>"),
    "free": lambda model: model,
    "unlocked": lambda model: LOCKED.replace("<locked>true</locked>", ""),
    "off": lambda model: with_constraint(
        '<WeldConstraint name="stand"><isEnforced>false</isEnforced><socket_frame1>/ground</socket_frame1>'
        "<socket_frame2>/bodyset/pelvis</socket_frame2></WeldConstraint>"
    )(model),
    "upright": with_constraint(
        '<PointOnLineConstraint name="rail"><socket_line_body>/ground</socket_line_body><socket_follower_body>/bodyset/pelvis'
        "</socket_follower_body><line_direction_vec>0 1 0</line_direction_vec></PointOnLineConstraint>"
    ),
    "slope": with_function("<LinearFunction><coefficients>1 0</coefficients></LinearFunction>"),
}


def codes(path):
    findings = command.run("check", path).report["findings"]
    return {finding["code"]: finding["severity"] for finding in findings}


@pytest.mark.parametrize("way", [*HOLDS, *FREE])
def test_contacts_carry_nothing_of_a_root_that_is_held(way, tmp_path):
    soft = {**HOLDS, **FREE}[way](HUMAN)
    paths = [tmp_path / "soft.osim", tmp_path / "stiff.osim"]
    for path, stiffness in zip(paths, (1e6, 2e6), strict=True):
        path.write_text(soft.replace("<stiffness>1000000<", f"<stiffness>{stiffness}<"))
    (_, soft_up, _), (_, stiff_up, _) = run_each_job("opensim_held", [[str(path), "pelvis"] for path in paths])
    found = codes(paths[0])
    if way in HOLDS:
        assert abs(soft_up) < 1e-6 and abs(stiff_up) < 1e-6
        assert found["root-held"] == "remark"
    else:
        assert stiff_up > soft_up + 1
        assert "root-held" not in found


@pytest.mark.parametrize("name", ["odd_parent", "left_right_bones"])
def test_opensim_puts_the_foot_elsewhere(name):
    bodies = ["calcn_r", "toes_r", "calcn_l", "toes_l"]
    (placed,) = run_each_job("opensim_feet", [str(FIXTURES / f"check/{name}.osim")])
    place = {body: np.array(placed["bodies"][body])[:, 3] for body in bodies}
    assert np.allclose(place["calcn_l"], place["calcn_r"] * [1, 1, -1], atol=1e-9)
    assert np.linalg.norm(place["toes_l"] - place["toes_r"] * [1, 1, -1]) > 0.1
    assert codes(FIXTURES / f"check/{name}.osim")[name.replace("_", "-")] == "warning"


def test_a_misspelt_place_of_a_joint_is_the_default(tmp_path):
    path = tmp_path / "model.osim"
    path.write_text(HUMAN.replace("<translation>0 -0.9 0.1</translation>", "<translaton>0 -0.9 0.1</translaton>"))
    placed, whole = run_each_job("opensim_feet", [str(path), str(FIXTURES / "check/known_contacts.osim")])
    moved = np.array(placed["bodies"]["calcn_r"])[:, 3] - np.array(whole["bodies"]["calcn_r"])[:, 3]
    assert np.allclose(moved, [0, 0.9, -0.1], atol=1e-9)
    assert codes(path)["unknown-name"] == "error"


def test_misspelt_frames_and_coordinates_of_a_joint(tmp_path):
    """OpenSim refuses a joint without its frames, and takes 0 for the default values of coordinates that it does not find."""
    whole = (FIXTURES / "feet/human_40000.osim").read_text()
    paths = {name: tmp_path / f"{name}.osim" for name in ["whole", "frames", "coordinates"]}
    for name, path in paths.items():
        misspelt = f"{name[:3]}x{name[3:]}"
        path.write_text(whole.replace(f"<{name}>", f"<{misspelt}>", 1).replace(f"</{name}>", f"</{misspelt}>", 1))
    read = dict(zip(paths, ask("opensim_feet", map(str, paths.values())), strict=True))
    assert "pelvis_offset" in read["frames"]["error"]
    pelvis = [np.array(read[name]["bodies"]["pelvis"]) for name in ["whole", "coordinates"]]
    assert not np.allclose(*pelvis)
    for name in ["frames", "coordinates"]:
        assert codes(paths[name])["unknown-name"] == "error"


COUPLER = (
    "<CoordinateCouplerConstraint name={0}><coupled_coordinates_function><LinearFunction><coefficients>1 0</coefficients></LinearFunction>"
    "</coupled_coordinates_function><independent_coordinate_names>{1}</independent_coordinate_names>"
    "<dependent_coordinate_name>{2}</dependent_coordinate_name></CoordinateCouplerConstraint>"
)
ON_COORDINATE = ["CoordinateActuator", "CoordinateLimitForce", "SpringGeneralizedForce", "ExpressionBasedCoordinateForce"]


@pytest.mark.parametrize("kind", [*ON_COORDINATE, "coupler"])
def test_opensim_refuses_the_name_of_no_coordinate(kind, tmp_path):
    wrong = ["nothing", "Unassigned", ""]
    paths = []
    for name in ["pelvis_tx", *wrong]:
        if kind == "coupler":
            model = with_constraint(COUPLER.format('"x"', name, "pelvis_tz"))(LOCKED)
        else:
            force = f'<{kind} name="x"><coordinate>{name}</coordinate></{kind}>'
            model = re.sub("(<ForceSet .*?<objects>)", rf"\g<1>{force}", LOCKED, count=1, flags=re.DOTALL)
        paths.append(tmp_path / f"{len(paths)}.osim")
        paths[-1].write_text(model)
    right, *refused = ask("opensim_held", [[str(path), "pelvis"] for path in paths])
    assert "error" not in right and "socket-nowhere" not in codes(paths[0])
    for name, path, answer in zip(wrong, paths[1:], refused, strict=True):
        # A coupler may follow no coordinate.
        loads = kind == "coupler" and not name
        assert ("error" in answer) != loads, name
        assert codes(path).get("socket-nowhere") == (None if loads else "error")


def test_a_sphere_on_ground_stays_there():
    """OpenSim computes its force, but the foot has no part of it."""
    path = FIXTURES / "check/foot_sphere_on_ground.osim"
    assert codes(path)["foot-sphere-on-ground"] == "warning"
    (acceleration,) = run_each_job("opensim_held", [[str(path), "toes_l"]])
    (whole,) = run_each_job("opensim_held", [[str(FIXTURES / "check/known_contacts.osim"), "toes_l"]])
    assert not np.allclose(acceleration, whole)


@pytest.mark.skipif(not CORPUS, reason=NO_CORPUS)
def test_a_shank_on_the_other_thigh_moves_the_foot_to_the_other_side(tmp_path):
    text = Path(CORPUS, "v40000_falisse_2022_human.osim").read_text()
    start = text.index('name="knee_l"')
    damaged = tmp_path / "model.osim"
    damaged.write_text(text[:start] + text[start:].replace("/bodyset/femur_l</socket_parent>", "/bodyset/femur_r</socket_parent>", 1))
    (placed,) = run_each_job("opensim_feet", [str(damaged)])
    assert np.array(placed["bodies"]["calcn_l"])[2, 3] > 0.07
    found = [one for one in command.run("check", damaged).report["findings"] if one["code"] == "odd-parent"]
    assert [one["severity"] for one in found] == ["warning"]
    assert re.search("tibia_l hangs on femur_r.* toes_l is 1\\d\\d", found[0]["message"])


@pytest.mark.skipif(not CORPUS, reason=NO_CORPUS)
@pytest.mark.parametrize("old, new", [("calcn_l", "mirrored"), ("calcn_l", "right foot's file")])
def test_a_mirrored_mesh_changes_nothing_but_the_drawing(old, new, tmp_path):
    whole = Path(CORPUS, "v40000_falisse_2022_human.osim")
    text = whole.read_text()
    head, rest = text.split(f'<Body name="{old}">', 1)
    body, rest = rest.split("</Body>", 1)
    if new == "mirrored":
        changed = re.sub(r"<scale_factors>(\S+) (\S+) (\S+)</scale_factors>", r"<scale_factors>\1 \2 -\3</scale_factors>", body)
    else:
        changed = body.replace("l_foot.vtp", "r_foot.vtp")
    assert changed != body
    path = tmp_path / "model.osim"
    path.write_text(f'{head}<Body name="{old}">{changed}</Body>{rest}')
    placed = run_each_job("opensim_feet", [str(whole), str(path)])
    assert placed[0]["bodies"] == placed[1]["bodies"]
    assert codes(path) == codes(whole)
    same = tmp_path / "same.osim"
    same.write_text(text)
    assert codes_beside(path, whole) == codes_beside(same, whole)


def codes_beside(path, original):
    findings = command.run("check", path, "--from", original).report["findings"]
    return sorted(finding["code"] for finding in findings if finding["severity"] != "remark")
