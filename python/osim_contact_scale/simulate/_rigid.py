"""A body that moves up and down only: a model with its joints locked.

OpenSim locks a coordinate by a constraint, which is solved for in each step: with 30 of them a drop takes four times as long, and more
where the contacts are stiff. So the same bodies, spheres and forces are put into a model in which one body slides along the vertical,
and the others are welded to it in their pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ._contacts import Contact, base_of, geometry_of, name_geometry, refusal
from ._placed import Array, Pose, along, angles

_NAME = "osim_contact_scale"


def rigid(opensim: Any, model: Any, state: Any, moving: Sequence[Any], contacts: Sequence[Contact], up: Array) -> Any:
    """A new model: `moving`, the bodies that move up and down, in the pose of a state, and these contact forces.

    Raises
    ------
    ModelError
        A force has contact geometry that is neither a sphere nor a half-space.
    """
    made = opensim.Model()
    made.set_gravity(model.get_gravity())
    bodies = {one.getAbsolutePathString(): _copy(opensim, one, f"body{number}") for number, one in enumerate(moving)}
    carrier, start = _slide(opensim, made, bodies, moving[0], state, up)
    for one in moving[1:]:
        body, place = bodies[one.getAbsolutePathString()], Pose.in_ground(one, state).seen_from(start)
        made.addBody(body)
        at, turned = _vec3(opensim, place.origin_m), _vec3(opensim, angles(place.rotation))
        none = opensim.Vec3(0)
        made.addJoint(opensim.WeldJoint(f"{_NAME}_{body.getName()}", carrier, at, turned, body, none, none))
    names: dict[str, str] = {}
    for contact in contacts:
        paths = []
        for geometry in geometry_of(opensim, model, contact.force):
            path = geometry.getAbsolutePathString()
            paths.append(path)
            if path not in names:
                names[path] = f"geometry{len(names)}"
                made.addContactGeometry(_geometry(opensim, made, geometry, names[path], bodies, state))
        clone = contact.force.clone()
        clone.thisown = False  # The model owns it.
        made.updForceSet().adoptAndAppend(clone)
        name_geometry(opensim, clone, [names[path] for path in paths])
    return made


def _copy(opensim: Any, body: Any, name: str) -> Any:
    return opensim.Body(name, body.getMass(), body.getMassCenter(), body.getInertia())


def _slide(opensim: Any, made: Any, bodies: dict[str, Any], one: Any, state: Any, up: Array) -> tuple[Any, Pose]:
    """Adds the body that the others are welded to, and its joint along `up`."""
    body, start = bodies[one.getAbsolutePathString()], Pose.in_ground(one, state)
    track = Pose(start.origin_m, along(up))
    at, turned = _vec3(opensim, track.origin_m), _vec3(opensim, angles(track.rotation))
    in_body = _vec3(opensim, angles(track.seen_from(start).rotation))
    made.addBody(body)
    made.addJoint(opensim.SliderJoint(f"{_NAME}_lift", made.getGround(), at, turned, body, opensim.Vec3(0), in_body))
    return body, start


def _geometry(opensim: Any, made: Any, geometry: Any, name: str, bodies: dict[str, Any], state: Any) -> Any:
    """The same sphere or half-space on a copy of its body, or on ground where that does not move."""
    body, place = bodies.get(base_of(geometry).getAbsolutePathString()), Pose.of(geometry.getTransform())
    if body is None:
        body, place = made.getGround(), Pose.in_ground(geometry.getFrame(), state).then(place)
    else:
        place = Pose.of(geometry.getFrame().findTransformInBaseFrame()).then(place)
    at, turned = _vec3(opensim, place.origin_m), _vec3(opensim, angles(place.rotation))
    sphere = opensim.ContactSphere.safeDownCast(geometry)
    if sphere is not None:
        return opensim.ContactSphere(sphere.getRadius(), at, body, name)
    if opensim.ContactHalfSpace.safeDownCast(geometry) is None:
        raise refusal(f"{geometry.getName()} is a {geometry.getConcreteClassName()}: expected a sphere or a half-space")
    return opensim.ContactHalfSpace(at, turned, body, name)


def _vec3(opensim: Any, values: Array) -> Any:
    return opensim.Vec3(*map(float, values))
