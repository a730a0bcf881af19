"""Whole objects into a live model, and out of it."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from ._errors import ContactScaleError

#: The sets that whole objects are removed from and added to, by their component paths.
_SETS = {"/forceset": "updForceSet", "/contactgeometryset": "updContactGeometrySet"}


def exchange(opensim: Any, model: Any, objects: list[dict[str, Any]], new: bytes) -> list[Callable[[], object]]:
    """What removes and adds whole objects, once it is called. Those that are added are clones of what OpenSim reads in `new`.

    Raises
    ------
    ContactScaleError
        It is another model, or one whose objects cannot be exchanged. Nothing was changed.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "model.osim")
        path.write_bytes(new)
        try:
            made = opensim.Model(str(path))
        except RuntimeError as error:
            message = f"OpenSim cannot read the new model by itself ({error}): write it to a file and load that"
            raise ContactScaleError("live-model", message) from error
    for change in objects:
        if not change["path"].startswith(tuple(f"{path}/" for path in _SETS)):
            raise _outside(change["path"])
    edits: list[Callable[[], object]] = []
    for folder_path, accessor in _SETS.items():
        live, wanted = getattr(model, accessor)(), getattr(made, accessor)()
        own = [change for change in objects if change["path"].startswith(folder_path + "/")]
        removed = [_name(change) for change in own if change["change"] == "removed"]
        added = [_name(change) for change in own if change["change"] == "added"]
        for name in removed:
            if live.getIndex(name) < 0:
                component(model, f"{folder_path}/{name}")
                raise _outside(f"{folder_path}/{name}")
        edits += [partial(_remove, live, name) for name in removed]
        # Cloned now: what is in a set does not keep its model alive.
        places = sorted(wanted.getIndex(name) for name in added)
        if own and _names(wanted) != _expected(_names(live), removed, places, _names(wanted)):
            reason = "because of what else is in it, or because of names that occur twice"
            message = f"{folder_path} would not be that of the new model, {reason}: write it to a file and load that"
            raise ContactScaleError("live-model", message)
        edits += [partial(_insert, live, place, wanted.get(place).clone()) for place in places]
    return edits


def _names(members: Any) -> list[str]:
    return [str(members.get(place).getName()) for place in range(members.getSize())]


def _expected(names: list[str], removed: list[str], places: list[int], wanted: list[str]) -> list[str]:
    """The names of a live set after an exchange."""
    left = [name for name in names if name not in removed]
    for place in places:
        left.insert(place, wanted[place] if place >= 0 else "")
    return left


def _name(change: dict[str, Any]) -> str:
    """The name of an object in its set: OpenSim's own, where the file gives it none."""
    path: str = change["path"]
    return path.rsplit("/", 1)[-1]


def _remove(live: Any, name: str) -> None:
    live.remove(live.getIndex(name))


def _insert(live: Any, place: int, clone: Any) -> None:
    # The set owns it from now on.
    clone.thisown = False
    live.insert(place, clone)


def component(model: Any, path: str) -> Any:
    """A component by its path.

    Raises
    ------
    ContactScaleError
        It is not there.
    """
    try:
        return model.getComponent(path)
    except Exception as error:
        message = f"{path} is not in this model: apply a change to the model that it was planned for"
        raise ContactScaleError("live-model", message) from error


def _outside(path: str) -> ContactScaleError:
    message = f"{path} is outside of the model's sets, where OpenSim removes nothing: write it to a file and load that"
    return ContactScaleError("live-model", message)
