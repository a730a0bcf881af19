"""Columns of a table that are the user's own: which they are, and how they come back beside what was done."""

from __future__ import annotations

import logging
import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from ._errors import RequestError
from ._kinds import kind_of
from ._options import ROW_OPTIONS, RUN_OPTIONS
from ._rows import option_of
from ._tables import columns_of, polars_table, table
from ._text import printable

log = logging.getLogger("osim_contact_scale")

#: Columns of the result that are not those of the table with the same name.
_RESULT = re.compile(
    r"row|status|(contacts|target)_mass_kg|contacts_mass_source|objects|changes|unequal_factors|warnings|error|error_code|line|column|folder"
    r"|tool_version|sha256_.*|(radius|stiffness|dissipation|\w+_friction|transition_velocity|constant_contact_force|\w+_smoothing)_"
    r"(from|to|factor)(_m)?"
)


class OwnColumns(NamedTuple):
    """The user's own columns of a table."""

    #: Those that come back, by their names as text.
    returned: frozenset[str]
    #: Those that no verb is to see.
    hidden: frozenset[str]


def own_columns(names: Sequence[str], keep: Any) -> OwnColumns:
    """Which columns are the user's own: those whose names begin with #, and those of `keep`.

    Raises
    ------
    RequestError
        A column of `keep` that is not there, or that the result has, too.
    TypeError
        `keep` is neither yes or no nor names.
    """
    kept = _kept(names, keep)
    for name in kept:
        if _RESULT.fullmatch(name):
            raise _wrong(f"the result has a column {name!r} itself: rename yours, or let its name begin with #")
    remarks = {name for name in names if name.startswith("#")}
    return OwnColumns(
        frozenset(kept | remarks), frozenset(name for name in kept - remarks if option_of(name) not in ROW_OPTIONS)
    )


def _kept(names: Sequence[str], keep: Any) -> set[str]:
    if keep is False or keep is None:
        return set()
    if keep is True:
        own = {name for name in names if not name.startswith("#") and option_of(name) not in ROW_OPTIONS | RUN_OPTIONS}
        for name in sorted(own):
            _say_what_is_like(name)
        return own
    if isinstance(keep, (bytes, Mapping)) or not isinstance(keep, Iterable):
        raise TypeError(f"keep: expected True, or the names of columns, not {type(keep).__name__}")
    kept = {keep} if isinstance(keep, str) else {str(name) for name in keep}
    for name in sorted(kept.difference(names)):
        raise _wrong(f"the table has no column {name!r}{_like(name, names)}")
    return kept


def _wrong(message: str) -> RequestError:
    return RequestError("usage", f"keep: {message}", keywords=("keep",))


def _like(name: str, names: Iterable[str]) -> str:
    import difflib

    near = difflib.get_close_matches(name, list(names), 1, 0.85)
    return f": did you mean {near[0]!r}?" if near else ""


def _say_what_is_like(name: str) -> None:
    """Says that a column is the user's whose name is nearly that of an option: it may be misspelt."""
    like = _like(option_of(name), ROW_OPTIONS)
    if like:
        log.warning("the column %s is kept as yours, because it is not an option%s", repr(printable(name)), like)


def names_of(given: Any, rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """The names of all columns of a table, as text."""
    labels = given.columns if kind_of(given) is not None else columns_of((), rows)
    return [str(name) for name in labels]


def seen(rows: Sequence[Mapping[str, Any]], own: OwnColumns) -> list[dict[str, Any]]:
    """The rows as verbs see them."""
    return [{name: value for name, value in row.items() if name not in own.hidden} for row in rows]


def beside(
    given: Any,
    own: OwnColumns,
    rows: Sequence[Mapping[str, Any]],
    places: list[int],
    records: Sequence[Mapping[str, Any]],
) -> Any:
    """What was done, with the user's own columns before it, taken from the table itself: one of the same kind, with its index.

    `places` are the rows of the records, from 0. Columns have their kinds, too, so that the result can be merged with the table.
    """
    columns = [name for name in columns_of((), records) if name not in own.returned]
    kind = kind_of(given)
    if kind is None:
        names = [name for name in columns_of((), rows) if name in own.returned]
        mine = [{name: rows[place].get(name) for name in names} for place in places]
        return table([{**record, **one} for record, one in zip(records, mine)], [*names, *columns])
    positions = [position for position, label in enumerate(given.columns) if str(label) in own.returned]
    if kind[0] == "polars":
        polars = sys.modules["polars"]
        done = polars_table(records, columns)
        return polars.concat([given[places, positions], done], how="horizontal") if positions else done
    import pandas as pd

    # All rows are taken as they are: a list of them would make an index of another kind.
    mine = given.iloc[slice(None) if places == list(range(len(given))) else places, positions]
    done = table(records, columns)
    done.index = mine.index
    return pd.concat([mine, done], axis="columns")
