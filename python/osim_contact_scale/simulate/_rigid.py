"""Copies a model as one rigid body that only moves up and down: the model with locked joints.

OpenSim locks a coordinate by a constraint, which is solved for in each step: with 30 of them a drop takes four times as long, and more
where the contacts are stiff. So the same bodies, spheres and forces are put into a model in which one body slides along the vertical,
and the others are welded to it in their pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ._contacts import Contact, base_frame, force_geometry, model_error, set_geometry_names
from ._poses import Array, Pose, angles_of_rotation, rotation_along

_NAME = "osim_contact_scale"


def rigid_copy(
    opensim: Any, model: Any, state: Any, moving: Sequence[Any], contacts: Sequence[Contact], up: Array
) -> Any:
    """A new model: `moving`, the bodies that move up and down, in the pose of a state, and these contact forces.

    Raises
    ------
    ModelError
        A force has contact geometry that is neither a sphere nor a half-space.
    """
    copy = opensim.Model()
    copy.set_gravity(model.get_gravity())
    bodies = {
        moving_body.getAbsolutePathString(): _copy_body(opensim, moving_body, f"body{number}")
        for number, moving_body in enumerate(moving)
    }
    carrier, start = _add_slider(opensim, copy, bodies, moving[0], state, up)
    for moving_body in moving[1:]:
        body, place = bodies[moving_body.getAbsolutePathString()], Pose.in_ground(moving_body, state).seen_from(start)
        copy.addBody(body)
        position, orientation = _vec3(opensim, place.origin_m), _vec3(opensim, angles_of_rotation(place.rotation))
        none = opensim.Vec3(0)
        copy.addJoint(opensim.WeldJoint(f"{_NAME}_{body.getName()}", carrier, position, orientation, body, none, none))
    names: dict[str, str] = {}
    for contact in contacts:
        paths = []
        for geometry in force_geometry(opensim, model, contact.force):
            path = geometry.getAbsolutePathString()
            paths.append(path)
            if path not in names:
                names[path] = f"geometry{len(names)}"
                copy.addContactGeometry(_copy_geometry(opensim, copy, geometry, names[path], bodies, state))
        clone = contact.force.clone()
        clone.thisown = False  # The model owns it.
        copy.updForceSet().adoptAndAppend(clone)
        set_geometry_names(opensim, clone, [names[path] for path in paths])
    return copy


def _copy_body(opensim: Any, body: Any, name: str) -> Any:
    return opensim.Body(name, body.getMass(), body.getMassCenter(), body.getInertia())


def _add_slider(opensim: Any, copy: Any, bodies: dict[str, Any], first: Any, state: Any, up: Array) -> tuple[Any, Pose]:
    """Adds the body that the others are welded to, and its joint along `up`."""
    body, start = bodies[first.getAbsolutePathString()], Pose.in_ground(first, state)
    track = Pose(start.origin_m, rotation_along(up))
    position, orientation = _vec3(opensim, track.origin_m), _vec3(opensim, angles_of_rotation(track.rotation))
    in_body = _vec3(opensim, angles_of_rotation(track.seen_from(start).rotation))
    copy.addBody(body)
    copy.addJoint(
        opensim.SliderJoint(f"{_NAME}_lift", copy.getGround(), position, orientation, body, opensim.Vec3(0), in_body)
    )
    return body, start


def _copy_geometry(opensim: Any, copy: Any, geometry: Any, name: str, bodies: dict[str, Any], state: Any) -> Any:
    """A copy of a sphere or half-space, on the copy of its body, or on ground if the body does not move."""
    body, place = bodies.get(base_frame(geometry).getAbsolutePathString()), Pose.of(geometry.getTransform())
    if body is None:
        body, place = copy.getGround(), Pose.in_ground(geometry.getFrame(), state).then(place)
    else:
        place = Pose.of(geometry.getFrame().findTransformInBaseFrame()).then(place)
    position, orientation = _vec3(opensim, place.origin_m), _vec3(opensim, angles_of_rotation(place.rotation))
    sphere = opensim.ContactSphere.safeDownCast(geometry)
    if sphere is not None:
        return opensim.ContactSphere(sphere.getRadius(), position, body, name)
    if opensim.ContactHalfSpace.safeDownCast(geometry) is None:
        raise model_error(
            f"{geometry.getName()} is a {geometry.getConcreteClassName()}: expected a sphere or a half-space"
        )
    return opensim.ContactHalfSpace(position, orientation, body, name)


def _vec3(opensim: Any, values: Array) -> Any:
    return opensim.Vec3(*map(float, values))
