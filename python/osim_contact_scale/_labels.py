"""Labels of Series and DataFrames: the result of an equation gets the labels of its arguments.

Neither pandas nor polars is imported here: if the caller has not imported one of them, no argument can be of its classes.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._errors import RequestError
from ._kinds import kind_of

#: Types of most arguments. They have no labels, so that the search for labels is skipped.
_PLAIN = frozenset({float, int, list, tuple, np.ndarray, np.float64})
#: Values that must be equal in two arguments of one kind.
_MUST_MATCH = {
    ("pandas", "Series"): "indexes",
    ("pandas", "DataFrame"): "indexes or columns",
    ("polars", "Series"): "lengths",
    ("polars", "DataFrame"): "lengths or columns",
}


class Labels(NamedTuple):
    """The labels of a result: index, and columns of a DataFrame."""

    kind: tuple[str, str]
    #: The arguments that have these labels, by their names.
    owners: dict[str, Any]

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of an array that has these labels."""
        return tuple(len(axis) for axis in _axis_labels(self._first, self.kind))

    @property
    def _first(self) -> Any:
        return next(iter(self.owners.values()))

    def check_shape(self, shape: tuple[int, ...]) -> None:
        """Raises an error if a result has another shape than these labels."""
        if shape != self.shape:
            key = next(iter(self.owners))
            message = (
                f"{key} is a {self.kind[1]} of the shape {self.shape}, but with the other arguments the result has the shape {shape}, "
                f"which the labels of {key} do not fit: give {key}.to_numpy() for a result that is an array"
            )
            raise RequestError("usage", message, keywords=(key,))

    def attach(self, values: NDArray[np.float64]) -> Any:
        """The values with these labels, as a Series or DataFrame like the arguments."""
        module, kind = self.kind
        make, first = getattr(sys.modules[module], kind), self._first
        names = {owner.name for owner in self.owners.values()} if kind == "Series" else set()
        name = names.pop() if len(names) == 1 else None
        if self.kind == ("pandas", "Series"):
            return make(values, index=first.index, name=name, copy=False)
        if self.kind == ("pandas", "DataFrame"):
            return make(values, index=first.index, columns=first.columns, copy=False)
        if self.kind == ("polars", "Series"):
            return make(name or "", values)
        return make(values, schema=first.columns, orient="row")

    def describe_place(self, place: tuple[int, ...]) -> str:
        """The labels of one element, in brackets; an empty text if they only repeat its position."""
        parts = []
        for axis_name, axis, step in zip(("index", "column"), _axis_labels(self._first, self.kind), place):
            # An iterator gives plain Python numbers, whose repr is short.
            label = repr(next(iter(axis[step : step + 1])))
            if label != str(step):
                parts.append(f"{axis_name} {label}")
        return f" ({', '.join(parts)})" if parts else ""


def common_labels(arguments: Mapping[str, Any]) -> Labels | None:
    """The labels that all Series or DataFrames among the arguments have.

    Raises
    ------
    RequestError
        Two of them differ in kind or labels. The caller has to align them, and knows what elements without a partner mean.
    """
    if _PLAIN.issuperset(map(type, arguments.values())):
        return None
    kinds = {key: kind for key, value in arguments.items() if (kind := kind_of(value)) is not None}
    if not kinds:
        return None
    first, *others = kinds
    for other in others:
        if kinds[first] != kinds[other]:
            what = [f"{key} is a {kinds[key][1]} of {kinds[key][0]}" for key in (first, other)]
            remedy = f"give both as one kind, or one as an array, as by {other}.to_numpy()"
            raise RequestError("usage", f"{', '.join(what)}: {remedy}", keywords=(first, other))
        _check_same_labels(kinds[first], first, arguments[first], other, arguments[other])
    return Labels(kinds[first], {key: arguments[key] for key in kinds})


def missing_as_nan(value: Any) -> Any:
    """Numbers of pandas as an array, with NaN for NA; every other value unchanged."""
    kind = kind_of(value)
    if kind is None or kind[0] != "pandas":
        return value
    types = [value.dtype] if kind[1] == "Series" else list(value.dtypes)
    are_numbers = all(dtype.kind in "iuf" and dtype.itemsize <= 8 for dtype in types)
    return value.to_numpy(dtype=np.float64, na_value=np.nan) if are_numbers else value


def _axis_labels(value: Any, kind: tuple[str, str]) -> list[Any]:
    """Labels along each dimension; rows of polars have only their number."""
    if kind[0] == "pandas":
        return list(value.axes)
    return [range(len(value)), *([value.columns] if kind[1] == "DataFrame" else [])]


def _check_same_labels(kind: tuple[str, str], first: str, one: Any, second: str, other: Any) -> None:
    pairs = zip(_axis_labels(one, kind), _axis_labels(other, kind))
    if all(
        first_axis.equals(second_axis) if hasattr(first_axis, "equals") else first_axis == second_axis
        for first_axis, second_axis in pairs
    ):
        return
    remedy = "take both from one table, which join makes of two"
    if kind[0] == "pandas":
        remedy = f'align them first, as by {first}, {second} = {first}.align({second}, join="inner"), or where only the order counts, '
        remedy += f"give one of them as an array, as by {second}.to_numpy()"
    message = f"{first} and {second} have different {_MUST_MATCH[kind]}: {remedy}"
    raise RequestError("usage", message, keywords=(first, second))
