"""Texts from outside, such as names of files, where a terminal may show them."""

#: Letters of one line of a message. What somebody gave may be a whole model.
MAX_LENGTH = 600

_SHORT = {"\n": r"\n", "\r": r"\r", "\t": r"\t"}


def printable(text: str) -> str:
    """The text with numbers in place of characters that a terminal would obey, or that cannot be seen: as messages have them."""
    return "".join(letter if letter.isprintable() else _escape(letter) for letter in text)


def clipped(text: str, max_length: int = MAX_LENGTH) -> str:
    """The text, or of a long one its beginning and its end, and how long it is."""
    if len(text) <= max_length:
        return text
    left_out = f" ... ({len(text)} letters in all) ... "
    end = max_length // 4
    return text[: max_length - end - len(left_out)] + left_out + text[-end:]


def _escape(letter: str) -> str:
    return _SHORT.get(letter, f"\\u{{{ord(letter):x}}}")
