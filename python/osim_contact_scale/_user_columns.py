"""Columns of a table that are not options but data of the user, which the result has again."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from ._errors import RequestError, warn
from ._kinds import kind_of
from ._option_names import ROW_OPTIONS, RUN_OPTIONS
from ._rows import column_option
from ._tables import all_columns, polars_table, table
from ._text import printable

#: Names of columns that the result has itself.
_RESULT_COLUMNS = re.compile(
    r"row|status|(contacts|target)_mass_kg|contacts_mass_source|objects|changes|unequal_factors|findings|error|error_code|line|column|folder"
    r"|tool_version|sha256_.*|(radius|stiffness|dissipation|\w+_friction|transition_velocity|constant_contact_force|\w+_smoothing)_"
    r"(from|to|factor)(_m)?"
)


class UserColumns(NamedTuple):
    """The columns of a table that are data of the user."""

    #: Names of the columns that the result has again.
    returned: frozenset[str]
    #: Names of the columns that are not passed to a verb.
    hidden: frozenset[str]


def user_columns(names: Sequence[str], keep: Any) -> UserColumns:
    """Finds the user's columns: those whose names begin with #, and those of `keep`.

    Raises
    ------
    RequestError
        The table has no column that `keep` names, or the result has a column of that name itself.
    TypeError
        `keep` is neither yes or no nor names.
    """
    kept = _columns_to_keep(names, keep)
    for name in kept:
        if _RESULT_COLUMNS.fullmatch(name):
            raise _keep_error(f"the result has a column {name!r} itself: rename yours, or let its name begin with #")
    marked = {name for name in names if name.startswith("#")}
    return UserColumns(
        frozenset(kept | marked), frozenset(name for name in kept - marked if column_option(name) not in ROW_OPTIONS)
    )


def _columns_to_keep(names: Sequence[str], keep: Any) -> set[str]:
    if keep is False or keep is None:
        return set()
    if keep is True:
        user_names = {
            name for name in names if not name.startswith("#") and column_option(name) not in ROW_OPTIONS | RUN_OPTIONS
        }
        for name in sorted(user_names):
            _warn_if_misspelt(name)
        return user_names
    if isinstance(keep, (bytes, Mapping)) or not isinstance(keep, Iterable):
        raise TypeError(f"keep: expected True, or the names of columns, not {type(keep).__name__}")
    kept = {keep} if isinstance(keep, str) else {str(name) for name in keep}
    for name in sorted(kept.difference(names)):
        raise _keep_error(f"the table has no column {name!r}{_suggestion_of_name(name, names)}")
    return kept


def _keep_error(message: str) -> RequestError:
    return RequestError("usage", f"keep: {message}", keywords=("keep",))


def _suggestion_of_name(name: str, names: Iterable[str]) -> str:
    import difflib

    matches = difflib.get_close_matches(name, list(names), 1, 0.85)
    return f": did you mean {matches[0]!r}?" if matches else ""


def _warn_if_misspelt(name: str) -> None:
    """Gives a warning if the name of a user's column is nearly that of an option: it may be misspelt."""
    suggestion = _suggestion_of_name(column_option(name), ROW_OPTIONS)
    if suggestion:
        warn(f"the column {printable(name)!r} is kept as yours, because it is not an option{suggestion}")


def column_names(original: Any, rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """The names of all columns of a table as texts."""
    labels = original.columns if kind_of(original) is not None else all_columns((), rows)
    return [str(name) for name in labels]


def visible_rows(rows: Sequence[Mapping[str, Any]], user: UserColumns) -> list[dict[str, Any]]:
    """The rows without the columns that no verb reads."""
    return [{name: value for name, value in row.items() if name not in user.hidden} for row in rows]


def join_user_columns(
    original: Any,
    user: UserColumns,
    rows: Sequence[Mapping[str, Any]],
    places: list[int],
    records: Sequence[Mapping[str, Any]],
) -> Any:
    """The results, with the user's columns of the original table before them: a table of that kind, with its index.

    `places` are the rows of the records, from 0. Columns keep their types, so that the result can be merged with the table.
    """
    columns = [name for name in all_columns((), records) if name not in user.returned]
    kind = kind_of(original)
    if kind is None:
        names = [name for name in all_columns((), rows) if name in user.returned]
        user_values = [{name: rows[place].get(name) for name in names} for place in places]
        return table([{**record, **one} for record, one in zip(records, user_values)], [*names, *columns])
    positions = [position for position, label in enumerate(original.columns) if str(label) in user.returned]
    if kind[0] == "polars":
        polars = sys.modules["polars"]
        results = polars_table(records, columns)
        return polars.concat([original[places, positions], results], how="horizontal") if positions else results
    import pandas as pd

    # All rows are taken by a slice: a list of them would make an index of another type.
    user_values = original.iloc[slice(None) if places == list(range(len(original))) else places, positions]
    results = table(records, columns)
    results.index = user_values.index
    return pd.concat([user_values, results], axis="columns")
