"""Figures that notebooks display, that matplotlib draws, and that are saved to files."""

from __future__ import annotations

import html
import os
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, overload

from . import _native
from ._errors import RequestError
from ._frames import require_package, to_frame
from ._keywords import expand_home
from ._named_values import NamedValues, clipped, repr_line
from ._text import printable
from .types import Table

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from ._axes import Panel

#: Inches of one panel of a figure that `plot` makes.
_PANEL_INCHES = (5.0, 3.6)


class _RenderedFigure(NamedTuple):
    """A figure that came from another process or from a pickle: it has been drawn already, in all formats."""

    svg: str
    remarks: str
    csv: str
    as_pdf: bytes
    as_png: bytes
    panels: list[_native.PanelLook]

    def pdf(self) -> bytes:
        return self.as_pdf

    def png(self) -> bytes:
        return self.as_png


class Figure(NamedValues):
    """A figure; in a notebook the picture itself.

    Attributes
    ----------
    svg : str
        The figure as an SVG document.
    remarks : str
        Remarks about the figure, such as the masses that were used.
    """

    __slots__ = ("_native",)

    def __init__(self, native: _native.Figure | _RenderedFigure) -> None:
        self._native = native

    @property
    def svg(self) -> str:
        return self._native.svg

    @property
    def remarks(self) -> str:
        return self._native.remarks

    @property
    def data(self) -> Table:
        """The numbers that are drawn, as a table: a DataFrame where pandas is there, else a list of dictionaries."""
        from ._tables import table

        return table(*self._rows())

    def _rows(self) -> tuple[list[dict[str, Any]], list[str]]:
        """The rows of `data`, and its columns."""
        import csv
        import io

        from ._cells import from_cell

        numbers = ("x", "y", "value")
        reader = csv.DictReader(io.StringIO(self._native.csv, newline=""))
        rows: list[dict[str, Any]] = []
        for row in reader:
            texts = {name: from_cell(text) for name, text in row.items()}
            rows.append(texts | {name: float(row[name]) if row[name] else None for name in numbers})
        return rows, list(reader.fieldnames or ())

    @property
    def panels(self) -> tuple[str, ...]:
        """The names of its panels, in order; one without a name is called ""."""
        return tuple(panel.name for panel in self._panels())

    def _panels(self) -> list[Panel]:
        from ._axes import group_panels

        return group_panels(self._rows()[0], self._native.panels)

    def frame(self) -> pd.DataFrame:
        """The numbers that are drawn, always as a DataFrame. Units are in `x_axis`, `y_axis` and `value_name`.

        Examples
        --------
        >>> ocs.plot("drop", "falisse2022").frame().query("kind == 'curve'")[["x", "y"]]
        """
        return to_frame(lambda: self.data)

    @overload
    def plot(self, ax: Axes, *, panel: str | None = None) -> Axes: ...

    @overload
    def plot(self, ax: None = None, *, panel: str) -> Axes: ...

    @overload
    def plot(self, ax: Sequence[Axes] | NDArray[np.object_], *, panel: None = None) -> Axes | NDArray[np.object_]: ...

    # One of the axes or an array of them: only the figure knows.
    @overload
    def plot(self, ax: None = None, *, panel: None = None) -> Any: ...

    def plot(self, ax: Axes | Sequence[Axes] | NDArray[np.object_] | None = None, *, panel: str | None = None) -> Any:
        """Draws the figure with matplotlib, so that you can change it like every plot of matplotlib.

        Curves, points, limits, heat maps, spheres and bones are drawn, with the labels, units and names of the picture. The shade below
        a curve and remarks are in the picture alone, and colours are those of your style.

        Parameters
        ----------
        ax : matplotlib Axes, or several of them, optional
            The axes to draw on, one for each panel. By default new axes are made.
        panel : str, optional
            Draw only this panel: its name as in `panels`, or the letter that it begins with.

        Returns
        -------
        matplotlib.axes.Axes or numpy.ndarray of them
            The axes of one panel; an array with one for each of several panels.

        Raises
        ------
        RequestError
            There is no such panel, or the number of axes is not the number of panels.
        ContactScaleError
            matplotlib is not installed.

        Examples
        --------
        >>> axes = ocs.plot("force", "falisse2022").plot()
        >>> axes.set_title("My contact")
        >>> left = ocs.plot("fig4").plot(panel="A")
        """
        require_package("matplotlib", "plot", "plot()")
        import numpy as np

        from ._axes import draw_panel

        panels = self._panels()
        chosen = panels if panel is None else [_find_panel(panels, panel)]
        targets = self._create_axes(len(chosen)) if ax is None else list(np.ravel(np.asarray(ax, dtype=object)))
        if len(targets) != len(chosen):
            names = ", ".join(repr(printable(one.name)) for one in panels)
            message = f"{len(targets)} axes for {len(chosen)} panels: give one for each, or choose one panel of {names}"
            raise RequestError("usage", message, keywords=("ax", "panel"))
        for one, axes in zip(chosen, targets):
            draw_panel(one, axes)
        return targets[0] if len(targets) == 1 else np.array(targets, dtype=object)

    def _create_axes(self, count: int) -> Sequence[Any]:
        """Creates axes in one column, or in two columns if there are many."""
        from matplotlib import pyplot

        columns = 1 if count < 4 else 2
        lines = -(-count // columns)
        size = (_PANEL_INCHES[0] * columns, _PANEL_INCHES[1] * lines)
        figure, axes = pyplot.subplots(lines, columns, figsize=size, squeeze=False, layout="constrained")
        for spare in axes.flat[count:]:
            figure.delaxes(spare)
        return list(axes.flat[:count])

    def to_pdf(self) -> bytes:
        """The figure as a PDF document, with its fonts."""
        return bytes(self._native.pdf())

    def to_png(self) -> bytes:
        """The figure as a PNG picture with `dpi` pixels to the inch."""
        return bytes(self._native.png())

    def save(self, output: str | os.PathLike[str], *, force: bool = False) -> Path:
        """Writes the figure to a file that ends in .svg, .pdf or .png, or its numbers to one that ends in .csv.

        Raises
        ------
        RequestError
            The name ends in something else.
        OutputError
            The file exists already and `force` is not given.
        """
        path = Path(expand_home(output))
        makers: dict[str, Callable[[], bytes]] = {
            ".svg": lambda: self.svg.encode("utf-8"),
            ".pdf": self.to_pdf,
            ".png": self.to_png,
            ".csv": lambda: self._native.csv.encode("utf-8"),
        }
        make = makers.get(path.suffix.lower())
        if make is None:
            message = f"{printable(str(path))}: expected a name that ends in .svg, .pdf, .png or .csv"
            raise RequestError("usage", message, keywords=("output",))
        _native.write_file(path, make(), force)
        return path

    def _repr_svg_(self) -> str:
        return self.svg

    def __reduce__(self) -> tuple[Any, ...]:
        # The pickle has every format, because the process that loads it may not have the models.
        return Figure, (
            _RenderedFigure(
                self.svg, self.remarks, self._native.csv, self.to_pdf(), self.to_png(), self._native.panels
            ),
        )

    def __repr__(self) -> str:
        title = html.unescape("".join(re.findall(r"<title>(.*?)</title>", self.svg[:2000], re.DOTALL)[:1]))
        return repr_line("Figure", f"{clipped(title, 100)}: show it in a notebook, or write it with save()")


def _find_panel(panels: Sequence[Panel], name: str) -> Panel:
    """The panel with this name or letter.

    Raises
    ------
    RequestError
        There is none.
    """
    for panel in panels:
        if name == panel.name or name == panel.name.split(" ")[0]:
            return panel
    names = ", ".join(repr(printable(panel.name)) for panel in panels)
    raise RequestError("usage", f"panel={name!r}: expected one of {names}", keywords=("panel",))
