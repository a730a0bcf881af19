"""Texts from outside, such as names of files, where a terminal may show them."""

_SHORT = {"\n": r"\n", "\r": r"\r", "\t": r"\t"}


def printable(text: str) -> str:
    """The text with numbers in place of characters that a terminal would obey, or that cannot be seen: as messages have them."""
    return "".join(letter if letter.isprintable() else _number(letter) for letter in text)


def _number(letter: str) -> str:
    return _SHORT.get(letter, f"\\u{{{ord(letter):x}}}")
