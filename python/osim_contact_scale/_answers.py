"""What verbs give that compute and change nothing: `drop_test`, `motion`, `fit`, `design` alone, `presets`, `explain`, `reproduce`."""

from __future__ import annotations

import html
from collections.abc import Iterator, Mapping
from typing import Any

from ._tables import table


class Answer(Mapping[str, Any]):
    """Numbers by their names, as the command's JSON has them; the unit is in the name.

    Attributes
    ----------
    record : dict
        All of it.
    text : str
        The same, as the command prints it.
    """

    __slots__ = ("record", "text")

    def __init__(self, record: dict[str, Any], text: str) -> None:
        self.record = record
        self.text = text

    def __getitem__(self, name: str) -> Any:
        return self.record[name]

    def __getattr__(self, name: str) -> Any:
        if name in type(self).__slots__ or name.startswith("__"):
            raise AttributeError(name)
        try:
            return self.record[name]
        except KeyError:
            raise AttributeError(f"there is no {name}; there are {', '.join(self.record)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self.record)

    def __len__(self) -> int:
        return len(self.record)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.record]

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.record, self.text)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(list(self.record)[:6])}, ...>"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.text)}</pre>"


class DropTest(Answer):
    """A fall on the contacts of a model or preset."""

    __slots__ = ()

    @property
    def series(self) -> Any:
        """The motion over time: a table with a column for each quantity, the unit in its name."""
        columns: dict[str, list[float]] = self.record["series"]
        names = list(columns)
        return table([dict(zip(names, row)) for row in zip(*columns.values())], names)


class Motion(Answer):
    """The contacts of a model along a recorded motion.

    Attributes
    ----------
    record : dict
        Each foot and sphere, beside the plates.
    text : str
        The same, as the command prints it.
    """

    __slots__ = ("_columns",)

    def __init__(self, record: dict[str, Any], text: str, columns: dict[str, list[Any]]) -> None:
        super().__init__(record, text)
        self._columns = columns

    @property
    def rows(self) -> Any:
        """A row for each frame, sphere and force: places, velocities and forces, the unit in the name of each column."""
        names = list(self._columns)
        return table([dict(zip(names, row)) for row in zip(*self._columns.values())], names)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.record, self.text, self._columns)


class Fit(Answer):
    """Contact parameters from a measurement."""

    __slots__ = ()


class DesignSheet(Answer):
    """Quantities that follow from each other, without a model."""

    __slots__ = ()


class Preset(Answer):
    """Published contacts, or one's own."""

    __slots__ = ()


class Reproduction(Answer):
    """What the paper prints and what its equations give."""

    __slots__ = ()


class Explanation(Answer):
    """What an equation says, or what a warning or an error means."""

    __slots__ = ()
