"""Writes a live model as XML that means the same in every other process.

OpenSim marks each property that no file and no call has set, and leaves it out of what it prints. Its value is the default that was
registered for its class at that time. OpenSim takes registered defaults from the `<defaults>` of every file that it reads, and keeps them
until the process ends, so that another program may have another value.
"""

from __future__ import annotations

import contextlib
import functools
import os
import tempfile
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ._errors import ContactScaleError

#: Classes whose properties are always printed, including their parts, such as `HuntCrossleyForce::ContactParameters`.
CONTACTS = frozenset(
    {
        "ContactCylinder",
        "ContactEllipsoid",
        "ContactHalfSpace",
        "ContactMesh",
        "ContactSphere",
        "ContactTorus",
        "ElasticFoundationForce",
        "HuntCrossleyForce",
        "SmoothSphereHalfSpaceForce",
    }
)

#: Settings of the whole process change what OpenSim prints: only one thread prints at a time.
_PRINTING_LOCK = threading.Lock()


def model_to_xml(opensim: Any, model: Any, file: str | None = None) -> bytes:
    """A model as XML: all values of contacts, and all other values that differ from the defaults in OpenSim's code. `file` is for messages.

    A clone is printed, so that the marks of the model stay as they are. It has no `<defaults>`, which would count for models that are
    read later, and holds all objects itself, also those that the model has from other files.

    Raises
    ------
    ContactScaleError
        OpenSim cannot print it.
    """
    with _PRINTING_LOCK, _printing_settings(opensim), tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "model.osim")
        try:
            # OpenSim refuses a model whose connections are not finalized. A clone of it would be printed, without them.
            is_printed = model.printToXML(path)
            clone = connected_clone(model)
            _unmark_defaults(opensim, clone)
            is_printed = is_printed and clone.printToXML(path)
        except RuntimeError as error:
            # More lines name each place.
            reason = str(error).partition("\n")[0]
            raise ContactScaleError("unreadable", f"opensim could not print this model: {reason}", path=file) from error
        if not is_printed:
            raise ContactScaleError("unreadable", "opensim could not print this model", path=file)
        return Path(path).read_bytes()


def connected_clone(model: Any) -> Any:
    """A clone of a model, connected where it has controllers.

    Those of files before version 40600 keep the names of their actuators aside until then, and would be printed without them.
    """
    clone = model.clone()
    if not clone.getControllerSet().getSize():
        return clone
    try:
        clone.finalizeFromProperties()
        clone.finalizeConnections()
    except RuntimeError:
        # Something is missing in the model, which OpenSim prints all the same.
        return model.clone()
    return clone


@contextlib.contextmanager
def _printing_settings(opensim: Any) -> Iterator[None]:
    """Changes OpenSim's settings while a model is printed.

    It leaves out defaults: it refuses to read some of those that it prints, such as a muscle's `optimal_force`. And it does not write the
    other files that a model has objects from.
    """
    defaults, offline = opensim.OpenSimObject.getSerializeAllDefaults(), opensim.IO.GetPrintOfflineDocuments()
    opensim.OpenSimObject.setSerializeAllDefaults(False)
    opensim.IO.SetPrintOfflineDocuments(False)
    try:
        yield
    finally:
        opensim.OpenSimObject.setSerializeAllDefaults(defaults)
        opensim.IO.SetPrintOfflineDocuments(offline)


def _unmark_defaults(opensim: Any, owner: Any) -> None:
    """Removes the mark "is default" from all properties of an object that have to be printed."""
    name = owner.getConcreteClassName()
    defaults = None if name.split("::")[0] in CONTACTS else _default_values(opensim, name)
    for index in range(owner.getNumProperties()):
        # `updPropertyByIndex` would mark the object as changed.
        prop = owner.getPropertyByIndex(index)
        if prop.getValueIsDefault():
            # The program adds its note to the credits: without a text in the file, the note would replace it.
            if prop.getName() != "credits" and defaults is not None and _comparable(opensim, prop) == defaults[index]:
                continue
            prop.setValueIsDefault(False)
        if prop.isObjectProperty():
            for place in range(prop.size()):
                _unmark_defaults(opensim, prop.getValueAsObject(place))


@functools.cache
def _default_values(opensim: Any, name: str) -> list[object] | None:
    """The values of a new object of a class. None for classes that Python cannot create."""
    try:
        return _property_values(opensim, getattr(opensim, name)())
    except Exception:
        return None


def _property_values(opensim: Any, owner: Any) -> list[object]:
    return [_comparable(opensim, owner.getPropertyByIndex(index)) for index in range(owner.getNumProperties())]


def _comparable(opensim: Any, prop: Any) -> object:
    """The value of a property in a form that can be compared, with all digits. NaN equals NaN; a value of a rare type equals none."""
    places = range(prop.size())
    if prop.isObjectProperty():
        objects = [prop.getValueAsObject(place) for place in places]
        return [(one.getConcreteClassName(), _property_values(opensim, one)) for one in objects]
    kind = prop.getTypeName()
    if kind in ("bool", "int", "string"):
        return prop.toString()
    if kind == "double":
        return repr([opensim.PropertyHelper.getValueDouble(prop, place) for place in places])
    if kind in ("Vec3", "Vec6") and len(places) == 1:
        getter = getattr(opensim.PropertyHelper, f"getValue{kind}")
        return repr([getter(prop, axis) for axis in range(int(kind[-1]))])
    return object()
