"""Heights and times that the tasks are given, in metres and seconds or as multiples of a model's size."""

from __future__ import annotations

import math

from .._errors import RequestError


def parse_multiple(value: float | str, unit: str, keyword: str) -> tuple[float, bool]:
    """A number, and whether it counts in the unit of the model: `0.01` does not, `"0.25R"` and `"x0.25"` do.

    Raises
    ------
    RequestError
        It is something else, below 0, or not finite.
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
    """Refuses a word that is not among those expected."""
    if value not in expected:
        words = " or ".join(map(repr, expected))
        raise RequestError("usage", f"{keyword}={value!r}: expected {words}", keywords=(keyword,))


def as_patterns(select: str | tuple[str, ...] | list[str]) -> tuple[str, ...]:
    """Names of forces, one or several, as a tuple."""
    return (select,) if isinstance(select, str) else tuple(select)
