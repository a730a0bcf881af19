"""Reads settings of tasks: heights and times in m and s or as multiples of the model's size, choices, and patterns of names."""

from __future__ import annotations

import math

from .._errors import RequestError


def parse_multiple(value: float | str, unit: str, keyword: str) -> tuple[float, bool]:
    """A number, and whether it is a multiple of the model's unit: `0.01` is none, `"0.25R"` and `"x0.25"` are multiples.

    Raises
    ------
    RequestError
        The value is something else, negative, or not finite.
    """
    text = str(value).strip()
    is_in_units = text.endswith(unit) or text.startswith("x")
    digits = text.removeprefix("x") if text.startswith("x") else text.removesuffix(unit)
    try:
        number = float(digits)
    except ValueError:
        number = math.nan
    if isinstance(value, bool) or not math.isfinite(number) or number < 0:
        raise RequestError(
            "usage", f"{keyword}={value!r}: expected a number, or one like '0.25{unit}'", keywords=(keyword,)
        )
    return number, is_in_units


def check_choice(value: str, expected: tuple[str, ...], keyword: str) -> None:
    """Refuses a word that is not among the expected words."""
    if value not in expected:
        words = " or ".join(map(repr, expected))
        raise RequestError("usage", f"{keyword}={value!r}: expected {words}", keywords=(keyword,))


def as_patterns(select: str | tuple[str, ...] | list[str]) -> tuple[str, ...]:
    """One or several patterns of names as a tuple."""
    return (select,) if isinstance(select, str) else tuple(select)
