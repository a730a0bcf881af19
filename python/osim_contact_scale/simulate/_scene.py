"""A whole model in OpenSim, its contact spheres above the ground, and the coordinate that lifts it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from .._errors import ContactScaleError, ModelError
from ._contacts import Contact, base_frame, forces_without_constant, model_error
from ._poses import Array, Ball, Pose, vector_of_vec3

#: Change of a coordinate that is tried to see which bodies move; in m, or in rad.
_TRIAL_STEP = 0.1
#: Smaller differences of places in m, and of directions, count as 0.
_TOLERANCE = 1e-9
#: Greatest slope of a half-space, in rad. Some models have 1.5708 for a right angle.
_MAX_SLOPE = 1e-3


def quiet_opensim() -> Any:
    """Imports OpenSim and switches off its messages and its log file in this process."""
    import opensim

    # OpenSim would create opensim.log in the current folder with its first message.
    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Off")
    return opensim


@contextmanager
def model_errors(path: str, doing: str) -> Iterator[None]:
    """Turns exceptions into a `ModelError` that names the file: OpenSim raises many kinds of them."""
    try:
        yield
    except ContactScaleError as error:
        if error.path is not None:
            raise
        raise ModelError(error.code, error.message, path=path) from None
    except Exception as error:
        reason = " ".join(str(error).split())
        raise ModelError("simulation", f"OpenSim could not {doing}: {reason}", path=path) from error


def open_model(opensim: Any, path: str) -> Any:
    """Reads the model of a file.

    Raises
    ------
    ModelError
        OpenSim cannot read the model or connect its parts.
    """
    with model_errors(path, "read this model"):
        model = opensim.Model(os.path.abspath(path))
        model.finalizeConnections()
    return model


class Scene:
    """A model at its default pose that can be lifted, and the forces of its contacts.

    Lengths in m, forces in N, masses in kg. Methods realize the states that they are given as far as they need it.

    Raises
    ------
    ModelError
        There is no gravity, no coordinate that lifts the body, no sphere on it, or no level ground.
    """

    def __init__(self, opensim: Any, model: Any, contacts: Sequence[Contact]) -> None:
        self.opensim, self.model, self.contacts = opensim, model, contacts
        self.gravity_m_s2, self.up = _gravity_and_up(model)
        self._up = tuple(map(float, self.up))
        self.state = model.initSystem()
        model.realizePosition(self.state)
        self.lift, self.per_metre, self.moving = self._find_lift()
        self.mass_kg = float(sum(body.getMass() for body in self.moving))
        if not self.mass_kg > 0:
            raise model_error("the bodies that the contact spheres are on have no mass")
        self.balls = self._find_balls()

    @property
    def weight_n(self) -> float:
        """M g."""
        return self.mass_kg * self.gravity_m_s2

    @property
    def reference_radius_m(self) -> float:
        """R = √(Σ R²/n), the unit of dimensionless lengths."""
        return float(np.sqrt(np.mean([ball.radius_m**2 for ball in self.balls])))

    @property
    def reference_time_s(self) -> float:
        """√(R/g), the unit of dimensionless times."""
        return float(np.sqrt(self.reference_radius_m / self.gravity_m_s2))

    def heights_m(self, state: Any) -> list[float]:
        """Heights of each sphere's lowest point above the ground."""
        self.model.realizePosition(state)
        return [ball.height_m(state) for ball in self.balls]

    def lowest_m(self, state: Any) -> float:
        """Height of the lowest point of all spheres above the ground."""
        return min(self.heights_m(state))

    def force_n(self, state: Any) -> float:
        """Force of all contacts on the body, upwards.

        Raises
        ------
        ModelError
            The force is NaN or infinite.
        """
        self.model.realizeDynamics(state)
        total = sum(contact.force_n(state, self._up) for contact in self.contacts)
        if not np.isfinite(total):
            zero = ", ".join(forces_without_constant(self.contacts))
            why = f": constant_contact_force is 0, and nothing slips (in {zero})" if zero else ""
            raise model_error(f"OpenSim's contact force is not a number{why}")
        return total

    def speed_m_s(self, state: Any) -> float:
        """Speed of the centre of mass, upwards."""
        self.model.realizeVelocity(state)
        return self._mean(lambda body: body.findStationVelocityInGround(state, body.getMassCenter()))

    def com_height_m(self, state: Any) -> float:
        """Height of the centre of mass above the ground."""
        self.model.realizePosition(state)
        return (
            self._mean(lambda body: body.findStationLocationInGround(state, body.getMassCenter()))
            - self.balls[0].level_m
        )

    def _mean(self, body_vector: Callable[[Any], Any]) -> float:
        """The upward component of a vector of each body, averaged by mass."""
        parts = (body.getMass() * float(vector_of_vec3(body_vector(body)) @ self.up) for body in self.moving)
        return float(sum(parts)) / self.mass_kg

    def place(self, state: Any, height_m: float) -> None:
        """Lifts the body until the lowest point of all spheres is at this height above the ground; the pose does not change."""
        self.lift.setLocked(state, False)
        distance = height_m - self.lowest_m(state)
        self.lift.setValue(state, self.lift.getValue(state) + distance * self.per_metre, False)
        # A copy of a state that is not realized may have the old positions of frames.
        self.model.realizePosition(state)

    def _find_lift(self) -> tuple[Any, float, list[Any]]:
        """The coordinate that lifts all spheres straight up, its change for a lift of 1 m, and the bodies that it lifts."""
        bodies = _all_bodies(self.opensim, self.model)
        before = [Pose.in_ground(body, self.state) for body in bodies]
        sphere_bodies = {
            base_frame(sphere).getAbsolutePathString() for contact in self.contacts for sphere in contact.spheres
        }
        coordinates = self.model.getCoordinateSet()
        for place in range(coordinates.getSize()):
            coordinate = coordinates.get(place)
            after = self._poses_after_trial(coordinate, bodies)
            moved = [number for number, poses in enumerate(zip(before, after)) if _is_moved(*poses)]
            carries = any(bodies[number].getAbsolutePathString() in sphere_bodies for number in moved)
            risen = _common_rise([(before[number], after[number]) for number in moved], self.up) if carries else None
            if risen is not None:
                return coordinate, _TRIAL_STEP / risen, [bodies[number] for number in moved]
        expected = "expected a joint between ground and the body that leaves it free to move up and down"
        raise model_error(f"no coordinate lifts the contact spheres straight against gravity: {expected}")

    def _poses_after_trial(self, coordinate: Any, bodies: Sequence[Any]) -> list[Pose]:
        """Poses of bodies after a change of this coordinate."""
        trial = self.opensim.State(self.state)
        coordinate.setLocked(trial, False)
        coordinate.setValue(trial, coordinate.getValue(trial) + _TRIAL_STEP, False)
        self.model.realizePosition(trial)
        return [Pose.in_ground(body, trial) for body in bodies]

    def _find_balls(self) -> list[Ball]:
        """The spheres, each once, above half-spaces that do not move."""
        moving = {body.getAbsolutePathString() for body in self.moving}
        balls: dict[str, Ball] = {}
        for contact in self.contacts:
            floors = [floor for floor in contact.floors if base_frame(floor).getAbsolutePathString() not in moving]
            for sphere in contact.spheres:
                if not floors or base_frame(sphere).getAbsolutePathString() not in moving:
                    names = f"the sphere {sphere.getName()} of {contact.force.getName()}"
                    raise model_error(
                        f"{names} is not on the body that moves, above a half-space that does not: select others"
                    )
                for floor in floors:
                    ball = Ball(self.opensim, sphere, floor, self.state)
                    self._check_level(ball)
                    first_ball = balls.setdefault(sphere.getAbsolutePathString(), ball)
                    if abs(first_ball.height_m(self.state) - ball.height_m(self.state)) > _TOLERANCE:
                        raise model_error(
                            f"the sphere {ball.name} meets half-spaces at different heights: select forces of one"
                        )
        return list(balls.values())

    def _check_level(self, ball: Ball) -> None:
        if np.linalg.norm(ball.normal - self.up) > _MAX_SLOPE:
            raise model_error(
                f"the half-space below {ball.name} is not level: its direction up must be against gravity"
            )


def _gravity_and_up(model: Any) -> tuple[float, Array]:
    """The size of gravity, and the direction against it."""
    gravity = vector_of_vec3(model.get_gravity())
    size = float(np.linalg.norm(gravity))
    if not size > 0:
        raise model_error("gravity is 0: nothing falls, and nothing has a weight")
    return size, -gravity / size


def _all_bodies(opensim: Any, model: Any) -> list[Any]:
    """All bodies. OpenSim divides one body of a loop; the parts belong to that body and are left out."""
    bodies = [body for body in map(opensim.Body.safeDownCast, list(model.getComponentsList())) if body is not None]
    return [body for body in bodies if body.getOwner().getConcreteClassName() != "Body"]


def _is_moved(before: Pose, after: Pose) -> bool:
    moved, turned = after.origin_m - before.origin_m, after.rotation - before.rotation
    return float(np.abs(moved).max()) > _TOLERANCE or float(np.abs(turned).max()) > _TOLERANCE


def _common_rise(poses: Sequence[tuple[Pose, Pose]], up: Array) -> float | None:
    """The distance that all bodies have risen; None if a body turned or moved in another direction."""
    moves = np.array([after.origin_m - before.origin_m for before, after in poses])
    turned = max(float(np.abs(after.rotation - before.rotation).max()) for before, after in poses)
    risen = float(moves[0] @ up)
    return risen if turned <= _TOLERANCE and float(np.abs(moves - risen * up).max()) <= _TOLERANCE else None
