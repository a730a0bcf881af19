"""Figures that show themselves."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from . import _native
from ._errors import RequestError
from ._request import at_home
from ._text import printable


class _Drawn(NamedTuple):
    """A figure that came from another process or from a file: it is drawn already, in all formats."""

    svg: str
    notes: str
    csv: str
    as_pdf: bytes
    as_png: bytes

    def pdf(self) -> bytes:
        return self.as_pdf

    def png(self) -> bytes:
        return self.as_png


class Figure:
    """A figure; in a notebook the picture itself.

    Attributes
    ----------
    svg : str
        The figure as an SVG document.
    notes : str
        What is to be said beside it, such as the masses that were taken.
    """

    __slots__ = ("_native",)

    def __init__(self, native: _native.Figure | _Drawn) -> None:
        self._native = native

    @property
    def svg(self) -> str:
        return self._native.svg

    @property
    def notes(self) -> str:
        return self._native.notes

    @property
    def data(self) -> Any:
        """The numbers that are drawn, as a table: a DataFrame where pandas is there, else a list of dictionaries."""
        import csv
        import io

        from ._cells import from_cell
        from ._tables import table

        numbers = ("x", "y", "value")
        reader = csv.DictReader(io.StringIO(self._native.csv, newline=""))
        rows: list[dict[str, Any]] = []
        for row in reader:
            texts = {name: from_cell(text) for name, text in row.items()}
            rows.append(texts | {name: float(row[name]) if row[name] else None for name in numbers})
        return table(rows, list(reader.fieldnames or ()))

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
            Another ending.
        OutputError
            The file is there already and `force` is not said.
        """
        path = Path(at_home(output))
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
        # All that can be asked of it travels along: where it arrives, the models need not be there.
        return Figure, (_Drawn(self.svg, self.notes, self._native.csv, self.to_pdf(), self.to_png()),)

    def __repr__(self) -> str:
        return "<Figure: show it in a notebook, or write it with save()>"
