"""Runs the verbs: the generated functions in `_verbs` call these."""

from __future__ import annotations

import json
import logging
import os
import re
from collections.abc import Mapping
from typing import Any

from . import _native, _survey, _sweep
from ._answers import DesignSheet, DropTest, Explanation, Fit, Motion, Preset, Presets, Reproduction
from ._errors import ModelError, warn
from ._figure import Figure
from ._keywords import Memory, to_fields, to_model, to_models, to_path, with_companions
from ._result import Result, plan
from ._rows import row_names, to_csv, to_rows, to_storage
from .types import Progress, Source

log = logging.getLogger("osim_contact_scale")

__all__ = [
    "assignments", "batch", "design", "drop_test", "explain", "fit", "motion", "plan", "plot", "presets", "reproduce", "survey", "sweep",
]  # fmt: skip

survey = _survey.survey

#: The name of a table without a file.
_TABLE = "table.csv"


def assignments(assignments: Mapping[str, Any]) -> dict[str, Any]:
    """The properties that have a value."""
    return {name: value for name, value in assignments.items() if value is not None}


def design(source: Source | None, keywords: Mapping[str, Any]) -> Any:
    """A plan for a model; without a model, a design sheet."""
    if source is not None:
        return plan("design", source, keywords)
    record, text = _native.calculate(to_fields("design", keywords))
    return DesignSheet(record, text)


def drop_test(subject: Source | None, keywords: Mapping[str, Any]) -> DropTest:
    memory = Memory()
    model = None if subject is None else to_model(subject, memory)
    fields = to_fields("drop-test", with_companions(subject, keywords, memory), memory)
    if model is not None:
        fields["subject"] = model
    record, text, remarks = _native.drop_test(fields, memory)
    for remark in remarks:
        warn(remark.strip().removeprefix("warning: "))
    return DropTest(record, text)


def motion(source: Source, recording: Any, keywords: Mapping[str, Any]) -> Motion:
    memory = Memory()
    keywords = dict(keywords)
    tables = {"motion": recording, "plates": keywords.pop("plates", None)}
    fields = to_fields("motion", with_companions(source, keywords, memory), memory)
    fields["subject"] = to_model(source, memory)
    for field, recording_or_plates in tables.items():
        if isinstance(recording_or_plates, (str, os.PathLike)):
            fields[field] = to_path(recording_or_plates)
        elif recording_or_plates is not None:
            fields[field] = f"{field} table.sto"
            memory[f"{field} table.sto"] = to_storage(recording_or_plates, field)
    record, text, columns = _native.motion(fields, memory)
    return Motion(record, text, columns)


def fit(measured: Any, keywords: Mapping[str, Any]) -> Fit | Result:
    """A contact that fits a curve; with recordings, a plan for a model that fits them."""
    if isinstance(keywords.get("fit"), str):
        keywords = {**keywords, "fit": [keywords["fit"]]}
    if keywords.get("motion") is not None:
        tables: dict[str, bytes] = {}
        tables_by_name = {
            name: _fields_of_recordings(name, keywords[name], tables)
            for name in ("motion", "plates")
            if keywords.get(name) is not None
        }
        return plan("fit", measured, {**keywords, **tables_by_name}, tables)
    memory = Memory()
    fields = to_fields("fit", keywords)
    if isinstance(measured, (str, os.PathLike)):
        fields["file"] = to_model(measured, memory)
    else:
        rows = to_rows(measured)
        memory[_TABLE] = to_csv(rows)
        fields["file"] = _TABLE
    try:
        record, text = _native.fit(fields, memory)
    except ModelError as error:
        if _TABLE not in memory:
            raise
        raise _with_row_names(error, row_names(measured, len(rows))) from None
    return Fit(record, text)


def _with_row_names(error: ModelError, names: list[str]) -> ModelError:
    """An error about a table without a file: it has rows, not lines, and in the table that Rust reads the first row is line 2."""

    def named(match: re.Match[str]) -> str:
        place = int(match[1]) - 2
        return names[place] if 0 <= place < len(names) else match[0]

    message = re.sub(r"\bline (\d+)", named, error.message.replace(f"{_TABLE}: ", "table: ", 1))
    return ModelError(error.code, message, keywords=error.keywords)


def _fields_of_recordings(field: str, recordings: Any, tables: dict[str, bytes]) -> list[Any]:
    """Names of recordings for a request; the data of those that are tables go into `tables`."""
    several = (
        recordings
        if isinstance(recordings, (list, tuple)) and not all(isinstance(row, Mapping) for row in recordings)
        else [recordings]
    )
    names = []
    for number, one in enumerate(several, 1):
        if isinstance(one, (str, os.PathLike)):
            names.append(to_path(one))
        else:
            name = f"{field} table {number}.sto"
            tables[name] = to_storage(one, field)
            names.append(name)
    return names


def plot(kind: str, models: tuple[Source, ...], keywords: Mapping[str, Any]) -> Figure:
    memory = Memory()
    keywords = dict(keywords)
    data = keywords.pop("table", None)
    model_names = to_models(models, memory)
    fields = to_fields("plot", keywords, memory)
    fields.update(kind=kind, output="-", models=model_names)
    if isinstance(data, (str, os.PathLike)):
        fields["table"] = to_model(data, memory)
    elif data is not None:
        memory[_TABLE] = to_csv(to_rows(data))
        fields["table"] = _TABLE
    figure = Figure(_native.plot(fields, memory))
    log.info("%s", figure.remarks.strip())
    return figure


def presets(name: str | None, keywords: Mapping[str, Any]) -> Presets:
    fields = to_fields("presets", {"name": name, **keywords})
    return Presets(Preset(record, text) for record, text in _native.presets(fields))


def explain(topics: tuple[str, ...], keywords: Mapping[str, Any]) -> list[Explanation]:
    """Explains each topic; without topics, every topic."""
    records = _explain_records(topics, keywords)[1]
    if len(topics) == 1 or (topics and len(records) == 1):
        groups = [topics]
    elif topics:
        groups = [(topic,) for topic in topics]
    else:
        groups = [(record.get("label") or record.get("code") or record["name"],) for record in records]
    answers = {words: _explain_records(words, keywords) for words in groups}
    if topics:
        return [Explanation(record, answers[words][0]) for words in groups for record in answers[words][1]]
    return [Explanation(record, answers[words][0]) for words, record in zip(groups, records)]


def _explain_records(topics: tuple[str, ...], keywords: Mapping[str, Any]) -> tuple[str, list[dict[str, Any]]]:
    """The text and the records of these topics."""
    text, lines = _native.explain(to_fields("explain", {"topics": list(topics), **keywords}))
    return text, [json.loads(line) for line in lines.splitlines()]


def reproduce() -> Reproduction:
    return Reproduction(*_native.reproduce())


def sweep(source: Source, keywords: Mapping[str, Any], progress: Progress) -> _sweep.Sweep:
    return _sweep.sweep(source, keywords, progress)


def batch(table: Any, keep: Any, keywords: Mapping[str, Any], progress: Progress) -> Any:
    # Imported here, because most programs do not need it.
    from . import _changes

    return _changes.batch(table, keep, keywords, progress)
