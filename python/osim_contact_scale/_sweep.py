"""Makes variants of one model."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _native
from ._cells import from_cell
from ._frames import to_frame
from ._html import heading, html_table
from ._keywords import is_path, to_fields, to_path
from ._named_values import NamedValues, repr_line
from ._progress import progress_callback
from ._tables import table
from ._threads import thread_count
from .types import Progress, Source, Table

if TYPE_CHECKING:
    import pandas as pd

log = logging.getLogger("osim_contact_scale")


def sweep(source: Source, keywords: Mapping[str, Any], progress: Progress) -> Sweep:
    """Makes variants of one model, and a table that says what each file contains.

    Raises
    ------
    ContactScaleError
        The call is wrong. `failures` has the variants that cannot be made.
    """
    if not is_path(source):
        raise TypeError("a sweep makes files beside a file: name the file of a model")
    fields = to_fields("sweep", {**keywords, "jobs": thread_count(keywords.get("jobs"))})
    fields["model"] = to_path(source)
    with progress_callback(progress, "sweep") as callback:
        record, manifest, failures = _native.sweep(fields, callback)
    for failure in failures:
        log.error("%s: %s", failure["model"], failure["error"]["message"])
    return Sweep(record, manifest, failures)


class Sweep(NamedValues):
    """Variants of a model in a folder.

    Attributes
    ----------
    record : dict
        The number of variants, and more, as in the command's JSON.
    manifest : pathlib.Path or None
        The table that says what each file contains; None if nothing was made.
    failures : list of dict
        The error of each variant that could not be made.
    """

    __slots__ = ("failures", "manifest", "record")

    def __init__(self, record: dict[str, Any], manifest: Path | None, failures: list[dict[str, Any]]) -> None:
        self.record = record
        # An absolute path stays valid if the program changes its current folder.
        self.manifest = None if manifest is None else Path(os.path.abspath(manifest))
        self.failures = failures

    @property
    def folder(self) -> Path | None:
        """The folder of the variants."""
        return None if self.manifest is None else self.manifest.parent

    @property
    def table(self) -> Table:
        """A row for each variant; the column `path` has the path of its file."""
        return table(*self._rows())

    def _rows(self) -> tuple[list[dict[str, Any]], list[str]]:
        """The rows of the table, and its columns."""
        import csv

        if self.manifest is None:
            return [], ["file", "path"]
        with open(self.manifest, newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            columns = list(reader.fieldnames or ())
            rows: list[dict[str, Any]] = [
                {name: number_or_text(from_cell(text)) for name, text in row.items()} for row in reader
            ]
        for row in rows:
            row["index"] = int(row["index"])
            row["path"] = str(self.manifest.parent / str(row["file"]))
        return rows, [*columns, "path"]

    def frame(self) -> pd.DataFrame:
        """The table, always as a DataFrame: a row for each variant; units are in `attrs["units"]`.

        Examples
        --------
        >>> ocs.sweep("human.osim", grid={"stiffness": "x0.1..x10/3"}).frame()["path"]
        """
        return to_frame(lambda: self.table)

    def _values(self) -> Mapping[str, Any]:
        return self.record

    def __len__(self) -> int:
        count: int = self.record["models"]
        return count

    def __repr__(self) -> str:
        return repr_line("Sweep", self._summary())

    def _summary(self) -> str:
        failed = f", {len(self.failures)} failed" if self.failures else ""
        return f"{len(self)} models in {self.folder}{failed}"

    def _repr_html_(self) -> str:
        rows, columns = self._rows()
        # The absolute paths are long and differ only in the name of the file.
        shown_columns = [column for column in columns if column != "path"]
        cells = ([row[column] for column in shown_columns] for row in rows)
        return heading(f"sweep: {self._summary()}") + html_table(shown_columns, cells, ".table has all")


def number_or_text(text: str) -> Any:
    """A cell as a number, or as a text if it is not a number; None if it is empty."""
    if not text:
        return None
    try:
        return float(text)
    except ValueError:
        return text
