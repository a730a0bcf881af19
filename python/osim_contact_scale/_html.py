"""What a notebook shows."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import Any

from ._text import printable


def html_table(columns: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """A table in which every text is escaped, and characters that are not seen are shown by their numbers."""
    head = "".join(f"<th scope='col'>{html.escape(column)}</th>" for column in columns)
    cells = ("".join(f"<td>{_cell(value)}</td>" for value in row) for row in rows)
    body = "".join(f"<tr>{row}</tr>" for row in cells)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _cell(value: Any) -> str:
    return "" if value is None else html.escape(printable(str(value)))


def framed(page: str, title: str) -> str:
    """A whole page in a frame of its own, so that its style and that of the notebook leave each other alone."""
    name, source = html.escape(title, quote=True), html.escape(page, quote=True)
    style = "width:100%;height:32em;border:1px solid #8888"
    return f'<iframe title="{name}" sandbox srcdoc="{source}" style="{style}"></iframe>'
