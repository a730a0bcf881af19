"""Many models that are changed: one change for all, or a row of a table for each."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from . import _native
from ._errors import RequestError
from ._progress import following
from ._request import fields_of, is_path, path_of
from ._rows import models_csv, rows_of
from ._survey import listed
from ._tables import columns_of, table
from ._text import printable
from ._threads import jobs_of
from .types import Progress, Table

log = logging.getLogger("osim_contact_scale")

#: Verbs that change models.
_CHANGING = ("rescale", "transfer", "add", "remove", "convert", "design", "set", "note")


def many(verb: str, models: Any, keywords: Mapping[str, Any], progress: Progress) -> Table:
    """Does the same change to many models: a row of the summary for each.

    Raises
    ------
    ContactScaleError
        A wrong call, or an output that is there already: found before anything is written.
    TypeError
        A model that is not the path of a file.
    """
    if verb not in _CHANGING:
        raise RequestError("usage", f"{verb!r}: expected a verb that changes models: {', '.join(_CHANGING)}")
    named = _given(models)
    if _is_table(named):
        message = "many does the same change to models and takes their paths; for a table: ocs.rescale_many(table, ...)"
        raise RequestError("usage", message)
    named = [named] if is_path(named) else named
    if not named:
        raise RequestError("usage", "there are no models: the list is empty")
    for model in named:
        if not is_path(model):
            kind = type(model).__name__
            raise TypeError(f"many changes files: expected the paths of models or folders, not {kind}")
    fields = fields_of(verb, {**keywords, "jobs": jobs_of(keywords.get("jobs"))})
    fields["models"] = [path_of(model) for model in named]
    with following(progress, verb) as callback:
        records, remarks = _native.change_many(fields, f'ocs.many("{verb}", ...)', callback)
    _report(records, remarks)
    return table(records, columns_of((), records))


def batch(of_models: Any, keywords: Mapping[str, Any], progress: Progress) -> Any:
    """Changes the models of a table: a row of the summary for each.

    Raises
    ------
    ContactScaleError
        Wrong rows, or an output that is there already: found before anything is written.
    """
    given = _given(of_models)
    if not _is_table(given):
        message = "expected a table with a row for each model: a DataFrame, a dictionary of columns, a list of dictionaries, or a .csv file"
        same = (
            'for the same change of several models, or of all in a folder: ocs.many("rescale", models, target_mass=...)'
        )
        raise RequestError("usage", f"{message}; {same}")
    rows = None if is_path(given) else rows_of(given)
    if rows is not None and not rows:
        raise RequestError("usage", "the table has no rows")
    data = None if rows is None else models_csv(rows)
    keywords = {**keywords, "jobs": jobs_of(keywords.get("jobs"))}
    fields = fields_of("batch", keywords if rows is not None else {**keywords, "manifest": of_models})
    with following(progress, "batch", None if rows is None else len(rows)) as callback:
        records, remarks = _native.rescale_many(fields, data, "ocs.rescale_many(table, ...)", callback)
    _report(records, remarks)
    # The user's columns, whose names begin with #.
    own = [record.pop("remarks", {}) for record in records]
    places = _places(records, rows or ())
    if rows is None or places is None:
        for record, remark in zip(records, own):
            record.update(remark)
        return table(records, columns_of((), records))
    # As they were given, not as text: so that the result can be merged with the table that it was made from.
    done: Any = table(records, columns_of((), records))
    for name in (name for name in columns_of((), rows) if name.startswith("#")):
        if not hasattr(done, "columns"):
            for record, place in zip(done, places):
                record[name] = rows[place].get(name)
        elif hasattr(given, "iloc"):
            done[name] = given[name].iloc[places].array
        else:
            done[name] = [rows[place].get(name) for place in places]
    return done


def _places(records: Sequence[Mapping[str, Any]], rows: Sequence[Any]) -> list[int] | None:
    """The row of each record, from 0; None if not all are known. In the table that Rust reads, the names of the columns are line 1."""
    places = [record["row"] - 2 for record in records if isinstance(record.get("row"), int)]
    are_known = len(places) == len(records) and all(0 <= place < len(rows) for place in places)
    return places if are_known else None


def _report(records: Sequence[Mapping[str, Any]], remarks: Sequence[str]) -> None:
    for remark in remarks:
        log.info("%s", remark)
    for record in records:
        if record["error"] is not None:
            log.error("%s: %s", printable(record["model"]), record["error"])


def _given(value: Any) -> Any:
    """A path or a table as it is; of anything else, a list of what it has."""
    return value if is_path(value) or hasattr(value, "columns") or isinstance(value, Mapping) else listed(value)


def _is_table(given: Any) -> bool:
    """Whether it is a table, or the name of a file with one; otherwise models."""
    if is_path(given):
        return Path(os.fsdecode(given)).suffix.lower() in (".csv", ".tsv", ".txt")
    if not isinstance(given, list):
        return True
    return bool(given) and all(isinstance(row, Mapping) for row in given)
