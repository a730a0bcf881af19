"""Changes many models: all in one way, or each by a row of a table."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, get_args

from . import _native
from ._errors import RequestError
from ._gaps import explain_gaps, find_gaps, log_gaps
from ._keywords import is_file_object, is_path, to_fields, to_path
from ._kinds import kind_of
from ._option_names import ChangingVerb
from ._progress import progress_callback
from ._rows import is_blank, models_csv, row_names, to_known_table, to_rows
from ._survey import as_list
from ._tables import all_columns, table
from ._text import printable
from ._threads import thread_count
from ._user_columns import column_names, join_user_columns, user_columns, visible_rows
from .types import Progress, Table

log = logging.getLogger("osim_contact_scale")


def many(verb: str, models: Any, keywords: Mapping[str, Any], progress: Progress) -> Table:
    """Makes one change in many models, and returns a row of the summary for each.

    Raises
    ------
    ContactScaleError
        The call is wrong, or a result exists already. Nothing was written.
    TypeError
        A model is not the path of a file.
    """
    verbs = get_args(ChangingVerb)
    if verb not in verbs:
        raise RequestError("usage", f"{verb!r}: expected a verb that changes models: {', '.join(verbs)}")
    sources = _paths_or_table(models)
    if _is_table(sources):
        message = "many does the same change to models and takes their paths; for a table: ocs.rescale_many(table, ...)"
        raise RequestError("usage", message)
    sources = [sources] if is_path(sources) else sources
    if not sources:
        raise RequestError("usage", "there are no models: the list is empty")
    for model in sources:
        if not is_path(model):
            kind = type(model).__name__
            raise TypeError(f"many changes files: expected the paths of models or folders, not {kind}")
    fields = to_fields(verb, {**keywords, "jobs": thread_count(keywords.get("jobs"))})
    fields["models"] = [to_path(model) for model in sources]
    with progress_callback(progress, verb) as callback:
        records, remarks = _native.change_many(fields, f'ocs.many("{verb}", ...)', callback)
    _log_outcomes(records, remarks)
    return table(records, all_columns((), records))


def batch(models: Any, keep: Any, keywords: Mapping[str, Any], progress: Progress) -> Any:
    """Changes the models of a table, and returns a row of the summary for each, with the user's columns.

    Raises
    ------
    ContactScaleError
        Rows are wrong, or a result exists already. Nothing was written.
    """
    is_refused = is_file_object(models) or hasattr(models, "to_dataframe")
    source = to_rows(models) if is_refused else _paths_or_table(models)
    if not _is_table(source):
        message = "expected a table with a row for each model: a DataFrame, a dictionary of columns, a list of dictionaries, or a .csv file"
        alternative = (
            'for the same change of several models, or of all in a folder: ocs.many("rescale", models, target_mass=...)'
        )
        raise RequestError("usage", f"{message}; {alternative}")
    keywords = {**keywords, "jobs": thread_count(keywords.get("jobs"))}
    if is_path(source):
        if keep:
            message = "keep: columns of a file that are not options are kept without it; or read it first, as by pandas.read_csv"
            raise RequestError("usage", message, keywords=("keep",))
        return _text_table(_change_rows(to_fields("batch", {**keywords, "manifest": models}), None, None, progress))
    rows = to_rows(source)
    if not rows:
        raise RequestError("usage", "the table has no rows")
    user = user_columns(column_names(source, rows), keep)
    visible = visible_rows(rows, user)
    gaps = find_gaps(visible, kind_of(source) is not None)
    log_gaps(gaps, visible)
    try:
        _refuse_nameless(rows, visible)
        records = _change_rows(to_fields("batch", keywords), models_csv(visible), len(rows), progress)
    except (RequestError, TypeError) as error:
        raise explain_gaps(error, gaps, row_names(source, len(rows))) from None
    places = _rows_of_records(records, rows)
    if places is None:
        return _text_table(records)
    for record in records:
        record.pop("columns", None)
    return join_user_columns(source, user, rows, places, records)


def _change_rows(
    fields: dict[str, Any], data: bytes | None, count: int | None, progress: Progress
) -> Sequence[dict[str, Any]]:
    """Changes the models of a table's rows, and returns a record for each."""
    with progress_callback(progress, "batch", count) as callback:
        records, remarks = _native.rescale_many(fields, data, "ocs.rescale_many(table, ...)", callback)
    _log_outcomes(records, remarks)
    return records


def _text_table(records: Sequence[dict[str, Any]]) -> Table:
    """A table of the records, with the user's columns as texts."""
    for record in records:
        record.update(record.pop("columns", {}))
    return table(records, all_columns((), records))


def _refuse_nameless(rows: Sequence[Mapping[str, Any]], visible: Sequence[Mapping[str, Any]]) -> None:
    """Refuses rows that have values only in the user's columns. Empty rows are left out, but these are not empty."""
    pairs = enumerate(zip(rows, visible), 2)
    wrong = [number for number, (row, visible_row) in pairs if is_blank(visible_row) and not is_blank(row)]
    if wrong:
        lines = [f"table: row {number}, column 'model': empty, expected the model's file name" for number in wrong]
        count_phrase = "1 row is" if len(wrong) == 1 else f"{len(wrong)} rows are"
        raise RequestError("usage", "\n".join([f"{count_phrase} wrong, so nothing was written:", *lines]))


def _rows_of_records(records: Sequence[Mapping[str, Any]], rows: Sequence[Any]) -> list[int] | None:
    """The row of each record, from 0; None if a row is not known. In the table that Rust reads, the names of the columns are line 1."""
    places = [record["row"] - 2 for record in records if isinstance(record.get("row"), int)]
    are_known = len(places) == len(records) and all(0 <= place < len(rows) for place in places)
    return places if are_known else None


def _log_outcomes(records: Sequence[Mapping[str, Any]], remarks: Sequence[str]) -> None:
    for remark in remarks:
        log.info("%s", remark)
    for record in records:
        if record["error"] is not None:
            log.error("%s: %s", printable(record["model"]), record["error"])


def _paths_or_table(value: Any) -> Any:
    """A path or a table unchanged; everything else as a list of models."""
    value = to_known_table(value)
    return value if is_path(value) or hasattr(value, "columns") or isinstance(value, Mapping) else as_list(value)


def _is_table(value: Any) -> bool:
    """Whether a value is a table or the path of a table, and not one or several models."""
    if is_path(value):
        return Path(os.fsdecode(value)).suffix.lower() in (".csv", ".tsv", ".txt")
    if not isinstance(value, list):
        return True
    return bool(value) and all(isinstance(row, Mapping) for row in value)
