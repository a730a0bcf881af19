"""Tables of a plan: what it changes, from the record that the command's JSON has."""

from __future__ import annotations

from typing import Any

from . import _native
from ._tables import table

#: Columns of a table of changes. `old` and `new` are in `unit`.
CHANGES = ("property", "path", "old", "new", "factor", "unit", "equation", "force", "sphere", "set", "line", "inserted")
#: Columns of a table of spheres that move: metres, in their frames.
MOVES = ("path", "sphere", "old_x", "old_y", "old_z", "new_x", "new_y", "new_z", "equation", "line", "inserted")
#: Columns of a table of whole objects.
OBJECTS = ("change", "class", "name", "path", "body", "location_m", "radius_m", "parameters")


def changes(record: dict[str, Any]) -> Any:
    """The numbers that change, a row each."""
    units = _native.units()
    numbers = [change for change in record["changes"] if change["property"] != "location"]
    rows = [
        {**change, "old": change["from"], "new": change["to"], "unit": units[change["property"]]} for change in numbers
    ]
    return table(rows, CHANGES)


def moves(record: dict[str, Any]) -> Any:
    """The spheres that move, a row each."""
    moved = [change for change in record["changes"] if change["property"] == "location"]
    axes = ("x", "y", "z")
    rows = [
        {
            **move,
            **{f"old_{axis}": value for axis, value in zip(axes, move["from"])},
            **{f"new_{axis}": value for axis, value in zip(axes, move["to"])},
        }
        for move in moved
    ]
    return table(rows, MOVES)


def objects(record: dict[str, Any]) -> Any:
    """The objects that are added or removed, a row each."""
    return table(record["objects"], OBJECTS)
