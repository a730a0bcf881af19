"""Feet that slide: a body lands with a speed along the ground, or it stands and is pushed."""

import numpy as np
import opensim
from body import GRAVITY, LENGTH, MASS

HEIGHT = 0.1  # L: a landing body falls from there
PUSH = 0.2  # body weights, on the trunk of a standing body
SETTLE_TIME, PUSH_TIME = 8.0, 1.0  # √(L/g): until it stands, and how long it is pushed
AFTER = 8.0  # √(L/g): how long a landing, and a body from its push on, is followed
STOP = 0.01  # √(L/g): how often one looks at it
# Axes along the ground, and coordinates of the trunk along them.
WAYS = {"sideways": (2, "trunk_tz"), "forward": (0, "trunk_tx")}
# Speeds of landings, √(gL). At 0.3 sideways this body topples over its own feet.
SPEEDS = {"sideways": 0.2, "forward": 0.3}
MOTIONS = tuple(f"{kind}_{way}" for kind in ("landing", "push") for way in WAYS)
UP = 1


def slide(path, motion, length_ratio, accuracy, after=AFTER):
    """One such motion, in OpenSim.

    Parameters
    ----------
    path : str
        The model.
    motion : str
        One of `MOTIONS`.
    length_ratio : float
        Of the body to the reference.
    accuracy : float
        Of the integrator.
    after : float
        How long it is followed, √(L/g).

    Returns
    -------
    dict
        `slide_over_hip_height`: how far the feet, the mean of their spheres, have come along the way. `along_bw`, `up_bw`: the largest
        forces of the ground along the way and upwards, in body weights.
    """
    kind, way = motion.split("_")
    seen = Slide(path, way, length_ratio, accuracy)
    if kind == "landing":
        seen.throw(SPEEDS[way])
        seen.follow(after)
    else:
        seen.follow(SETTLE_TIME)
        seen.forget()
        seen.follow(PUSH_TIME, pushed=True)
        seen.follow(after - PUSH_TIME)
    return seen.slip_m()


class Slide:
    """A body in motion, and what its feet meet."""

    def __init__(self, path, way, length_ratio, accuracy):
        opensim.Logger.removeFileSink()
        opensim.Logger.setLevelString("Error")
        self.axis, self.coordinate = WAYS[way]
        self.accuracy = accuracy
        self.length = LENGTH * length_ratio
        self.time_unit = (self.length / GRAVITY) ** 0.5
        self.weight = MASS * length_ratio**3 * GRAVITY
        self.model = opensim.Model(str(path))
        self.push = self._push()
        self.state = self.model.initSystem()
        self.contacts = list(_contacts(self.model))
        self.spheres = list(_spheres(self.model))
        self.forget()

    def _push(self):
        trunk, force = self.model.updBodySet().get("trunk"), [0.0] * 3
        force[self.axis] = PUSH * self.weight
        push = opensim.PrescribedForce("push", trunk)
        push.setForceFunctions(*map(opensim.Constant, force))
        push.setPointFunctions(*(opensim.Constant(trunk.getMassCenter().get(axis)) for axis in range(3)))
        push.setForceIsInGlobalFrame(True)
        push.setPointIsInGlobalFrame(False)
        self.model.addForce(push)
        return push

    def forget(self):
        """Starts the recording of results again."""
        self.begin, self.along, self.up = self._feet(self.state), 0.0, 0.0

    def throw(self, speed):
        """Lifts the body to where it falls from, with a speed along the way in √(gL)."""
        coordinates = self.model.getCoordinateSet()
        coordinates.get("trunk_ty").setValue(self.state, (1 + HEIGHT) * self.length)
        coordinates.get(self.coordinate).setSpeedValue(self.state, speed * (GRAVITY * self.length) ** 0.5)

    def follow(self, duration, pushed=False):
        """Integrates for a time in √(L/g), with the push or without it."""
        self.push.setAppliesForce(self.state, pushed)
        manager = opensim.Manager(self.model)
        manager.setWriteToStorage(False)
        manager.setPerformAnalyses(False)
        manager.setIntegratorMethod(opensim.Manager.IntegratorMethod_RungeKuttaMerson)
        manager.setIntegratorAccuracy(self.accuracy)
        manager.initialize(self.state)
        start, stops = self.state.getTime(), round(duration / STOP)
        for number in range(1, stops + 1):
            state = manager.integrate(start + duration * self.time_unit * number / stops)
            force = self._force(state)
            self.along = max(self.along, abs(force[self.axis]))
            self.up = max(self.up, force[UP])
        self.state = opensim.State(state)

    def slip_m(self):
        """See `slide`."""
        return {
            "slide_over_hip_height": float(self._feet(self.state) - self.begin) / self.length,
            "along_bw": float(self.along) / self.weight,
            "up_bw": float(self.up) / self.weight,
        }

    def _feet(self, state):
        self.model.realizePosition(state)
        places = (
            sphere.getFrame().findStationLocationInGround(state, sphere.get_location()) for sphere in self.spheres
        )
        return np.mean([place.get(self.axis) for place in places])

    def _force(self, state):
        """The force of the ground on the body, N."""
        self.model.realizeDynamics(state)
        return sum(_on_body(contact, state) for contact in self.contacts)


def _spheres(model):
    geometries = model.getContactGeometrySet()
    for index in range(geometries.getSize()):
        sphere = opensim.ContactSphere.safeDownCast(geometries.get(index))
        if sphere is not None:
            yield sphere


def _contacts(model):
    for component in model.getComponentsList():
        if component.getConcreteClassName() in ("HuntCrossleyForce", "SmoothSphereHalfSpaceForce"):
            kind = getattr(opensim, component.getConcreteClassName())
            yield kind.safeDownCast(model.getComponent(component.getAbsolutePathString()))


def _on_body(contact, state):
    """The smooth class records the force on its sphere first, the other one that on the floor."""
    record = contact.getRecordValues(state)
    sign = -1 if contact.getConcreteClassName() == "HuntCrossleyForce" else 1
    return sign * np.array([record.get(axis) for axis in range(3)])
