"""Makes texts of files and users safe for a terminal."""

#: Most characters of one line of a message. A wrong argument may be a whole model.
MAX_LENGTH = 600

_SHORT = {"\n": r"\n", "\r": r"\r", "\t": r"\t"}


def printable(text: str) -> str:
    """The text with control characters and invisible characters written as their numbers."""
    return "".join(letter if letter.isprintable() else _escaped_letter(letter) for letter in text)


def clipped(text: str, max_length: int = MAX_LENGTH) -> str:
    """The text; if it is long, its beginning, its length and its end."""
    if len(text) <= max_length:
        return text
    left_out = f" ... ({len(text)} letters in all) ... "
    end = max_length // 4
    return text[: max_length - end - len(left_out)] + left_out + text[-end:]


def _escaped_letter(letter: str) -> str:
    return _SHORT.get(letter, f"\\u{{{ord(letter):x}}}")
