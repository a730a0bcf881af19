"""Variants of one model."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import _native
from ._cells import from_cell
from ._progress import Progress, following
from ._request import Source, fields_of, is_path, path_of
from ._tables import table
from ._text import printable
from ._threads import jobs_of

log = logging.getLogger("osim_contact_scale")


def sweep(source: Source, keywords: Mapping[str, Any], progress: Progress) -> Any:
    """Makes variants of one model: a row for each, which says what is in which file.

    Raises
    ------
    ContactScaleError
        The call is wrong. Variants that cannot be made are in `failures`.
    """
    if not is_path(source):
        raise TypeError("a sweep makes files beside a file: name the file of a model")
    fields = fields_of("sweep", {**keywords, "jobs": jobs_of(keywords.get("jobs"))})
    fields["model"] = path_of(source)
    with following(progress, "sweep") as callback:
        record, manifest, failures = _native.sweep(fields, callback)
    for failure in failures:
        log.error("%s: %s", failure["model"], failure["error"]["message"])
    return Sweep(record, manifest, failures)


class Sweep:
    """Variants of a model in a folder.

    Attributes
    ----------
    record : dict
        How many there are, as the command's JSON has it.
    manifest : pathlib.Path or None
        The table of what is in which file; None if nothing was made.
    failures : list of dict
        What went wrong, for each variant that could not be made.
    """

    def __init__(self, record: dict[str, Any], manifest: Path | None, failures: list[dict[str, Any]]) -> None:
        self.record = record
        # A whole path, which stays right when the program goes to another folder.
        self.manifest = None if manifest is None else Path(os.path.abspath(manifest))
        self.failures = failures

    @property
    def folder(self) -> Path | None:
        """The folder of the variants."""
        return None if self.manifest is None else self.manifest.parent

    @property
    def table(self) -> Any:
        """A row for each variant, with the path of its file under `path`."""
        import csv

        if self.manifest is None:
            return table([], ("file", "path"))
        with open(self.manifest, newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            columns = list(reader.fieldnames or ())
            rows: list[dict[str, Any]] = [
                {name: number(from_cell(text)) for name, text in row.items()} for row in reader
            ]
        for row in rows:
            row["index"] = int(row["index"])
            row["path"] = str(self.manifest.parent / str(row["file"]))
        return table(rows, [*columns, "path"])

    def __len__(self) -> int:
        made: int = self.record["models"]
        return made

    def __repr__(self) -> str:
        return f"<Sweep of {len(self)} models in {printable(str(self.folder))}>"


def number(text: str) -> Any:
    """A cell as a number where it is one; None where it is empty."""
    if not text:
        return None
    try:
        return float(text)
    except ValueError:
        return text
