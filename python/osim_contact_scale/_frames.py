"""Tables that are always DataFrames, and the units of their columns."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from ._errors import ContactScaleError

if TYPE_CHECKING:
    import pandas as pd

#: Units by the ends of names; the longer ones first.
_UNITS = {
    "_n_m2": "N/m2", "_m_s2": "m/s2", "_n_m": "N/m", "_m_s": "m/s", "_s_m": "s/m", "_kg": "kg", "_hz": "Hz", "_mm": "mm",
    "_bw": "body weight", "_m": "m", "_n": "N", "_s": "s",
}  # fmt: skip

#: The axis of a place, which follows the unit in the name of a column.
_AXIS = re.compile(r"_[xyz]$")


class MissingPackage(ContactScaleError, ImportError):
    """An optional package that this call needs is not installed."""

    def __init__(self, package: str, extra: str, what: str) -> None:
        install = f'pip install "osim-contact-scale[{extra}]"'
        super().__init__("usage", f"{package} is not installed, which {what} needs: {install}")
        self._arguments = (package, extra, what)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), self._arguments


def require_package(package: str, extra: str, what: str) -> None:
    """Raises an error if a package is not installed.

    Raises
    ------
    MissingPackage
        It is not installed.
    """
    if importlib.util.find_spec(package) is None:
        raise MissingPackage(package, extra, what)


def to_frame(make: Callable[[], Any], units: Mapping[str, str] | None = None) -> pd.DataFrame:
    """A table of `_tables.table` as a DataFrame, with the units of its columns in `attrs["units"]`.

    Raises
    ------
    MissingPackage
        pandas is not installed.
    """
    require_package("pandas", "pandas", "frame()")
    frame: pd.DataFrame = make()
    named_units = {str(name): unit_from_name(str(name)) for name in frame.columns}
    frame.attrs["units"] = {**{name: unit for name, unit in named_units.items() if unit is not None}, **(units or {})}
    return frame


def unit_from_name(name: str) -> str | None:
    """The unit at the end of a column's name, or None."""
    name = _AXIS.sub("", name)
    return next((unit for end, unit in _UNITS.items() if name.endswith(end)), None)
