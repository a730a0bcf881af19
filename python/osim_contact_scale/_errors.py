"""What can go wrong, as exceptions."""

from __future__ import annotations

from typing import Any

from ._text import clipped, printable


class ContactScaleError(Exception):
    """Something could not be done; nothing was changed by it.

    Attributes
    ----------
    code : str
        Stable short name, which `explain` explains; `usage`, and of simulations `simulation` and `workers-lost`, have their messages alone.
    message : str
        What is wrong, what was expected, and a way out. Of what is long in it, such as the text of a whole model, the middle is left out.
    path : str or None
        The file, as it was named.
    line, column : int or None
        The place in that file, from 1.
    excerpt : str or None
        The line of the file.
    keywords : tuple of str
        Keywords that the message names, in its order.
    """

    def __init__(
        self,
        code: str,
        message: str,
        *,
        path: str | None = None,
        line: int | None = None,
        column: int | None = None,
        excerpt: str | None = None,
        keywords: Any = (),
    ) -> None:
        name = "" if path is None else printable(path)
        # A message about a file that it names itself does not name it twice.
        is_named = bool(name) and message.startswith(name)
        # Line by line: wrong rows of a table have one each.
        message = "\n".join(map(clipped, message.split("\n")))
        position = "" if line is None or column is None else f":{line}:{column}"
        text = message if is_named or not name else f"{clipped(name)}{position}: {message}"
        excerpt_text = "" if excerpt is None else f"\n{line or '':>6} | {clipped(printable(excerpt.expandtabs(2)))}"
        super().__init__(text + excerpt_text)
        self.code = code
        self.message = message
        self.path = path
        self.line = line
        self.column = column
        self.excerpt = excerpt
        self.keywords = tuple(keywords)

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (type(self), self.code, self.message, self.__dict__)


def _unpickled(kind: type[ContactScaleError], code: str, message: str, state: dict[str, Any]) -> ContactScaleError:
    names = ("path", "line", "column", "excerpt", "keywords")
    return kind(code, message, **{name: state[name] for name in names})


class ModelError(ContactScaleError):
    """A model, or a file that it needs, cannot be used."""


class NeedsAnswer(ContactScaleError):
    """A keyword is missing that must not be guessed.

    `keywords` names it: pass the first of them, or one of the others.
    """

    @property
    def keyword(self) -> str | None:
        """The keyword that answers, where the message names one."""
        return self.keywords[0] if self.keywords else None


class RequestError(ContactScaleError, ValueError):
    """The call itself is wrong: a value, or keywords that do not go together."""

    @property
    def keyword(self) -> str | None:
        """The keyword that is wrong, where it is one."""
        return self.keywords[0] if self.keywords else None


class OutputError(ContactScaleError):
    """A file cannot be written: something is there, the folder is read-only, the disk is full. No file is half written."""
