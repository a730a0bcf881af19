"""The planar walker: seven bodies, nine coordinates, six torques, four smooth spheres.

A trunk with head and arms, two thighs, two shanks, two feet; each foot has a sphere under the heel and one under the toes. Lengths are
those of a human 1.70 m high and 62 kg heavy, and shares of mass about so (Winter, Biomechanics and Motor Control of Human Movement, 4th
ed., 2009, Fig. 4.1 and Table 4.1), with two differences: feet are twice as heavy, as in boots, and dampers are two and a half times those
of Falisse et al. (2022). Both make the equations of motion less stiff; the walker is not a copy of a human.

Everything follows from the factor of length: masses with its third power, inertias with the fifth, torques with the fourth, times with
the square root.
"""

import math
from dataclasses import dataclass

import opensim as osim

GRAVITY = 9.80665  # m/s2
HEIGHT = 1.70  # m
MASS = 62.0  # kg

THIGH = 0.245 * HEIGHT
SHANK = 0.246 * HEIGHT
ANKLE_HEIGHT = 0.039 * HEIGHT
TRUNK = 0.288 * HEIGHT
LEG = THIGH + SHANK + ANKLE_HEIGHT  # hip to ground: the unit of length, m
RADIUS = 0.05  # of all spheres, m
SPHERES = {"heel": -0.08, "toe": 0.12}  # in front of the ankle, m

SIDES = ("r", "l")
JOINTS = ("hip", "knee", "ankle")
# Beyond these angles (rad) joints push back, with exponentials: 2 % of the largest torque at the limit, and e times more every 1/15 rad.
LIMITS = {"hip": (-0.6, 1.6), "knee": (-2.2, 0.0), "ankle": (-0.6, 0.3)}
STOP_SHARE, STOP_RATE = 0.02, 15.0
DAMPING = 5.0  # N m s/rad, all joints
TORQUE = 0.5 * MASS * GRAVITY * LEG  # at a control of 1, N m: far above what walking needs


@dataclass(frozen=True)
class Segment:
    """A share of the body's mass; centre of mass (m, from the proximal joint) and radius of gyration about it (m)."""

    share: float
    forward: float
    up: float
    gyration: float


SEGMENTS = {
    "trunk": Segment(0.640, 0.0, 0.626 * TRUNK, 0.496 * TRUNK),
    "thigh": Segment(0.100, 0.0, -0.433 * THIGH, 0.323 * THIGH),
    "shank": Segment(0.050, 0.0, -0.433 * SHANK, 0.302 * SHANK),
    "foot": Segment(0.030, 0.04, -0.02, 0.09),
}
CHAIN = (("hip", "thigh", 0.0), ("knee", "shank", THIGH), ("ankle", "foot", SHANK))

# Of the smoothed force, without dimensions: those of Falisse et al. (2022), by (C.2), (C.5) and (C.10) of the paper.
CONSTANT_INDENTATION = 0.1
STATE_SLOPE = 9.6
SPEED_SLOPE = 50 * math.sqrt(0.032)  # s/m times the root of a metre


def build(length=1.0):
    """The model, `length` times as long as the human one, with contacts that are made for the human one.

    Parameters
    ----------
    length : float
        Factor of length. Masses follow with its third power.

    Returns
    -------
    opensim.Model
        Spheres have the radius and the contact parameters of factor 1, whatever the length: those of other sizes are rescaled by
        `osim_contact_scale.rescale`. Their centres stand where rescaled spheres touch the sole.
    """
    model = osim.Model()
    model.setName("walker")
    model.setGravity(osim.Vec3(0, -GRAVITY, 0))
    ground = model.getGround()
    trunk = _body(model, "trunk", "trunk", length)
    root = osim.PlanarJoint("root", ground, trunk)
    for index, name in enumerate(("tilt", "forward", "up")):
        root.upd_coordinates(index).setName(name)
    model.addJoint(root)
    floor = osim.ContactHalfSpace(osim.Vec3(0), osim.Vec3(0, 0, -math.pi / 2), ground, "floor")
    model.addContactGeometry(floor)
    for side in SIDES:
        _leg(model, trunk, side, length)
        for name, forward in SPHERES.items():
            _sphere(model, floor, f"{name}_{side}", side, forward, length)
    model.finalizeConnections()
    return model


def _body(model, name, kind, length):
    segment = SEGMENTS[kind]
    mass = segment.share * MASS * length**3
    inertia = mass * (segment.gyration * length) ** 2
    centre = osim.Vec3(segment.forward * length, segment.up * length, 0)
    body = osim.Body(name, mass, centre, osim.Inertia(inertia, inertia, inertia))
    model.addBody(body)
    return body


def _leg(model, trunk, side, length):
    parent = trunk
    zero = osim.Vec3(0)
    for joint, kind, down in CHAIN:
        name = f"{joint}_{side}"
        body = _body(model, f"{kind}_{side}", kind, length)
        pin = osim.PinJoint(name, parent, osim.Vec3(0, -down * length, 0), zero, body, zero, zero)
        pin.upd_coordinates(0).setName(name)
        model.addJoint(pin)
        _joint_forces(model, joint, name, length)
        parent = body


def _joint_forces(model, joint, name, length):
    torque = osim.CoordinateActuator(name)
    torque.setName(f"torque_{name}")
    torque.setOptimalForce(TORQUE * length**4)
    torque.setMinControl(-1)
    torque.setMaxControl(1)
    model.addForce(torque)
    damper = osim.SpringGeneralizedForce(name)
    damper.setName(f"damper_{name}")
    damper.setStiffness(0)
    damper.setViscosity(DAMPING * length**4.5)
    model.addForce(damper)
    low, high = LIMITS[joint]
    push = f"{STOP_SHARE * TORQUE * length**4:.17g}*(exp(-{STOP_RATE}*(q-({low})))-exp({STOP_RATE}*(q-({high}))))"
    stop = osim.ExpressionBasedCoordinateForce(name, push)
    stop.setName(f"stop_{name}")
    model.addForce(stop)


def _sphere(model, floor, name, side, forward, length):
    foot = model.getBodySet().get(f"foot_{side}")
    centre = osim.Vec3(forward * length, (RADIUS - ANKLE_HEIGHT) * length, 0)
    sphere = osim.ContactSphere(RADIUS, centre, foot, name)
    model.addContactGeometry(sphere)
    force = osim.SmoothSphereHalfSpaceForce(f"contact_{name}", sphere, floor)
    force.set_stiffness(1e6)
    force.set_dissipation(1.0)
    force.set_constant_contact_force((CONSTANT_INDENTATION * RADIUS) ** 2)
    force.set_hertz_smoothing(STATE_SLOPE / RADIUS)
    force.set_hunt_crossley_smoothing(SPEED_SLOPE / math.sqrt(RADIUS))
    force.set_static_friction(0)
    force.set_dynamic_friction(0)
    force.set_viscous_friction(5.0)
    force.set_transition_velocity(0.2)
    model.addForce(force)


def write(path, length=1.0):
    """Writes the model as OpenSim prints it, and returns the path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    build(length).printToXML(str(path))
    return path
