"""Adds whole objects to a live model and removes them from it."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from ._errors import ContactScaleError

#: The sets whose objects can be removed and added, by their component paths.
_SETS = {"/forceset": "updForceSet", "/contactgeometryset": "updContactGeometrySet"}


def exchange_objects(opensim: Any, model: Any, objects: list[dict[str, Any]], new: bytes) -> list[Callable[[], object]]:
    """Functions that remove and add whole objects. New objects are clones of those that OpenSim reads in `new`.

    Raises
    ------
    ContactScaleError
        This is another model than the plan is for, or its objects cannot be exchanged. Nothing was changed.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "model.osim")
        path.write_bytes(new)
        try:
            new_model = opensim.Model(str(path))
        except RuntimeError as error:
            message = f"OpenSim cannot read the new model by itself ({error}): write it to a file and load that"
            raise ContactScaleError("live-model", message) from error
    for change in objects:
        if not change["path"].startswith(tuple(f"{path}/" for path in _SETS)):
            raise _outside_sets_error(change["path"])
    edits: list[Callable[[], object]] = []
    for folder_path, accessor in _SETS.items():
        live_set, new_set = getattr(model, accessor)(), getattr(new_model, accessor)()
        set_changes = [change for change in objects if change["path"].startswith(folder_path + "/")]
        removed = [_object_name(change) for change in set_changes if change["change"] == "removed"]
        added = [_object_name(change) for change in set_changes if change["change"] == "added"]
        for name in removed:
            if live_set.getIndex(name) < 0:
                find_component(model, f"{folder_path}/{name}")
                raise _outside_sets_error(f"{folder_path}/{name}")
        edits += [partial(_remove, live_set, name) for name in removed]
        # Objects are cloned now, because a member of a set does not keep its model alive.
        places = sorted(new_set.getIndex(name) for name in added)
        if set_changes and _names(new_set) != _names_after_exchange(_names(live_set), removed, places, _names(new_set)):
            reason = "because of what else is in it, or because of names that occur twice"
            message = f"{folder_path} would not be that of the new model, {reason}: write it to a file and load that"
            raise ContactScaleError("live-model", message)
        edits += [partial(_insert, live_set, place, new_set.get(place).clone()) for place in places]
    return edits


def _names(members: Any) -> list[str]:
    return [str(members.get(place).getName()) for place in range(members.getSize())]


def _names_after_exchange(names: list[str], removed: list[str], places: list[int], new_names: list[str]) -> list[str]:
    """The names of a live set after an exchange."""
    remaining = [name for name in names if name not in removed]
    for place in places:
        remaining.insert(place, new_names[place] if place >= 0 else "")
    return remaining


def _object_name(change: dict[str, Any]) -> str:
    """The name of an object in its set. OpenSim generates it if the file has none."""
    path: str = change["path"]
    return path.rsplit("/", 1)[-1]


def _remove(live_set: Any, name: str) -> None:
    live_set.remove(live_set.getIndex(name))


def _insert(live_set: Any, place: int, clone: Any) -> None:
    # The set owns it from now on.
    clone.thisown = False
    live_set.insert(place, clone)


def find_component(model: Any, path: str) -> Any:
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


def _outside_sets_error(path: str) -> ContactScaleError:
    message = f"{path} is outside of the model's sets, where OpenSim removes nothing: write it to a file and load that"
    return ContactScaleError("live-model", message)
