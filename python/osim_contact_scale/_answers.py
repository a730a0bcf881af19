"""Answers of the verbs that compute and change no model: `drop_test`, `motion`, `fit`, `design`, `presets`, `explain`, `reproduce`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from . import _native
from ._answer_fields import (
    DesignSheetFields,
    DropTestFields,
    ExplanationFields,
    FitFields,
    MotionFields,
    PresetFields,
    ReproductionFields,
)
from ._frames import to_frame, unit_from_name
from ._html import preformatted
from ._named_values import LINE, NamedValues, clipped, repr_line, repr_lines
from ._tables import all_columns, table
from .types import Table

if TYPE_CHECKING:
    import pandas as pd


class Answer(NamedValues, Mapping[str, Any]):
    """Numbers by their names, with the names of the command's JSON; the unit is in the name.

    Attributes
    ----------
    record : dict
        The whole answer.
    text : str
        The answer as the command prints it.

    Examples
    --------
    >>> drop = ocs.drop_test("falisse2022")
    >>> drop.peak_force_bw == drop["peak_force_bw"]
    True
    """

    __slots__ = ("record", "text")

    def __init__(self, record: dict[str, Any], text: str) -> None:
        self.record = record
        self.text = text

    def _values(self) -> Mapping[str, Any]:
        return self.record

    def __iter__(self) -> Iterator[str]:
        return iter(self._values())

    def __len__(self) -> int:
        return len(self._values())

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.record, self.text)

    def __str__(self) -> str:
        return self.text

    #: Names of values that `repr` shows first.
    _FIRST: ClassVar[tuple[str, ...]] = ()

    def __repr__(self) -> str:
        values = self._values()
        names = dict.fromkeys([*(name for name in self._FIRST if name in values), *values])
        kind, text = type(self).__name__, ""
        for name in names:
            value = values[name]
            # A fitted parameter with its uncertainty.
            value = value.get("value") if isinstance(value, dict) else value
            if name == "schema_version" or not isinstance(value, (str, int, float)):
                continue
            # A long text, such as a source, is shortened, so that the others fit.
            short = format(value, ".6g") if isinstance(value, float) else clipped(repr(value), 40)
            field = f"{', ' if text else ''}{name}={short}"
            if len(kind) + len(text) + len(field) > LINE - len("<: , …>"):
                return f"<{kind}: {text}, …>"
            text += field
        return repr_line(kind, text or ", ".join(values))

    def _repr_html_(self) -> str:
        return preformatted(self.text, "print() and .text have all")


class DropTest(Answer, DropTestFields):
    """A simulated fall on the contacts of a model or preset."""

    __slots__ = ()
    _FIRST = ("peak_force_bw", "final_relative_indentation", "restitution_exact", "mass_kg", "model")

    @property
    def series(self) -> Table:
        """The motion over time: a table with a column for each quantity, the unit in its name."""
        return _table_from_columns(self.record["series"])

    def frame(self) -> pd.DataFrame:
        """The motion over time, always as a DataFrame; units are in `attrs["units"]`, too.

        Examples
        --------
        >>> ocs.drop_test("falisse2022").frame()["force_bw"].max()
        """
        return to_frame(lambda: self.series)


class Motion(Answer, MotionFields):
    """The contacts of a model along a recorded motion.

    Attributes
    ----------
    record : dict
        Each foot and sphere, compared with the plates.
    text : str
        The answer as the command prints it.
    """

    __slots__ = ("_columns",)
    _FIRST = ("stride_mean_n", "measured_stride_mean_n", "weight_n", "mass_kg", "frames", "model")

    def __init__(self, record: dict[str, Any], text: str, columns: dict[str, list[Any]]) -> None:
        super().__init__(record, text)
        self._columns = columns

    @property
    def rows(self) -> Table:
        """A row for each frame, sphere and force: places, velocities and forces, the unit in the name of each column."""
        return _table_from_columns(self._columns)

    def frame(self) -> pd.DataFrame:
        """The rows, always as a DataFrame; units are in `attrs["units"]`, too.

        Examples
        --------
        >>> ocs.motion("walker.osim", "walk.mot").frame().groupby("sphere")["relative_indentation"].max()
        """
        return to_frame(lambda: self.rows)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.record, self.text, self._columns)


class Fit(Answer, FitFields):
    """Contact parameters from a measurement."""

    __slots__ = ()
    _FIRST = ("stiffness", "dissipation", "onset_m", "radius_m", "r_squared")

    def frame(self) -> pd.DataFrame:
        """A row for each parameter: `name`, `value`, `unit`, and its uncertainty: `standard_error`, `low_95`, `high_95`.

        Examples
        --------
        >>> ocs.fit("heel_pad.csv", radius=0.03, indentation_unit="mm").frame()[["name", "value", "unit"]]
        """
        units = _native.units()
        return _frame_from_rows(
            [
                {"name": name, "unit": units.get(name) or unit_from_name(name), **estimate}
                for name, estimate in self.record.items()
                if isinstance(estimate, dict) and "standard_error" in estimate
            ]
        )


class DesignSheet(Answer, DesignSheetFields):
    """Quantities that the equations compute from each other, without a model: each by its name.

    Examples
    --------
    >>> sheet = ocs.design(mass=62, spheres=6, radius=0.032, indentation=0.16)
    >>> sheet.stiffness == sheet["stiffness"]
    True
    """

    __slots__ = ()
    _FIRST = ("radius_m", "stiffness", "dissipation", "relative_indentation")

    def _values(self) -> Mapping[str, Any]:
        # The quantities of a design sheet are also found by their names.
        return {**self.record, **{figure["name"]: figure["value"] for figure in self.record["figures"]}}

    def frame(self) -> pd.DataFrame:
        """A row for each quantity: `name`, `value`, `unit`, `equation`, whether it was `given`, its `limit`.

        Examples
        --------
        >>> ocs.design(mass=62, spheres=6, radius=0.032, indentation=0.16).frame().set_index("name")["value"]
        """
        limits = (figure["limit"] or {} for figure in self.record["figures"])
        rows = [
            {**figure, "limit": limit.get("text"), "within_limit": limit.get("within_limit")}
            for figure, limit in zip(self.record["figures"], limits)
        ]
        return _frame_from_rows(rows)


class Preset(Answer, PresetFields):
    """Contacts that are published or that the user has defined."""

    __slots__ = ()
    _FIRST = ("name", "mass_kg", "radius_m", "stiffness", "dissipation")

    def frame(self) -> pd.DataFrame:
        """One row with its numbers; dimensionless ones have `dimensionless_` before their names.

        Examples
        --------
        >>> ocs.presets("falisse2022")[0].frame()["stiffness"]
        """
        return Presets([self]).frame()


class Presets(list[Preset]):
    """Presets, as a list; `frame()` is a table of them."""

    def frame(self) -> pd.DataFrame:
        """A row for each preset with its numbers; dimensionless ones have `dimensionless_` before their names.

        Examples
        --------
        >>> ocs.presets().frame()[["name", "stiffness", "dimensionless_modulus"]]
        """
        rows = []
        for preset in self:
            plain = {name: value for name, value in preset.record.items() if name != "schema_version"}
            dimensionless = {
                f"dimensionless_{name}": value for name, value in (plain.pop("dimensionless") or {}).items()
            }
            rows.append(plain | dimensionless)
        return _frame_from_rows(rows)

    def __repr__(self) -> str:
        return repr_lines(f"Presets: {len(self)}", (repr(preset) for preset in self), len(self))

    def _repr_html_(self) -> str:
        return preformatted("\n".join(preset.text for preset in self), "each preset by itself has its own")


class Reproduction(Answer, ReproductionFields):
    """The numbers that the paper prints, and those that its equations give."""

    __slots__ = ()

    def frame(self) -> pd.DataFrame:
        """A row for each number of Table 1 of the paper: `taxon`, `name`, `unit`, as `printed`, as `computed`, and their difference.

        Examples
        --------
        >>> ocs.reproduce().frame()["within_last_digit"].value_counts()
        """
        return _frame_from_rows(
            [{"taxon": row["taxon"], **value} for row in self.record["table1"] for value in row["values"]],
        )


class Explanation(Answer, ExplanationFields):
    """An explanation of an equation, a finding or an error."""

    __slots__ = ()


def _table_from_columns(columns: Mapping[str, list[Any]]) -> Table:
    """A table made of columns."""
    names = list(columns)
    return table([dict(zip(names, row)) for row in zip(*columns.values())], names)


def _frame_from_rows(rows: list[dict[str, Any]]) -> pd.DataFrame:
    """A DataFrame of rows, with every column that a row has."""
    return to_frame(lambda: table(rows, all_columns((), rows)))
