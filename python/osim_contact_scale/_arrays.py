"""Calls the equations in Rust with NumPy arrays and returns their values as arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._errors import ContactScaleError, RequestError
from ._labels import Labels, common_labels, missing_as_nan

if TYPE_CHECKING:
    import pandas as pd

    #: A Series of pandas.
    PandasSeries = pd.Series[Any]
    #: A Series that an equation returns.
    PandasFloats = pd.Series[float]
    #: A DataFrame of pandas or polars: an equation returns the kind that it was given.
    Frame = TypeVar("Frame", bound=pd.DataFrame | "PolarsLabelled")


class Labelled(Protocol):
    """A Series or a DataFrame, of pandas or of polars."""

    def to_numpy(self, *args: Any, **kwargs: Any) -> Any:
        """Returns its values."""


class PolarsLabelled(Labelled, Protocol):
    """A Series or a DataFrame of polars, recognised by a method that pandas does not have."""

    def drop_nulls(self, *args: Any, **kwargs: Any) -> Any:
        """Returns the values that are not missing."""


#: A number.
Scalar = float | np.floating[Any] | np.integer[Any]
#: An array of numbers without labels. `ArrayLike` would also match Series, and type checkers would not see which type is returned.
Array = NDArray[Any] | Sequence[Scalar] | Sequence[Sequence[Scalar]] | Sequence[NDArray[Any]]
#: An array that an equation returns.
Floats = NDArray[np.float64]
#: A number or an array of numbers, with labels or without.
Number = Scalar | Array | ArrayLike | Labelled
#: A list of numbers.
NumberList = Sequence[float] | NDArray[np.float64] | Labelled


class Steps(NamedTuple):
    """Steps from a soft contact to a stiff one; `continuation_steps` explains each array."""

    dimensionless_stiffness: NDArray[np.float64]
    modulus_factor: NDArray[np.float64]
    dissipation_factor: NDArray[np.float64]


def call(name: str, arguments: Mapping[str, Any], nan: str, rule: str | None = None) -> Any:
    """The values of an equation for arrays, which are broadcast to one shape. The result has the labels of the arguments.

    Raises
    ------
    RequestError
        Shapes or labels do not match, or a value is outside of the domain; the message names its argument and element.
    TypeError
        An argument is not a real number.
    """
    labels = common_labels(arguments)
    arrays = {key: _floats_of_argument(key, value) for key, value in arguments.items()}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{key} {array.shape}" for key, array in arrays.items() if array.shape)
        message = f"these shapes cannot be broadcast against each other: {shapes}"
        raise RequestError("usage", message, keywords=tuple(arrays)) from None
    if labels is not None:
        labels.check_shape(shape)
    valid = _valid_indices(arrays, shape) if _propagates(nan) else None
    values = np.empty(shape) if 0 in shape else _values_of_equation(name, rule, arrays, shape, valid, labels)
    if labels is not None:
        return labels.attach(values)
    return values if shape else float(values)


def call_of_list(
    name: str, arguments: Mapping[str, Any], height: Any = None, load: Any = 0.0, *, nan: str = "raise"
) -> float:
    """The value of an equation for a list.

    Raises
    ------
    RequestError
        Labels do not match, or a value is outside of the domain; the message names its argument and element.
    """
    inputs = dict(arguments) if height is None else {**arguments, "height": height}
    labels = common_labels(inputs)
    arrays = {key: np.atleast_1d(_floats_of_argument(key, value)) for key, value in inputs.items()}
    for key, array in arrays.items():
        if array.ndim > 1:
            raise RequestError("usage", f"{key} has the shape {array.shape}, expected one list", keywords=(key,))
    weight = _floats_of_argument("load", load)
    if weight.size != 1:
        raise RequestError("usage", f"load has the shape {weight.shape}, expected one number", keywords=("load",))
    # A sum has no value if one of its terms has none.
    if _propagates(nan) and any(np.isnan(array).any() for array in (weight, *arrays.values())):
        return float("nan")
    columns = [arrays[key].tobytes() for key in arguments]
    heights = arrays["height"].tobytes() if "height" in arrays else None
    value, refusal = _native.equation_of_list(name, columns, heights, float(weight.reshape(())))
    if refusal is not None or value is None:
        raise _domain_error(refusal or (None, None, "no value"), arrays, (), labels)
    return value


def call_of_steps(first: float, last: float, dissipation_ratio: float, count: int, nan: str = "raise") -> Steps:
    """The steps from a soft contact to a stiff one.

    Raises
    ------
    RequestError
        A value is outside of the domain.
    """
    numbers = (first, last, dissipation_ratio)
    missing = _propagates(nan) and any(np.isnan(number) for number in numbers)
    # If all steps will be NaN, numbers that are always valid are used, so that the count is still checked.
    columns, refusal = _native.steps(*((1.0, 2.0, 1.0) if missing else numbers), count)
    if columns is None:
        raise _domain_error(refusal or (None, None, "no value"), {}, ())
    return Steps(*(np.full(len(column), np.nan) if missing else np.array(column) for column in columns))


def _propagates(nan: str) -> bool:
    """Whether NaN in an argument gives NaN in the result instead of an error."""
    if nan not in ("raise", "propagate"):
        raise RequestError("usage", f'nan is {nan!r}, expected "raise" or "propagate"', keywords=("nan",))
    return nan == "propagate"


def _valid_indices(arrays: Mapping[str, NDArray[np.float64]], shape: tuple[int, ...]) -> NDArray[np.intp] | None:
    """Indices of the elements without NaN in the flattened result; None if no element has NaN."""
    missing = np.zeros(shape, dtype=bool)
    for array in arrays.values():
        missing |= np.isnan(array)
    if not missing.any():
        return None
    valid = np.flatnonzero(~missing)
    # A column of one element would be read as one number for all elements, and an error would not name its place.
    return np.repeat(valid, 2) if valid.size == 1 else valid


def _values_of_equation(
    name: str,
    rule: str | None,
    arrays: Mapping[str, NDArray[np.float64]],
    shape: tuple[int, ...],
    valid: NDArray[np.intp] | None,
    labels: Labels | None,
) -> NDArray[np.float64]:
    """The values of an equation; elements that are not valid get NaN."""
    if valid is not None and not valid.size:
        return np.full(shape, np.nan)
    # One number for all elements is not copied for each of them.
    columns = [array if array.size == 1 else np.broadcast_to(array, shape) for array in arrays.values()]
    if valid is not None:
        columns = [column if column.size == 1 else column.ravel()[valid] for column in columns]
    result, refusal = _native.equation(name, rule, [column.tobytes() for column in columns])
    if refusal is not None:
        raise _domain_error(_with_original_index(refusal, valid), arrays, shape, labels)
    calculated = np.frombuffer(result or b"", dtype=np.float64)
    if valid is None:
        return calculated.reshape(shape)
    values = np.full(shape, np.nan)
    values.flat[valid] = calculated
    return values


def _with_original_index(refusal: tuple[Any, ...], valid: NDArray[np.intp] | None) -> tuple[Any, ...]:
    """A refusal whose index counts all elements, not only the valid ones."""
    name, index, message = refusal
    return refusal if valid is None or index is None else (name, int(valid[index]), message)


def _floats_of_argument(name: str, value: Any) -> NDArray[np.float64]:
    """Real numbers of any kind as float64."""
    if np.ma.is_masked(value):
        message = f"{name} has masked elements, which no equation has a value for: leave them out, or fill them, first"
        raise RequestError("usage", message, keywords=(name,))
    array = np.asarray(value)
    if array.dtype.kind == "O":
        array = np.asarray(missing_as_nan(value))
    # A column of a DataFrame may hold its numbers as objects.
    objects = array.dtype.kind == "O" and all(_is_real(item) for item in array.flat)
    if not objects and (array.dtype.kind not in "iuf" or array.dtype.itemsize > 8):
        raise TypeError(f"{name}: expected real numbers, not {array.dtype}")
    try:
        return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)
    except OverflowError:
        message = f"{name}: a whole number is too large, expected less than 1e308"
        raise RequestError("out-of-domain", message, keywords=(name,)) from None


def _is_real(item: Any) -> bool:
    return isinstance(item, (int, float, np.integer, np.floating)) and not isinstance(item, bool)


def _domain_error(
    refusal: tuple[Any, ...], arrays: Mapping[str, Any], shape: tuple[int, ...], labels: Labels | None = None
) -> ContactScaleError:
    """The exception for a refusal, with the place of the element in the argument."""
    name, index, message = refusal
    place = ""
    if index is not None:
        argument_shape = arrays[name].shape if name in arrays else shape
        position = np.unravel_index(index, shape) if shape else (index,)
        # An array with fewer dimensions, or with length 1, is repeated along the others.
        places = [
            int(step) if length > 1 else 0
            for step, length in zip(position[len(position) - len(argument_shape) :], argument_shape)
        ]
        place = str(places) if argument_shape else ""
        if labels is not None and argument_shape == labels.shape:
            place += labels.describe_place(tuple(places))
    if " is NaN," in message:
        message += ' (with nan="propagate" its result is NaN)'
    return RequestError("out-of-domain", message.replace("{}", place), keywords=(name,) if name else ())
