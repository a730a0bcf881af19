"""HTML for notebooks: plain tables, which take the colours of the notebook, light or dark.

All texts are escaped, because names of models come from files. Each part has a limit, so that the cell of a notebook stays small.
"""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import Any

from ._text import printable

#: Most characters of a table or a text as HTML; all parts of a notebook's cell together then stay below 60 kB.
ROOM = 9_000
#: Most characters in the cell of a table.
CELL = 300


def html_table(columns: Sequence[str], rows: Iterable[Sequence[Any]], where: str = "", *, room: int = ROOM) -> str:
    """A table in which every text is escaped, and invisible characters are written as their numbers.

    Rows beyond the limit `room` are only counted; `where` says where the user finds them.
    """
    head = "".join(f"<th scope='col'>{html.escape(column)}</th>" for column in columns)
    html_rows: list[str] = []
    left_out = used = 0
    for row in rows:
        cells = "" if left_out else "".join(f"<td>{_html_cell(value)}</td>" for value in row)
        used += len(cells)
        if left_out or (used > room and html_rows):
            left_out += 1
        else:
            html_rows.append(f"<tr>{cells}</tr>")
    table = f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(html_rows)}</tbody></table>"
    return table + (_more_rows(left_out, where) if left_out else "")


def _more_rows(count: int, where: str) -> str:
    return paragraph(f"… and {count} more" + (f": {where}" if where else ""))


def _html_cell(value: Any) -> str:
    return "" if value is None else escaped(f"{value:.8g}" if isinstance(value, float) else value)


def escaped(value: Any, length: int = CELL) -> str:
    """A text as HTML, shortened to this length."""
    text = printable(str(value))
    return html.escape(text if len(text) <= length else f"{text[: length - 1]}…")


def paragraph(text: str) -> str:
    """A line of text."""
    return f"<p>{escaped(text, 2 * CELL)}</p>"


def heading(text: str) -> str:
    """A bold line above a table."""
    return f"<p><b>{escaped(text)}</b></p>"


def preformatted(text: str, where: str, *, room: int = 5 * ROOM) -> str:
    """A text with its line breaks, up to the limit `room`; `where` says where the user finds the rest."""
    lines = text.splitlines()
    html_lines, used = [], 0
    for line in lines:
        html_line = escaped(line, 4 * CELL)
        used += len(html_line) + 1
        if used > room:
            break
        html_lines.append(html_line)
    left_out = len(lines) - len(html_lines)
    more = paragraph(f"… and {left_out} lines more: {where}") if left_out else ""
    return f"<pre>{chr(10).join(html_lines)}</pre>{more}"
