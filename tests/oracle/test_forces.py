"""The forces of both classes against the real OpenSim, the normal force from well before contact to half a radius deep.

The indentation is R - h for OpenSim, with h the height of the sphere's centre: for h near R that difference has lost
digits, but it is exact in itself (or rounded once), and Python's doubles make the same one. So a height is chosen near
the wanted x, and the x compared at is R - h (R1 + R2 - h for two spheres) as both sides compute it. Nothing else is
rounded on the way: the joint's angle is 0, the floor's frame is turned by a quarter, whose cosine of 6e-17 meets only
lengths of 0, and the height goes through the joint unchanged.
"""

import re
import subprocess
import sys
from dataclasses import dataclass, field
from itertools import product

import numpy as np
import pytest

import command
from models import FIXTURES
from opensim_forces import SLIDE, forces

sys.path.insert(0, str(FIXTURES))

import model_text as text  # noqa: E402  (the fixtures' own building blocks)

TOLERANCE = 1e-12  # of F_cf (F_e without smoothing), times 1 + 3/2 alpha |rate|

RADII = (0.002, 0.032, 0.25)  # m
STIFFNESSES = (1e4, 1e6, 2.4e7)  # N/m2
DISSIPATIONS = (0.0, 0.5, 2.0, 8.0)  # s/m
INDENTATIONS = (-1.0, -0.5, -0.1, -0.01, -1e-4, 0.0, 1e-4, 0.01, 0.1, 0.16, 0.35, 0.5)  # of R
RATES = (-20.0, -2.0, -0.4, -0.05, 0.0, 0.05, 0.4, 3.0)  # m/s
SMOOTHING = ("constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing")
FRICTION = {"static_friction": 0.0, "dynamic_friction": 0.0, "viscous_friction": 0.0}


@dataclass(frozen=True)
class Contact:
    """A sphere; the second surface is of the same material and flat unless told."""

    kind: str
    radius: float
    stiffness: float
    dissipation: float
    smoothing: dict = field(default_factory=dict)
    second: dict = field(default_factory=dict)  # stiffness and dissipation
    second_radius: float | None = None

    @property
    def reach(self):
        """The height of the centre at which the contact begins."""
        return self.radius if self.second_radius is None else self.radius + self.second_radius

    @property
    def material(self):
        return {"stiffness": self.stiffness, "dissipation": self.dissipation}

    def moduli(self):
        """E^(2/3) of both surfaces."""
        return [np.cbrt(np.float64(one["stiffness"])) ** 2 for one in (self.material, self.second or self.material)]

    def mixed_dissipation(self):
        """alpha of both surfaces by Simbody's rule."""
        one, other = self.moduli()
        share = other / (one + other)
        return self.dissipation * share + (self.second or self.material)["dissipation"] * (1 - share)

    def scale(self, x, rate):
        """The force with which the difference of two forces is compared, in N: F_cf or F_e (1, A.3, C.1), times the speed's part."""
        one, other = self.moduli()
        radius = self.radius if self.second_radius is None else 1 / (1 / self.radius + 1 / self.second_radius)
        square = x * x + self.smoothing["constant_contact_force"] if self.smoothing else max(x, 0.0) ** 2
        elastic = 4 / 3 * np.sqrt(radius) * (one * other / (one + other)) ** 1.5 * square**0.75
        return elastic * (1 + 1.5 * self.mixed_dissipation() * abs(rate))

    def rates(self):
        """The common ones, and the one at which the damper takes the whole elastic force."""
        alpha = self.mixed_dissipation()
        return [*RATES, -2 / (3 * alpha) if alpha else -5.0]

    def states(self):
        """`(height, x, rate)` of each point."""
        for share, rate in product(INDENTATIONS, self.rates()):
            height = self.reach - share * self.radius
            yield height, self.reach - height, rate

    def line(self, x, rate):
        """The case as examples/forces.rs of contact-scaling reads it."""
        numbers = {"radius": self.radius, **self.material, **self.smoothing}
        numbers |= {f"{name}_2": value for name, value in self.second.items()}
        numbers |= {"radius_2": self.second_radius} if self.second_radius is not None else {}
        numbers |= {"indentation": x, "speed": rate}
        return " ".join([self.kind, *(f"{name}={float(value)!r}" for name, value in numbers.items())])


def smoothings(radius):
    """OpenSim's own; none of the constant force; the paper's suggestion for this radius; wide and narrow ones."""
    root = radius**0.5
    for values in (
        (1e-5, 300.0, 50.0),
        (0.0, 300.0, 50.0),
        ((0.1 * radius) ** 2, 10 / radius, 9 / root),
        (9e-5, 60.0, 5.0),
        ((0.01 * radius) ** 2, 200 / radius, 500.0),
        (0.0, 2 / radius, 0.5 / root),
    ):
        yield dict(zip(SMOOTHING, values))


def grid():
    return product(RADII, STIFFNESSES, DISSIPATIONS)


def unequal(dissipation, stiffness):
    """Second surfaces: softer and damped, stiffer and undamped, nearly rigid."""
    yield {"stiffness": 0.1 * stiffness, "dissipation": 1.0}
    yield {"stiffness": 7.0 * stiffness, "dissipation": 0.0}
    yield {"stiffness": 1e6 * stiffness, "dissipation": 3 * dissipation}


HUNT_CROSSLEY = "HuntCrossleyForce"
CONTACTS = {
    "smooth": [
        Contact("SmoothSphereHalfSpaceForce", *values, smoothing)
        for values in grid()
        for smoothing in smoothings(values[0])
    ],
    "hunt_crossley": [Contact(HUNT_CROSSLEY, *values) for values in grid()],
    "unequal_surfaces": [
        Contact(HUNT_CROSSLEY, *values, second=second) for values in grid() for second in unequal(values[2], values[1])
    ],
    "sphere_on_sphere": [
        Contact(HUNT_CROSSLEY, *values, second_radius=share * values[0])
        for values in grid()
        for share in (0.5, 1.0, 30.0)
    ],
    "unequal_sphere_on_sphere": [
        Contact(HUNT_CROSSLEY, *values, second=second, second_radius=0.7 * values[0])
        for values in grid()
        for second in unequal(values[2], values[1])
    ],
}


def model(contacts):
    """A document with a body of its own for each contact, all of them in the same place."""
    bodies, joints, made, geometry = [], [], [], [text.floor()]
    for k, contact in enumerate(contacts):
        body, sphere, other = f"body{k}", f"sphere{k}", "floor"
        bodies.append(text.body(body, 1.0, (0, 0, 0), (1, 1, 1)))
        coordinates = [(f"{body}_{axis}", 0.0) for axis in ("turn", "along", "up")]
        joints.append(text.joint("PlanarJoint", f"joint{k}", "/ground", (0, 0, 0), f"/bodyset/{body}", coordinates))
        geometry.append(text.sphere(sphere, f"/bodyset/{body}", (0, 0, 0), contact.radius))
        if contact.second_radius is not None:
            other = f"other{k}"
            geometry.append(text.sphere(other, "/ground", (0, 0, 0), contact.second_radius))
        made.append(force(contact, f"contact{k}", sphere, other))
    return text.document(text.model("contacts", (0, -9.81, 0), bodies, joints, made, geometry))


def force(contact, name, sphere, other):
    """The force of one contact; unequal surfaces have two ContactParameters."""
    if contact.smoothing:
        material = contact.material | FRICTION | {"transition_velocity": 0.2} | contact.smoothing
        return text.smooth_force(name, sphere, material)
    if contact.second:
        materials = [([sphere], contact.material), ([other], contact.second)]
    else:
        materials = [([other, sphere], contact.material)]
    return text.hunt_crossley_force(
        name, [text.contact_parameters(names, material | FRICTION) for names, material in materials], 0.2
    )


def forces_by_program(cases):
    """Our forces: one for each `(contact, x, rate)`."""
    lines = "".join(contact.line(x, rate) + "\n" for contact, x, rate in cases)
    process = subprocess.run([command.example("forces")], input=lines, capture_output=True, text=True)
    assert process.returncode == 0, process.stderr
    return [float(line) for line in process.stdout.splitlines()]


def relative_difference(case, our, their):
    """The difference of two forces of a case as a share of what it is compared with; nothing may differ from no force."""
    scale = case[0].scale(*case[1:])
    if scale == 0:
        return 0.0 if our == their == 0 else np.inf
    return abs(our - their) / scale


@pytest.mark.parametrize("group", CONTACTS)
def test_normal_force_is_opensims(group, tmp_path):
    contacts = CONTACTS[group]
    path = tmp_path / "contacts.osim"
    path.write_text(model(contacts), encoding="utf-8")
    # At each moment every contact is in one of its states.
    moments = list(zip(*(contact.states() for contact in contacts), strict=True))
    theirs = forces(path, [[(height, rate) for height, _, rate in moment] for moment in moments])
    theirs = [value for moment in theirs for value in moment]
    cases = [(contact, x, rate) for moment in moments for contact, (_, x, rate) in zip(contacts, moment)]
    result = [relative_difference(*all_three) for all_three in zip(cases, forces_by_program(cases), theirs, strict=True)]
    worst = int(np.argmax(result))  # a NaN, if there is one
    assert result[worst] <= TOLERANCE, (result[worst], cases[worst])
    assert sum(their > 0 for their in theirs) > len(theirs) / 4, "hardly any contact in the grid"


# Static, dynamic and viscous friction (s/m), transition velocity (m/s), and what `check` says of them.
FRICTIONS = (
    ((0.8, 0.8, 0.5, 0.2), None),
    ((0.2, 0.8, 0.0, 0.7), ("dynamic-above-static", "warning")),
    ((2.5, 0.8, 0.0, 0.7), ("large-friction", "warning")),
    ((0.8, 0.8, 12.0, 0.2), ("large-friction", "warning")),
    ((0.8, 0.8, 5.0, 0.2), ("large-friction", "remark")),
    ((0.8, 0.8, 0.0, 200.0), ("odd-transition-velocity", "warning")),
    ((0.8, 0.6, 0.0, 0.0), ("odd-transition-velocity", "remark")),
    ((0.0, 0.0, 0.0, 0.2), ("no-friction", "remark")),
)
CODES_OF_FRICTION = {said[0] for _, said in FRICTIONS if said}


@pytest.mark.parametrize("kind", ["SmoothSphereHalfSpaceForce", HUNT_CROSSLEY])
@pytest.mark.parametrize(("numbers", "said"), FRICTIONS)
def test_friction_is_simbodys_at_the_limits_of_check_too(kind, numbers, said, tmp_path):
    static, dynamic, viscous, transition = numbers
    smoothing = dict(zip(SMOOTHING, (1e-5, 300.0, 50.0))) if kind != HUNT_CROSSLEY else {}
    written = model([Contact(kind, 0.032, 1e6, 2.0, smoothing)])
    for name, value in zip((*FRICTION, "transition_velocity"), numbers, strict=True):
        written, count = re.subn(f"<{name}>[^<]*<", f"<{name}>{value!r}<", written)
        assert count == 1, name
    path = tmp_path / "contact.osim"
    path.write_text(written, encoding="utf-8")
    (normal,), (along,) = (forces(path, [[(0.03, 0.0)]], axis)[0] for axis in "YX")
    slip = np.sqrt(SLIDE**2 + smoothing.get("constant_contact_force", 0.0))
    relative = slip / transition if transition else np.inf
    coefficient = min(relative, 1.0) * (dynamic + 2 * (static - dynamic) / (1 + relative**2)) + viscous * slip
    assert along == pytest.approx(-normal * coefficient * SLIDE / slip, rel=1e-12)
    found = {(one["code"], one["severity"]) for one in command.run("check", path).report["findings"]}
    assert {one for one in found if one[0] in CODES_OF_FRICTION} == ({said} if said else set())
