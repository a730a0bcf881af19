"""Finds a place where a function crosses 0."""

from __future__ import annotations

import math
from collections.abc import Callable

#: More steps than any bracket of doubles can be halved.
_MAX_STEPS = 2000


def find_root(function: Callable[[float], float], left: float, right: float, *, close: float) -> float:
    """The crossing of a continuous function between two places at which its signs differ.

    False position; an end that stays for two steps has its weight halved (Illinois). Where three steps do not make the bracket half
    as wide, the next one does. A smooth function needs about ten calls.

    Parameters
    ----------
    close : float
        Values within this of 0 are 0.

    Raises
    ------
    ValueError
        The function has the same sign at both places.
    """
    at_left, at_right = function(left), function(right)
    if abs(at_left) <= close:
        return left
    if abs(at_right) <= close:
        return right
    if (at_left > 0) == (at_right > 0):
        raise ValueError("the function has the same sign at both ends")
    widths, moved = [math.inf] * 3, ""
    for _ in range(_MAX_STEPS):
        middle = (left * at_right - right * at_left) / (at_right - at_left)
        if abs(right - left) > 0.5 * widths[-3] or not min(left, right) < middle < max(left, right):
            middle = 0.5 * (left + right)
        if middle in (left, right):
            break
        widths.append(abs(right - left))
        value = function(middle)
        if abs(value) <= close:
            return middle
        if (value > 0) == (at_left > 0):
            left, at_left = middle, value
            at_right = 0.5 * at_right if moved == "left" else at_right
            moved = "left"
        else:
            right, at_right = middle, value
            at_left = 0.5 * at_left if moved == "right" else at_left
            moved = "right"
    return 0.5 * (left + right)
