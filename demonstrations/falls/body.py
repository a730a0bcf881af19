"""A four-legged body of our own, at any size: `make(path, length_ratio, ...)`.

Trunk, neck with head, tail, and four legs of three bones. All joints but that to ground are hinges in the plane of walking, with a
torsional spring and a damper each. The trunk's centre of mass is a little to the right, so that the body rolls as well as pitches when it
falls. Each foot has three contact spheres.

Sizes are geometrically similar, and dynamically so under one gravity: with a length ratio of s, masses go with s³, moments of inertia with
s⁵, torsional stiffness with s⁴ (M g L), torsional damping with s^4.5 (M g L √(L/g)). Contact spheres have the places that similarity
asks for, and the radius and parameters of the reference: what `rescale` is for.
"""

from dataclasses import dataclass
from math import cos, sin

import opensim

MASS = 62.0  # kg, of the reference
GRAVITY = 9.81  # m/s2
LENGTH = 0.62  # m, of the reference: height of the hip joint above the soles
RADIUS = 0.03  # m, of its spheres
CONTACT = {
    "stiffness": 2e6,
    "dissipation": 1.0,
    "static_friction": 0.3,
    "dynamic_friction": 0.2,
    "viscous_friction": 0.5,
}
TRANSITION_VELOCITY = 0.05  # m/s
SMOOTHING = {"constant_contact_force": 1e-5, "hertz_smoothing": 300.0, "hunt_crossley_smoothing": 50.0}
LAWS = ("hunt_crossley", "smooth", "smooth_frictionless")
FRICTION = ("static_friction", "dynamic_friction", "viscous_friction")


@dataclass(frozen=True)
class Bone:
    """A bone below its hinge, at the size of the reference."""

    name: str
    share: float  # of the body's mass
    length: float  # m
    lean: float  # rad, from straight down at the default pose, forward
    stiffness: float  # N m/rad, of its hinge
    damping: float  # N m s/rad


# From the trunk down; hip and shoulder at one height, knees point forward and elbows back.
LEGS = {
    "hind": (
        -0.38,
        [
            Bone("thigh", 0.05, 0.27, 0.45, 240, 7),
            Bone("shank", 0.025, 0.27, -0.5, 200, 5),
            Bone("foot", 0.01, 0.14, 0.05, 60, 1.2),
        ],
    ),
    "fore": (
        0.38,
        [
            Bone("humerus", 0.045, 0.25, -0.4, 260, 7),
            Bone("radius", 0.022, 0.27, 0.35, 220, 5),
            Bone("hand", 0.009, 0.14, -0.05, 60, 1.2),
        ],
    ),
}
SIDES = {"r": 0.14, "l": -0.14}  # m, to the right of the middle
NECK = Bone("neck", 0.09, 0.3, 2.2, 120, 4)
TAIL = Bone("tail", 0.01, 0.3, -1.2, 3, 0.1)
# Centres of the spheres seen from the middle of the sole, m: two toes and a heel.
SOLE = [(0.04, 0.035), (0.04, -0.035), (-0.04, 0.0)]


class Maker:
    """Puts a model together; every number is multiplied by the power of the length ratio that similarity asks for."""

    def __init__(self, length_ratio: float, law: str) -> None:
        self.ratio, self.law = length_ratio, law
        self.model = opensim.Model()
        self.model.setName(f"quadruped_{MASS * length_ratio**3:.4g}kg")
        self.model.set_gravity(opensim.Vec3(0, -GRAVITY, 0))
        self.floor = opensim.ContactHalfSpace(
            opensim.Vec3(0), opensim.Vec3(0, 0, -1.5707963267948966), self.model.getGround(), "floor"
        )
        self.model.addContactGeometry(self.floor)

    def place(self, *metres: float) -> opensim.Vec3:
        return opensim.Vec3(*(self.ratio * value for value in metres))

    def body(
        self, name: str, share: float, centre: tuple[float, float, float], size: tuple[float, float, float]
    ) -> opensim.Body:
        """A body with the moments of inertia of a box of this size, m."""
        mass = MASS * share * self.ratio**3
        squares = [(self.ratio * edge) ** 2 for edge in size]
        moments = [
            mass / 12 * (squares[1] + squares[2]),
            mass / 12 * (squares[0] + squares[2]),
            mass / 12 * (squares[0] + squares[1]),
        ]
        new_body = opensim.Body(name, mass, self.place(*centre), opensim.Inertia(*moments))
        self.model.addBody(new_body)
        return new_body

    def hinge(
        self, bone: Bone, name: str, parent: opensim.Body, at: tuple[float, float, float], lean: float
    ) -> opensim.Body:
        """A bone that hangs on a parent; `lean` is that of the hinge at the default pose."""
        width = 0.2 * bone.length
        child = self.body(name, bone.share, (0, -bone.length / 2, 0), (width, bone.length, width))
        none = opensim.Vec3(0)
        joint = opensim.PinJoint(f"{name}_joint", parent, self.place(*at), none, child, none, none)
        coordinate = joint.updCoordinate()
        coordinate.setName(f"{name}_angle")
        coordinate.setDefaultValue(lean)
        self.model.addJoint(joint)
        spring = opensim.SpringGeneralizedForce(f"{name}_angle")
        spring.setName(f"{name}_spring")
        spring.setRestLength(lean)
        spring.setStiffness(bone.stiffness * self.ratio**4)
        spring.setViscosity(bone.damping * self.ratio**4.5)
        self.model.addForce(spring)
        return child

    def leg(self, trunk: opensim.Body, girdle: str, side: str) -> None:
        x, bones = LEGS[girdle]
        parent, at, before = trunk, (x, 0.0, SIDES[side]), 0.0
        for bone in bones:
            parent = self.hinge(bone, f"{bone.name}_{side}", parent, at, bone.lean - before)
            at, before = (0.0, -bone.length, 0.0), bone.lean
        self.spheres(parent, bones[-1], f"{girdle}_{side}")

    def spheres(self, foot: opensim.Body, bone: Bone, limb: str) -> None:
        """The spheres of one foot, level at the default pose."""
        for number, (forward, right) in enumerate(SOLE, start=1):
            # The foot leans: seen in its axes, the centre is as far forward and above the sole as upright.
            x = cos(bone.lean) * forward + sin(bone.lean) * RADIUS
            y = -sin(bone.lean) * forward + cos(bone.lean) * RADIUS - bone.length
            name = f"{limb}_{number}"
            sphere = opensim.ContactSphere(RADIUS, self.place(x, y, right), foot, name)
            self.model.addContactGeometry(sphere)
            self.model.addForce(self.contact(f"contact_{name}", sphere))

    def contact(self, name: str, sphere: opensim.ContactSphere) -> opensim.Force:
        """The contacts of the reference, for every size."""
        if self.law.startswith("smooth"):
            force = opensim.SmoothSphereHalfSpaceForce(name, sphere, self.floor)
            for key, value in {**CONTACT, **SMOOTHING, "transition_velocity": TRANSITION_VELOCITY}.items():
                without = key in FRICTION and self.law == "smooth_frictionless"
                opensim.PropertyHelper.setValueDouble(0.0 if without else value, force.updPropertyByName(key))
            return force
        force = opensim.HuntCrossleyForce()
        force.setName(name)
        force.addGeometry("floor")
        force.addGeometry(sphere.getName())
        force.setStiffness(CONTACT["stiffness"])
        force.setDissipation(CONTACT["dissipation"])
        force.setStaticFriction(CONTACT["static_friction"])
        force.setDynamicFriction(CONTACT["dynamic_friction"])
        force.setViscousFriction(CONTACT["viscous_friction"])
        force.setTransitionVelocity(TRANSITION_VELOCITY)
        return force


def make(path, length_ratio: float = 1.0, law: str = "hunt_crossley") -> None:
    """Writes the body to a file: at the size of the reference, or of a ratio to it."""
    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Error")
    maker = Maker(length_ratio, law)
    limbs = sum(bone.share for _, bones in LEGS.values() for bone in bones) * len(SIDES)
    trunk = maker.body("trunk", 1 - limbs - NECK.share - TAIL.share, (0, 0.05, 0.006), (0.9, 0.28, 0.26))
    joint = opensim.FreeJoint("root", maker.model.getGround(), trunk)
    for number, name in enumerate(("roll", "yaw", "pitch", "tx", "ty", "tz")):
        joint.upd_coordinates(number).setName(f"trunk_{name}")
    joint.upd_coordinates(4).setDefaultValue(LENGTH * length_ratio)
    maker.model.addJoint(joint)
    maker.hinge(NECK, "neck", trunk, (0.45, 0.1, 0), NECK.lean)
    maker.hinge(TAIL, "tail", trunk, (-0.45, 0.05, 0), TAIL.lean)
    for girdle in LEGS:
        for side in SIDES:
            maker.leg(trunk, girdle, side)
    maker.model.finalizeConnections()
    maker.model.printToXML(str(path))
