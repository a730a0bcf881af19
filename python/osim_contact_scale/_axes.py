"""Draws figures on axes of matplotlib, from the numbers of each panel."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from . import _native
from ._text import printable

Row = dict[str, Any]

#: Dashes of the curves, one after the other: colours alone do not distinguish enough curves.
_DASHES = ("-", "--", "-.", ":")
#: The look of curves without a name, which are the background of others.
_UNNAMED_LOOK = {"color": "0.6", "linewidth": 0.6}
_THIN_LOOK = {"color": "0.5", "linestyle": "--", "linewidth": 0.8}


class Panel(NamedTuple):
    """A panel of a figure: its name, its numbers and its look."""

    name: str
    rows: list[Row]
    look: _native.PanelLook


def group_panels(rows: Sequence[Row], looks: Sequence[_native.PanelLook]) -> list[Panel]:
    """The panels of a figure, in their order."""
    groups = [
        (name, list(panel_rows)) for name, panel_rows in itertools.groupby(rows, key=lambda row: str(row["panel"]))
    ]
    return [Panel(name, panel_rows, look) for (name, panel_rows), look in zip(groups, looks)]


def draw_panel(panel: Panel, axes: Any) -> None:
    """Draws a panel on axes of matplotlib."""
    (x_log, x_limits), (y_log, y_limits), is_inverted, lengths = panel.look
    if x_log:
        axes.set_xscale("log")
    if y_log:
        axes.set_yscale("log")
    rows_by_kind = _group_by_kind(panel.rows)
    _draw_heat_map(axes, rows_by_kind, (x_log, y_log))
    _draw_outlines(axes, rows_by_kind.get("outline", ()))
    _draw_curves(axes, rows_by_kind.get("curve", ()), lengths)
    _draw_spheres(axes, rows_by_kind.get("sphere", ()))
    _draw_points(axes, rows_by_kind.get("point", ()), with_text="sphere" in rows_by_kind or "outline" in rows_by_kind)
    for row in (*rows_by_kind.get("limit", ()), *rows_by_kind.get("level", ())):
        _draw_line(axes, row)
    _label_axes(panel, axes)
    if x_limits is not None:
        axes.set_xlim(*x_limits)
    if y_limits is not None:
        axes.set_ylim(*y_limits)
    if is_inverted:
        axes.yaxis.set_inverted(True)


def _group_by_kind(rows: Sequence[Row]) -> dict[str, list[Row]]:
    kinds: dict[str, list[Row]] = {}
    for row in rows:
        kinds.setdefault(row["kind"], []).append(row)
    return kinds


def _label_axes(panel: Panel, axes: Any) -> None:
    """Title, labels with units, and the legend."""
    axes.set_title(_escaped(panel.name))
    axes.set_xlabel(_escaped(panel.rows[0]["x_axis"]))
    axes.set_ylabel(_escaped(panel.rows[0]["y_axis"]))
    handles, labels = axes.get_legend_handles_labels()
    # Curves of one name have one entry.
    entries = dict(zip(reversed(labels), reversed(handles)))
    if entries:
        names = list(dict.fromkeys(labels))
        axes.legend([entries[name] for name in names], names)


def _escaped(text: str) -> str:
    """A name for matplotlib: a dollar does not begin a formula, and an underscore at the start does not hide it from the legend."""
    text = printable(text).replace("$", r"\$")
    return f" {text}" if text.startswith("_") else text


def _draw_curves(axes: Any, rows: Sequence[Row], lengths: Sequence[int]) -> None:
    """Draws the curves. Curves of one name have one look."""
    looks: dict[str, dict[str, Any]] = {"": _UNNAMED_LOOK}
    for curve in _split_curves(rows, lengths):
        name = curve[0]["name"]
        if name not in looks:
            number = len(looks) - 1
            looks[name] = {"color": f"C{number % 10}", "linestyle": _DASHES[number % 4], "label": _escaped(name)}
        axes.plot(*_xs_and_ys(curve), **looks[name])


def _split_curves(rows: Sequence[Row], lengths: Sequence[int]) -> Iterator[Sequence[Row]]:
    """The rows of each curve."""
    begin = 0
    for length in lengths:
        if length:
            yield rows[begin : begin + length]
        begin += length


def _xs_and_ys(rows: Sequence[Row]) -> tuple[list[float], list[float]]:
    return [row["x"] for row in rows], [row["y"] for row in rows]


def _draw_points(axes: Any, rows: Sequence[Row], with_text: bool) -> None:
    """Draws points with their names: in the legend, or beside each point."""
    for name, point_rows in itertools.groupby(rows, key=lambda row: str(row["name"])):
        places = _xs_and_ys(list(point_rows))
        if with_text:
            axes.plot(*places, "D", color="0.3", markersize=4)
            axes.annotate(_escaped(name), (places[0][0], places[1][0]), fontsize="x-small")
        else:
            axes.plot(*places, "o", color="black", label=_escaped(name), zorder=3)


def _draw_line(axes: Any, row: Row) -> None:
    """Draws a limit or a level as a line across the panel. A limit of a heat map has no place; `_draw_heat_map` draws it."""
    if row["x"] is not None:
        axes.axvline(row["x"], **_THIN_LOOK, label=_escaped(row["name"]))
    elif row["y"] is not None:
        axes.axhline(row["y"], **_THIN_LOOK, label=_escaped(row["name"]))


def _draw_outlines(axes: Any, rows: Sequence[Row]) -> None:
    """Draws the shapes of bones."""
    for _, corners in itertools.groupby(rows, key=lambda row: str(row["name"])):
        axes.fill(*_xs_and_ys(list(corners)), facecolor="0.7", edgecolor="0.4", alpha=0.3)


def _draw_spheres(axes: Any, rows: Sequence[Row]) -> None:
    """Draws spheres as circles of their true size, with their names."""
    if not rows:
        return
    from matplotlib.patches import Circle

    for row in rows:
        # A sphere without a name is the state before the change.
        dash = "-" if row["name"] else "--"
        axes.add_patch(Circle((row["x"], row["y"]), row["value"], fill=False, edgecolor="C0", linestyle=dash))
        if row["name"]:
            axes.annotate(_escaped(row["name"]), (row["x"], row["y"]), fontsize="x-small", ha="center", va="center")
    axes.set_aspect("equal", adjustable="datalim")
    axes.autoscale_view()


def _draw_heat_map(axes: Any, rows_by_kind: dict[str, list[Row]], logarithmic: tuple[bool, bool]) -> None:
    """Draws a heat map with its colour bar; cells without a value stay empty."""
    rows = rows_by_kind.get("cell")
    if not rows:
        return
    x, y = (sorted({row[name] for row in rows}) for name in ("x", "y"))
    values_by_place = {(row["x"], row["y"]): row["value"] for row in rows}
    values = [[math.nan if values_by_place.get((a, b)) is None else values_by_place[a, b] for a in x] for b in y]
    mesh = axes.pcolormesh(_cell_edges(x, logarithmic[0]), _cell_edges(y, logarithmic[1]), values)
    bar = axes.figure.colorbar(mesh, ax=axes, label=_escaped(rows[0]["value_name"]))
    for row in rows_by_kind.get("limit", ()):
        # The limit is a line at this value, in the map and on the bar.
        axes.contour(x, y, values, levels=[row["value"]], colors="white", linestyles="--")
        bar.ax.axhline(row["value"], color="white", linestyle="--")
        axes.plot([], [], **_THIN_LOOK, label=_escaped(row["name"]))


def _cell_edges(middles: Sequence[float], is_logarithmic: bool) -> list[float]:
    """The edges of cells: halfway between two middles, and as far beyond the first and the last."""
    places = [math.log(value) for value in middles] if is_logarithmic else list(middles)
    between = [(low + high) / 2 for low, high in itertools.pairwise(places)]
    edges = [2 * places[0] - between[0], *between, 2 * places[-1] - between[-1]]
    return [math.exp(edge) for edge in edges] if is_logarithmic else edges
