"""Many models that are changed: one change for all, or a row of a table for each."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, get_args

from . import _native
from ._errors import RequestError
from ._gaps import explain_gaps, find_gaps, log_gaps
from ._kinds import kind_of
from ._options import ChangingVerb
from ._progress import progress_callback
from ._request import fields_of, is_path, path_of
from ._rows import as_known, is_blank, models_csv, rows_of
from ._survey import as_list
from ._tables import all_columns, table
from ._text import printable
from ._threads import thread_count
from ._user_columns import column_names, join_user_columns, user_columns, visible_rows
from .types import Progress, Table

log = logging.getLogger("osim_contact_scale")


def many(verb: str, models: Any, keywords: Mapping[str, Any], progress: Progress) -> Table:
    """Does the same change to many models: a row of the summary for each.

    Raises
    ------
    ContactScaleError
        A wrong call, or an output that is there already: found before anything is written.
    TypeError
        A model that is not the path of a file.
    """
    known = get_args(ChangingVerb)
    if verb not in known:
        raise RequestError("usage", f"{verb!r}: expected a verb that changes models: {', '.join(known)}")
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
    fields = fields_of(verb, {**keywords, "jobs": thread_count(keywords.get("jobs"))})
    fields["models"] = [path_of(model) for model in named]
    with progress_callback(progress, verb) as callback:
        records, remarks = _native.change_many(fields, f'ocs.many("{verb}", ...)', callback)
    _report(records, remarks)
    return table(records, all_columns((), records))


def batch(of_models: Any, keep: Any, keywords: Mapping[str, Any], progress: Progress) -> Any:
    """Changes the models of a table: a row of the summary for each, with the user's own columns.

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
    keywords = {**keywords, "jobs": thread_count(keywords.get("jobs"))}
    if is_path(given):
        if keep:
            message = "keep: columns of a file are kept where their names begin with #; or read it first, as by pandas.read_csv"
            raise RequestError("usage", message, keywords=("keep",))
        return _as_texts(_done(fields_of("batch", {**keywords, "manifest": of_models}), None, None, progress))
    rows = rows_of(given)
    if not rows:
        raise RequestError("usage", "the table has no rows")
    own = user_columns(column_names(given, rows), keep)
    shown = visible_rows(rows, own)
    gaps = find_gaps(shown, kind_of(given) is not None)
    _refuse_nameless(rows, shown)
    log_gaps(gaps, shown)
    data = models_csv(shown)
    try:
        records = _done(fields_of("batch", keywords), data, len(rows), progress)
    except RequestError as error:
        raise explain_gaps(error, gaps) from None
    places = _places(records, rows)
    if places is None:
        return _as_texts(records)
    for record in records:
        record.pop("remarks", None)
    return join_user_columns(given, own, rows, places, records)


def _done(
    fields: dict[str, Any], data: bytes | None, count: int | None, progress: Progress
) -> Sequence[dict[str, Any]]:
    """Does the rows of a table: a record for each."""
    with progress_callback(progress, "batch", count) as callback:
        records, remarks = _native.rescale_many(fields, data, "ocs.rescale_many(table, ...)", callback)
    _report(records, remarks)
    return records


def _as_texts(records: Sequence[dict[str, Any]]) -> Table:
    """Records as a table, with the user's columns, whose names begin with #, as texts."""
    for record in records:
        record.update(record.pop("remarks", {}))
    return table(records, all_columns((), records))


def _refuse_nameless(rows: Sequence[Mapping[str, Any]], shown: Sequence[Mapping[str, Any]]) -> None:
    """Refuses rows that have the user's own values alone: empty ones are left out, but these are not empty."""
    pairs = enumerate(zip(rows, shown), 2)
    wrong = [number for number, (row, own) in pairs if is_blank(own) and not is_blank(row)]
    if wrong:
        lines = [f"table: row {number}, column 'model': empty, expected the model's file name" for number in wrong]
        many = "1 row is" if len(wrong) == 1 else f"{len(wrong)} rows are"
        raise RequestError("usage", "\n".join([f"{many} wrong, so nothing was written:", *lines]))


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
    """A path or a table that is known here; of anything else, a list of what it has."""
    value = as_known(value)
    return value if is_path(value) or hasattr(value, "columns") or isinstance(value, Mapping) else as_list(value)


def _is_table(given: Any) -> bool:
    """Whether it is a table, or the name of a file with one; otherwise models."""
    if is_path(given):
        return Path(os.fsdecode(given)).suffix.lower() in (".csv", ".tsv", ".txt")
    if not isinstance(given, list):
        return True
    return bool(given) and all(isinstance(row, Mapping) for row in given)
