"""Between NumPy's arrays and the equations in Rust."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._errors import ContactScaleError, RequestError

#: A number or an array of numbers.
Number = float | ArrayLike
#: A list of numbers.
NumberList = Sequence[float] | NDArray[np.float64]
#: A float where every argument is a number, else an array of float64.
Values = float | NDArray[np.float64]


class Steps(NamedTuple):
    """Steps of a ladder; what each array is, `continuation_steps` says."""

    dimensionless_stiffness: NDArray[np.float64]
    modulus_factor: NDArray[np.float64]
    dissipation_factor: NDArray[np.float64]


def call(name: str, arguments: Mapping[str, Any], rule: str | None = None) -> Values:
    """The values of an equation over arrays, which are broadcast to one shape.

    Raises
    ------
    RequestError
        Shapes that do not go together, or a value outside of the domain, by its argument and element.
    TypeError
        An argument that is no real number.
    """
    arrays = {key: _floats(key, value) for key, value in arguments.items()}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{key} {array.shape}" for key, array in arrays.items() if array.shape)
        message = f"these shapes cannot be broadcast against each other: {shapes}"
        raise RequestError("usage", message, keywords=tuple(arrays)) from None
    if 0 in shape:
        return np.empty(shape)
    # What is one number for all is not copied for each of them.
    columns = [array if array.size == 1 else np.broadcast_to(array, shape) for array in arrays.values()]
    given, refusal = _native.equation(name, rule, [column.tobytes() for column in columns])
    if refusal is not None:
        raise _refused(refusal, arrays, shape)
    values = np.frombuffer(given or b"", dtype=np.float64).reshape(shape)
    return values if shape else float(values)


def call_of_list(name: str, arguments: Mapping[str, Any], height: Any = None, load: Any = 0.0) -> float:
    """The value of an equation over a list.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
    """
    arrays = {key: np.atleast_1d(_floats(key, value)) for key, value in arguments.items()}
    heights = None if height is None else np.atleast_1d(_floats("height", height))
    for key, array in (*arrays.items(), ("height", heights)):
        if array is not None and array.ndim > 1:
            raise RequestError("usage", f"{key} has the shape {array.shape}, expected one list", keywords=(key,))
    columns = [array.tobytes() for array in arrays.values()]
    weight = _floats("load", load)
    if weight.size != 1:
        raise RequestError("usage", f"load has the shape {weight.shape}, expected one number", keywords=("load",))
    own = float(weight.reshape(()))
    value, refusal = _native.equation_of_list(name, columns, None if heights is None else heights.tobytes(), own)
    if refusal is not None or value is None:
        known = dict(arrays) if heights is None else {**arrays, "height": heights}
        raise _refused(refusal or (None, None, "no value"), known, ())
    return value


def call_of_steps(first: float, last: float, dissipation_ratio: float, count: int) -> Steps:
    """The steps of a ladder.

    Raises
    ------
    RequestError
        A value outside of the domain.
    """
    columns, refusal = _native.steps(first, last, dissipation_ratio, count)
    if columns is None:
        raise _refused(refusal or (None, None, "no value"), {}, ())
    return Steps(*(np.array(column) for column in columns))


def _floats(name: str, value: Any) -> NDArray[np.float64]:
    """Real numbers as float64, whatever they were."""
    if np.ma.is_masked(value):
        message = f"{name} has masked elements, which no equation has a value for: leave them out, or fill them, first"
        raise RequestError("usage", message, keywords=(name,))
    array = np.asarray(value)
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


def _refused(refusal: tuple[Any, ...], arrays: Mapping[str, Any], shape: tuple[int, ...]) -> ContactScaleError:
    """The exception, with the place of the element in the array that was given."""
    name, index, message = refusal
    place = ""
    if index is not None:
        own = arrays[name].shape if name in arrays else shape
        at = np.unravel_index(index, shape) if shape else (index,)
        # An array with fewer dimensions, or one of length 1, is the same along the others.
        places = [int(step) if length > 1 else 0 for step, length in zip(at[len(at) - len(own) :], own)]
        place = str(places) if own else ""
    return RequestError("out-of-domain", message.replace("{}", place), keywords=(name,) if name else ())
