"""Texts in cells of CSV, as the Rust half writes and reads them."""

from __future__ import annotations

import re
import unicodedata

#: The beginning of a character that is written as its number.
_ESCAPE = "\\u{"
#: A number as Rust reads it.
_RUST_NUMBER = re.compile(r"[+-]?(\d+\.?\d*(e[+-]?\d+)?|\.\d+(e[+-]?\d+)?|inf|infinity|nan)", re.ASCII | re.IGNORECASE)


def to_cell(text: str) -> str:
    """A text as a cell of CSV, by the rule of `cell` in crates/osim-planning/src/sheet.rs.

    Control characters are written as their numbers, and a text that a spreadsheet would run as a formula gets an apostrophe before it.
    """
    if text.isprintable() and _ESCAPE not in text:
        return _with_apostrophe(text)
    pieces = []
    for at, letter in enumerate(text):
        escaped = is_control_character(letter) or text.startswith(_ESCAPE, at)
        pieces.append(f"{_ESCAPE}{ord(letter):x}}}" if escaped else letter)
    return _with_apostrophe("".join(pieces))


def _with_apostrophe(text: str) -> str:
    return f"'{text}" if _is_formula(text) and not _RUST_NUMBER.fullmatch(text) else text


def from_cell(cell: str) -> str:
    """The text of a cell that the program wrote, by the rule of `from_cell` in crates/osim-planning/src/sheet.rs."""
    text = cell[1:] if cell.startswith("'") and _is_formula(cell[1:]) else cell
    return re.sub(r"\\u\{(\+?[0-9a-fA-F]+)\}", _letter_of_escape, text)


def _letter_of_escape(escape: re.Match[str]) -> str:
    number = int(escape[1], 16)
    if number > 0x10FFFF or 0xD800 <= number < 0xE000:
        return escape[0]
    letter = chr(number)
    return letter if letter == "\\" or not letter.isprintable() else escape[0]


def _is_formula(text: str) -> bool:
    return text.lstrip("'").startswith(("=", "+", "-", "@", "\t", "\r", "\n"))


def is_control_character(letter: str) -> bool:
    """Whether a character controls a terminal or the direction of a text."""
    return unicodedata.category(letter) == "Cc" or "\u2028" <= letter <= "\u202e" or "\u2066" <= letter <= "\u2069"
