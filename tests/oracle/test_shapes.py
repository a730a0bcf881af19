"""What the real OpenSim makes of contact shapes that are not spheres, and of what the command writes for them."""

import shutil

import pytest

import command
from models import FIXTURES
from opensim_shapes import pressed

SHAPES = FIXTURES / "shapes"
# The centre of the ellipsoid is 0.02 m below the body's origin, and its lowest point 0.0325 m below the centre.
DEPTHS = [0.0005, 0.002, 0.005]  # m


def heel(model, times=1.0):
    """The force on the ellipsoid at DEPTHS, all lengths of the ellipsoid times a factor."""
    heights = [0.02 + times * (0.0325 - depth) for depth in DEPTHS]
    return [forces["contact_heel_r"] for forces in pressed(model, heights)]


@pytest.mark.parametrize(("arguments", "times"), [(["set", "radius=x2"], 4.0), (["rescale", "--target-mass", "492"], 8.0)])
def test_an_ellipsoid_is_scaled_as_a_sphere_is(arguments, times, tmp_path):
    before, after = SHAPES / "ellipsoid.osim", tmp_path / "after.osim"
    verb, *others = arguments
    outcome = command.run(verb, before, *others, *command.YES, "-o", after)
    assert outcome.status == 0, outcome
    assert "<radii>0.08 0.065 0.06</radii>" in after.read_text()
    first = heel(before)
    assert min(first) > 1.0  # N
    for one, other in zip(first, heel(after, 2.0), strict=True):
        assert other / one == pytest.approx(times, rel=1e-9)


@pytest.mark.parametrize("shape", ["ring", "tube", "sole"])
def test_other_shapes_press_nothing_in_a_hunt_crossley_force(shape, tmp_path):
    shutil.copy(SHAPES / "sole.obj", tmp_path)
    mesh = '<ContactMesh name="sole"><socket_frame>/bodyset/calcn_r</socket_frame><filename>sole.obj</filename></ContactMesh>'
    text = (SHAPES / "torus_and_cylinder.osim").read_text().replace("<ContactSphere", mesh + "<ContactSphere")
    for pair, pushes in (("floor heel_r ring tube", True), (f"floor {shape}", False)):
        model = tmp_path / f"{pushes}.osim"
        model.write_text(text.replace("floor heel_r ring tube", pair))
        (force,) = pressed(model, [-0.005])[0].values()
        assert (force > 1.0) == pushes and (pushes or force == 0.0), pair


def test_an_elastic_foundation_presses_until_it_is_replaced(tmp_path):
    for name in ("elastic_foundation.osim", "sole.obj"):
        shutil.copy(SHAPES / name, tmp_path)
    before, after, table = (tmp_path / name for name in ("elastic_foundation.osim", "after.osim", "table.csv"))
    assert pressed(before, [0.025])[0]["mesh"] > 1.0
    table.write_text("name,body,x,y,z,radius\nheel_r,calcn_r,0,0,0,0.03\n")
    outcome = command.run("add", before, "--contacts", table, "--from", "falisse2022", "--replace", *command.YES, "-o", after)
    assert outcome.status == 0, outcome
    forces = pressed(after, [0.025])[0]
    assert "mesh" not in forces and min(forces.values()) > 0.0
