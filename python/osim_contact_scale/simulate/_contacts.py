"""The contact forces of an `opensim.Model`, and the spheres that they press on half-spaces."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import Any

from .._errors import ModelError

SMOOTH = "SmoothSphereHalfSpaceForce"
HUNT_CROSSLEY = "HuntCrossleyForce"
_SOCKETS = ("sphere", "half_space")


@dataclass(frozen=True)
class Contact:
    """A contact force that applies, and the spheres and half-spaces that it acts between."""

    force: Any
    spheres: tuple[Any, ...]
    floors: tuple[Any, ...]
    places: tuple[int, ...]
    """Indices in its record of the forces on the bodies of its spheres, each body once."""

    def force_n(self, state: Any, up: Sequence[float]) -> float:
        """The force on the bodies of its spheres, along a direction, in N. The state must be realized to dynamics."""
        values = self.force.getRecordValues(state)
        return float(sum(values.get(place + axis) * up[axis] for place in self.places for axis in range(3)))


def selected_contacts(opensim: Any, model: Any, select: Sequence[str]) -> list[Contact]:
    """The contact forces that apply and whose names fit one of the patterns; without patterns, all that apply.

    Raises
    ------
    ModelError
        There is no such force, or one of the spheres has no radius.
    """
    contacts = [contact for force in _contact_forces(opensim, model) if (contact := _to_contact(opensim, model, force))]
    if not contacts:
        expected = f"a {HUNT_CROSSLEY} or {SMOOTH} in which a ContactSphere meets a ContactHalfSpace"
        raise model_error(f"there is nothing that the body can stand on: expected {expected}")
    names = ", ".join(str(one.force.getName()) for one in contacts)
    if select:
        contacts = [one for one in contacts if any(fnmatchcase(one.force.getName(), pattern) for pattern in select)]
        if not contacts:
            raise model_error(f"select fits no contact force: {', '.join(select)}; there are {names}")
    contacts = [one for one in contacts if one.force.get_appliesForce()]
    if not contacts:
        raise model_error(f"the contact forces are switched off (appliesForce is false): {names}")
    # OpenSim would never finish the system of a model with such a sphere.
    for sphere in (sphere for contact in contacts for sphere in contact.spheres):
        if not 0 < sphere.getRadius() < math.inf:
            raise model_error(f"the sphere {sphere.getName()} has a radius of {sphere.getRadius():g} m")
    return contacts


def forces_without_constant(contacts: Sequence[Contact]) -> list[str]:
    """Names of smooth forces with a constant_contact_force of 0: their value is NaN while a sphere does not slip."""
    smooth = [one.force for one in contacts if one.force.getConcreteClassName() == SMOOTH]
    return [str(force.getName()) for force in smooth if force.get_constant_contact_force() == 0]


def base_frame(geometry: Any) -> Any:
    """The body, or ground, that carries a contact geometry."""
    return geometry.getFrame().findBaseFrame()


def model_error(message: str) -> ModelError:
    """An error about the model; `model_errors` adds the name of its file."""
    return ModelError("simulation", message)


def force_geometry(opensim: Any, model: Any, force: Any) -> list[Any]:
    """The contact geometry of a force, in the order of its record."""
    if force.getConcreteClassName() == SMOOTH:
        return [opensim.ContactGeometry.safeDownCast(force.getConnectee(socket)) for socket in _SOCKETS]
    geometries = [
        _find_geometry(opensim, model, opensim.PropertyHelper.getValueString(*place))
        for place in _geometry_names(force)
    ]
    return [one for one in geometries if one is not None]


def set_geometry_names(opensim: Any, force: Any, names: Sequence[str]) -> None:
    """Makes a force that is not yet connected use the contact geometry with these names."""
    if force.getConcreteClassName() == SMOOTH:
        for socket, name in zip(_SOCKETS, names):
            force.updSocket(socket).setConnecteePath(f"/contactgeometryset/{name}")
        return
    for (prop, number), name in zip(_geometry_names(force), names):
        opensim.PropertyHelper.setValueString(name, prop, number)


def _geometry_names(force: Any) -> Iterator[tuple[Any, int]]:
    """The places of the geometry's names in all materials of a HuntCrossleyForce: the property, and an index in it."""
    materials = force.updPropertyByName("contact_parameters").updValueAsObject().updPropertyByName("objects")
    for place in range(materials.size()):
        names = materials.updValueAsObject(place).updPropertyByName("geometry")
        for number in range(names.size()):
            yield names, number


def _contact_forces(opensim: Any, model: Any) -> Iterator[Any]:
    kinds = {SMOOTH: opensim.SmoothSphereHalfSpaceForce, HUNT_CROSSLEY: opensim.HuntCrossleyForce}
    for component in list(model.getComponentsList()):
        kind = kinds.get(component.getConcreteClassName())
        if kind is not None:
            yield kind.safeDownCast(component)


def _to_contact(opensim: Any, model: Any, force: Any) -> Contact | None:
    """A force between spheres and half-spaces as a `Contact`; None if it acts between other shapes."""
    geometry = force_geometry(opensim, model, force)
    spheres = [one for one in map(opensim.ContactSphere.safeDownCast, geometry) if one is not None]
    floors = [one for one in map(opensim.ContactHalfSpace.safeDownCast, geometry) if one is not None]
    if not spheres or not floors:
        return None
    return Contact(force, tuple(spheres), tuple(floors), tuple(_record_places(geometry, spheres)))


def _find_geometry(opensim: Any, model: Any, name: str) -> Any:
    """The geometry that OpenSim finds by a name: a path in the model, or a name in its set of geometry."""
    for path in (name, f"contactgeometryset/{name}"):
        try:
            component = opensim.ContactGeometry.safeDownCast(model.getComponent(path))
        except RuntimeError:
            continue
        if component is not None:
            return component
    return None


def _record_places(geometry: Sequence[Any], spheres: Sequence[Any]) -> Iterator[int]:
    """Indices of the forces in a record. Each geometry has six values, the force and the torque on its body, so that a body with
    two spheres has equal values twice."""
    sphere_paths = {sphere.getAbsolutePathString() for sphere in spheres}
    body_paths = set()
    for number, one in enumerate(geometry):
        body = base_frame(one).getAbsolutePathString()
        if one.getAbsolutePathString() in sphere_paths and body not in body_paths:
            body_paths.add(body)
            yield 6 * number
