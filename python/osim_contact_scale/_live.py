"""Live models: reads an `opensim.Model` in memory and applies changes to it.

opensim is imported only if the caller passes one of its models.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from typing import Any

from ._errors import ContactScaleError
from ._live_objects import exchange_objects, find_component
from ._live_print import model_to_xml


def is_model(source: Any) -> bool:
    """Whether the source is an `opensim.Model`."""
    opensim = sys.modules.get("opensim")
    return opensim is not None and isinstance(source, opensim.Model)


def to_bytes(model: Any) -> tuple[str | None, bytes]:
    """The file name of a live model, if it has one, and its present state as XML.

    Raises
    ------
    ContactScaleError
        OpenSim cannot print it.
    """
    import opensim

    name = str(model.getInputFileName())
    file = None if name in ("", "Unassigned") else name
    return file, model_to_xml(opensim, model, file)


def apply_record(record: dict[str, Any], masses: dict[str, float], new: bytes, model: Any) -> None:
    """Applies the changes of a plan, and the credits with its note, to a live model, which then equals the file `new`.

    `masses` are those of the bodies that the plan was made for, in kg by their component paths.

    Raises
    ------
    ContactScaleError
        This is another model than the plan is for, or it was changed since. Nothing was changed then.
    """
    if not is_model(model):
        raise TypeError(f"expected an opensim.Model, not {type(model).__name__}")
    import opensim

    for path, mass in masses.items():
        _check_mass(opensim, model, path, mass)
    # All places are looked up before anything changes. Objects that are added already have the new numbers.
    added = {change["path"] for change in record["objects"] if change["change"] == "added"}
    edits = [_setter_of(opensim, model, change) for change in record["changes"] if change["path"] not in added]
    if record["objects"]:
        edits += exchange_objects(opensim, model, record["objects"], new)
    for edit in edits:
        edit()
    credit = record["credits"]
    if credit is None and edits:
        # If a file has no credits, for example because its note was removed, OpenSim uses its default text.
        credit = opensim.Model().getCredits()
    if credit is not None:
        model.set_credits(credit)
    model.finalizeFromProperties()


def _setter_of(opensim: Any, model: Any, change: dict[str, Any]) -> Callable[[], object]:
    """A function that sets one property."""
    owner = find_component(model, change["path"])
    name, value = change["property"], change["to"]
    if name == "location":
        geometry = opensim.ContactGeometry.safeDownCast(owner)
        location = geometry.get_location()
        _check_unchanged(change, [location.get(axis) for axis in range(3)])
        vector = opensim.Vec3(*value)
        return lambda: geometry.set_location(vector)
    if name == "radii":
        ellipsoid = opensim.ContactEllipsoid.safeDownCast(owner)
        radii = ellipsoid.getRadii()
        _check_unchanged(change, [radii.get(axis) for axis in range(3)])
        new_radii = opensim.Vec3(*value)
        return lambda: ellipsoid.setRadii(new_radii)
    if change["set"] is not None:
        sets = owner.updPropertyByName("contact_parameters").updValueAsObject()
        owner = sets.updPropertyByName("objects").updValueAsObject(change["set"])
    if not owner.hasProperty(name):
        raise ContactScaleError("live-model", f"{change['path']} has no {name}: this is another model")
    prop = owner.updPropertyByName(name)
    _check_unchanged(change, [opensim.PropertyHelper.getValueDouble(prop)])
    return lambda: opensim.PropertyHelper.setValueDouble(value, prop)


def _check_mass(opensim: Any, model: Any, path: str, mass: float) -> None:
    """Raises an error if a body has another mass than in the plan, because the new contacts depend on it."""
    body = opensim.Body.safeDownCast(find_component(model, path))
    if body is None or math.isclose(body.getMass(), mass, rel_tol=1e-9):
        return
    message = f"the mass of {path} is {body.getMass()} kg, not {mass} kg as it was when this change was planned"
    raise ContactScaleError("live-model", f"{message}: plan it again for the model as it is now")


def _check_unchanged(change: dict[str, Any], current: list[float]) -> None:
    """Raises an error unless a property has the value before the change or the value after it."""
    for state in ("from", "to"):
        planned = change[state] if isinstance(change[state], (list, tuple)) else [change[state]]
        # OpenSim prints a live model with fewer digits than its numbers have.
        if all(value is None or math.isclose(value, actual, rel_tol=1e-9) for value, actual in zip(planned, current)):
            return
    current_text = " ".join(map(str, current))
    message = f"{change['property']} of {change['path']} is {current_text}, not {change['from']} as it was when this change was planned"
    raise ContactScaleError("live-model", f"{message}: plan it again for the model as it is now")
