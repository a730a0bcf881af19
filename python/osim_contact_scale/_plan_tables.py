"""Tables of the changes of a plan, made from its record in the command's JSON."""

from __future__ import annotations

from typing import Any

from . import _native
from ._tables import table
from .types import Table

#: Columns of a table of changes. `old` and `new` are in `unit`.
CHANGES = ("property", "path", "old", "new", "factor", "unit", "equation", "force", "sphere", "set", "line", "inserted")
#: Columns of a table in which equal changes are one row: `of` is the number of equal changes.
GROUPED = ("property", "of", "old", "new", "factor", "unit", "equation")
#: Columns of a table of spheres that move: metres, in their frames.
MOVES = ("path", "sphere", "old_x", "old_y", "old_z", "new_x", "new_y", "new_z", "equation", "line", "inserted")
#: Columns of a table of whole objects.
OBJECTS = ("change", "class", "name", "path", "body", "location_m", "radius_m", "parameters")


def table_of_changes(record: dict[str, Any]) -> Table:
    """A row for each number that changes."""
    return table(_change_rows(record), CHANGES)


def _change_rows(record: dict[str, Any]) -> list[dict[str, Any]]:
    units = _native.units()
    rows = []
    for change in record["changes"]:
        name, old, new = change["property"], change["from"], change["to"]
        if name == "radii":
            axes = zip("xyz", old, new, strict=True)
            rows += [{**change, "property": f"radii_{axis}", "old": a, "new": b, "unit": "m"} for axis, a, b in axes]
        elif name != "location":
            rows.append({**change, "old": old, "new": new, "unit": units[name]})
    return rows


def grouped_changes(record: dict[str, Any]) -> list[dict[str, Any]]:
    """A row for each property and change of its value, however many numbers it concerns."""
    groups: dict[tuple[Any, ...], dict[str, Any]] = {}
    for row in _change_rows(record):
        group = groups.setdefault(tuple(row[name] for name in ("property", "old", "new")), {**row, "of": 0})
        group["of"] += 1
    return list(groups.values())


def table_of_moves(record: dict[str, Any]) -> Table:
    """A row for each sphere that moves."""
    return table(move_rows(record), MOVES)


def move_rows(record: dict[str, Any]) -> list[dict[str, Any]]:
    """A dictionary for each sphere that moves."""
    moved = [change for change in record["changes"] if change["property"] == "location"]
    axes = ("x", "y", "z")
    return [
        {
            **move,
            **{f"old_{axis}": value for axis, value in zip(axes, move["from"])},
            **{f"new_{axis}": value for axis, value in zip(axes, move["to"])},
        }
        for move in moved
    ]


def table_of_objects(record: dict[str, Any]) -> Table:
    """A row for each object that is added or removed."""
    return table(record["objects"], OBJECTS)
