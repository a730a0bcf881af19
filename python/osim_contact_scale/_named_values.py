"""Objects whose values are attributes and items."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Mapping
from typing import Any

from ._text import printable

#: Most characters of a line of `repr`; a cell of a notebook shows about as many.
LINE = 160

#: Characters of a number.
_NUMBER = "0123456789.eE+-"


class NamedValues:
    """An object whose values are attributes and items: `thing.name` equals `thing["name"]`.

    Names are the public properties and fields of the class, and those of `_values`. A class that is also indexed by numbers calls
    `_get_by_name` for texts.
    """

    __slots__ = ()

    def _values(self) -> Mapping[str, Any]:
        """Values whose names are not attributes of the class."""
        return {}

    def _names(self) -> list[str]:
        attributes = (name for name in super().__dir__() if _is_attribute(type(self), name))
        return list(dict.fromkeys((*sorted(attributes), *self._values())))

    def _get_by_name(self, name: Any) -> Any:
        if isinstance(name, str) and _is_attribute(type(self), name):
            return getattr(self, name)
        try:
            return self._values()[name]
        except KeyError:
            raise KeyError(self._unknown_name(name)) from None

    def _unknown_name(self, name: Any) -> str:
        return f"there is no {printable(str(name))}; there are {', '.join(map(printable, self._names()))}"

    def __getitem__(self, name: Any) -> Any:
        return self._get_by_name(name)

    def __getattr__(self, name: str) -> Any:
        # An attribute of the class is missing only while an object is copied; it has no values yet.
        if name.startswith("_") or hasattr(type(self), name):
            raise AttributeError(name)
        try:
            return self._values()[name]
        except KeyError:
            raise AttributeError(self._unknown_name(name), name=name, obj=self) from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._values()]


def _is_attribute(kind: type, name: str) -> bool:
    """Whether a name is that of a public property or field of a class."""
    is_field = name in getattr(kind, "__dataclass_fields__", ())
    return not name.startswith("_") and (is_field or inspect.isdatadescriptor(getattr(kind, name, None)))


def repr_line(kind: str, text: str) -> str:
    """A line for `repr`."""
    return f"<{kind}: {clipped(text, LINE)}>"


def clipped(text: str, length: int) -> str:
    """A printable text, shortened to this length, but not inside a number."""
    text = printable(text)
    if len(text) <= length:
        return text
    start = text[: length - 1]
    if text[length - 1] in _NUMBER and (number := re.search(r"[\d.][\d.eE+-]*$", start)):
        start = start[: number.start()]
    return f"{start}…"


def repr_lines(head: str, entries: Iterable[str], count: int, limit: int = 8) -> str:
    """Lines for the `repr` of a list: a head, and a line for each of the first entries."""
    listed = [f"  {clipped(entry, LINE)}" for entry, _ in zip(entries, range(limit))]
    more = [f"  … and {count - limit} more"] if count > limit else []
    return "\n".join([f"<{head}>", *listed, *more])
