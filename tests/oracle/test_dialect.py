"""The dialect of Moco 0.1 to 0.3, whose forces keep sphere and plane inside themselves: `convert --to smooth` keeps every number and its meaning.

OpenSim 4.6 cannot connect such a model; it reads the converted one with the numbers that the old one had, and finds the forces that the old
class computed. That law is from the class's public source (opensim-org/opensim-moco, Moco/Moco/Components/SmoothSphereHalfSpaceForce.cpp,
and Simbody/src/SmoothSphereHalfSpaceForce.cpp in the fork of Simbody that it was built with): the sphere's place is that in its frame
times the frame's transform in its base, the half-space's likewise; what is not written is 1e-5 (`constant_contact_force`, which the first
version called `derivative_smoothing`), 300, 50, and a half-space that is turned by -90 degrees about z.
"""

import random
import re
import sys

import command
import law
import numpy as np
import opensim_reads
import pytest
import rules
from models import FIXTURES
from opensim_shifts import at, shifted

sys.path.insert(0, str(FIXTURES))

from quirks import base  # noqa: E402  (the fixtures' own building blocks)

SEEDS = range(1, 25)
DEFAULTS = {"dissipation": 0.0, "static_friction": 0.0, "dynamic_friction": 0.0, "viscous_friction": 0.0, "transition_velocity": 0.01}
DEFAULTS |= {"constant_contact_force": 1e-5, "hertz_smoothing": 300.0, "hunt_crossley_smoothing": 50.0}
FLOOR = "0 0 -1.5707963267948966"
OFFSET = (0.02, -0.01, 0.03)  # m, of a frame on the right foot


class Old:
    """A random model of the dialect, and what its forces mean."""

    def __init__(self, seed):
        draw = random.Random(f"dialect {seed}")
        self.first = draw.random() < 0.3  # the first version of the class
        self.floor = draw.choice(["0 0 0", "0 -0.03 0", "0.5 0.0125 -1"])
        self.parts = []
        forces = [self.force(draw, f"contact_{name}_{side}", side) for side in "rl" for name in ("heel", "toe")[: draw.randint(1, 2)]]
        bodies, joints = base.FEET
        frame = base.indent(
            '<PhysicalOffsetFrame name="sole">\n\t<socket_parent>..</socket_parent>\n'
            f"\t<translation>{' '.join(map(str, OFFSET))}</translation>\n\t<orientation>0 0 0</orientation>\n</PhysicalOffsetFrame>",
            2,
        )
        foot = bodies[1].replace("</Body>", f"\t<components>\n{frame}\t</components>\n</Body>")
        text = base.model([bodies[0], foot, bodies[2]], joints, forces, [], name="old")
        self.text = re.sub(r"\t\t<ContactGeometrySet.*?</ContactGeometrySet>\n", "", text, flags=re.S) if draw.random() < 0.7 else text

    def force(self, draw, name, side):
        on_sole = side == "r" and not self.first and draw.random() < 0.5
        place = [draw.uniform(-0.05, 0.2), draw.uniform(-0.05, 0.05), draw.uniform(-0.05, 0.05)]
        radius = draw.choice([0.0325, 0.02, draw.uniform(0.01, 0.06)])
        names = ["stiffness", *DEFAULTS]
        written = {"stiffness": draw.uniform(1e5, 1e7)} | {one: draw.uniform(0.1, 0.9) for one in names[1:] if draw.random() < 0.7}
        for one, scale in (("constant_contact_force", 1e-5), ("hertz_smoothing", 500), ("hunt_crossley_smoothing", 80), ("dissipation", 4)):
            written |= {one: written[one] * scale} if one in written else {}
        values = DEFAULTS | written
        turned = f"<contact_half_space_orientation>{FLOOR}</contact_half_space_orientation>" if self.first or draw.random() < 0.5 else ""
        at_place = f"<contact_half_space_location>{self.floor}</contact_half_space_location>" if self.floor != "0 0 0" or draw.random() < 0.5 else ""
        applies = draw.random() < 0.85
        spelled = written | ({"constant_contact_force": None} if self.first else {})
        lines = [f"<{one}>{values[one]!r}</{one}>" for one in spelled if one in written]
        if self.first and "constant_contact_force" in written:
            lines = [line.replace("constant_contact_force", "derivative_smoothing") for line in lines]
        elif self.first:
            lines.append("<derivative_smoothing>1e-05</derivative_smoothing>")
        self.parts.append(
            {"name": name, "body": f"/bodyset/calcn_{side}", "place": np.add(place, OFFSET) if on_sole else np.array(place), "own": place, "frame": on_sole,
             "radius": radius, "values": values, "applies": applies}
        )  # fmt: skip
        frame = f"/bodyset/calcn_{side}" + ("/sole" if on_sole else "")
        return (
            f'<SmoothSphereHalfSpaceForce name="{name}">\n\t<socket_sphere_frame>{frame}</socket_sphere_frame>\n'
            f"\t<socket_half_space_frame>/ground</socket_half_space_frame>\n"
            + ("" if applies else "\t<appliesForce>false</appliesForce>\n")
            + f"\t<contact_sphere_radius>{radius!r}</contact_sphere_radius>\n"
            + f"\t<contact_sphere_location>{' '.join(map(repr, place))}</contact_sphere_location>\n\t{at_place}{turned}\n\t"
            + "\n\t".join(lines)
            + "\n</SmoothSphereHalfSpaceForce>"
        )


@pytest.fixture(scope="module")
def upgraded(tmp_path_factory):
    """`{seed: (the old model, the outcome of convert, its output, OpenSim's reading of both)}`."""
    folder = tmp_path_factory.mktemp("dialect")
    made = {}
    for seed in SEEDS:
        old, path, output = Old(seed), folder / f"{seed}.osim", folder / f"{seed}.new.osim"
        path.write_text(old.text)
        made[seed] = (old, path, command.run("convert", path, "--to", "smooth", "-o", output), output)
    readings = opensim_reads.read_models([path for _, path, *_ in made.values()] + [output for *_, output in made.values()])
    return {seed: (old, outcome, output, readings[str(path)], readings[str(output)]) for seed, (old, path, outcome, output) in made.items()}


@pytest.mark.parametrize("seed", SEEDS)
def test_opensim_reads_every_number_where_it_could_read_nothing(seed, upgraded):
    old, outcome, _, before, after = upgraded[seed]
    assert outcome.status == 0, outcome
    assert not before.get("builds") and not before["spheres"], "OpenSim drops the spheres of such a model"
    assert after["builds"], after
    spheres = {sphere["path"]: sphere for sphere in after["spheres"]}
    assert len(spheres) == len(old.parts) == len(after["forces"]) and len(after["half_spaces"]) == 1
    for part, force in zip(old.parts, after["forces"], strict=True):
        assert (force["name"], force["applies"]) == (part["name"], part["applies"])
        assert force["parameters"] == {name: value.hex() for name, value in part["values"].items()}
        sphere, plane = force["geometry"]
        assert plane == after["half_spaces"][0]["path"]
        own = spheres[sphere]
        assert own["radius"] == part["radius"].hex()
        assert own["location"] == [value.hex() for value in part["own"]]
        assert own["base"] == part["body"] and own["frame"] == part["body"] + ("/sole" if part["frame"] else "")
        assert np.allclose([float.fromhex(value) for value in own["centre_in_base"]], part["place"], rtol=1e-15, atol=1e-17)
    (floor,) = after["half_spaces"]
    assert floor["location"] == [float(value).hex() for value in old.floor.split()] and floor["frame"] == "/ground"


@pytest.mark.parametrize("seed", SEEDS)
def test_forces_are_those_of_the_old_class(seed, upgraded):
    """At rest, over and in the floor: the old class's law, in NumPy, at the places that the old file gives."""
    old, _, output, _, after = upgraded[seed]
    # The feet are 0.9 m below the pelvis at the default pose, and nothing is turned.
    heights = {part["name"]: -0.9 + part["place"][1] for part in old.parts}
    plane = float(old.floor.split()[1])
    lowest = min(heights[part["name"]] - part["radius"] for part in old.parts)
    ups = [plane - lowest + up for up in (0.004, 0.0, -0.002, -0.01, -0.03)]
    (states,) = shifted([(output, at(ups))])
    pressing = 0
    for up, state in zip(ups, states, strict=True):
        for part in (part for part in old.parts if part["applies"]):
            x = plane - (heights[part["name"]] + up - part["radius"])
            expected = law.force(rules.SMOOTH_SET, part["radius"], part["values"], x)
            found = state["forces"][f"/forceset/{part['name']}"]["Sphere.force.Y"]
            assert found == pytest.approx(expected, rel=1e-9, abs=1e-9), (part["name"], up)
            pressing += x > 0
    assert pressing or not any(part["applies"] for part in old.parts)


@pytest.mark.parametrize("seed", SEEDS[:6])
def test_rescale_works_on_it_as_it_is(seed, upgraded, tmp_path):
    """Rescaled and then converted is converted and then rescaled."""
    old, _, output, *_ = upgraded[seed]
    path, scaled, there, here = (tmp_path / name for name in ("old.osim", "scaled.osim", "there.osim", "here.osim"))
    path.write_text(old.text)
    assert command.rescale(path, 100.0, scaled).status == 0
    assert "socket_sphere_frame" in scaled.read_text()
    assert command.run("convert", scaled, "--to", "smooth", "-o", there).status == 0
    assert command.rescale(output, 100.0, here).status == 0
    one, other = opensim_reads.read_models([there, here]).values()
    assert (one["forces"], one["spheres"], one["half_spaces"]) == (other["forces"], other["spheres"], other["half_spaces"])


def test_transfer_writes_no_such_model(tmp_path):
    path = tmp_path / "old.osim"
    path.write_text(Old(1).text)
    outcome = command.run("transfer", path, "--from", "falisse2022", "--spheres", "4", "-o", tmp_path / "new.osim")
    assert outcome.status == 1 and "convert --to smooth" in outcome.error["message"] and not (tmp_path / "new.osim").exists(), outcome
