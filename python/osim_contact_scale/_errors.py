"""The exceptions of this package."""

from __future__ import annotations

import errno
import os
import sys
import warnings
from typing import Any

from ._text import clipped, printable


class ContactScaleWarning(UserWarning):
    """Something about a call or its result that should be looked at."""


def warn(message: str) -> None:
    """Gives a warning at the line of the caller's program that called this package."""
    package = os.path.dirname(__file__)
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == package:
        frame, level = frame.f_back, level + 1
    warnings.warn(message, ContactScaleWarning, stacklevel=level)


class ContactScaleError(Exception):
    """A call failed; it changed nothing.

    Attributes
    ----------
    code : str
        Stable short name, which `explain` explains. Only `usage`, `simulation` and `workers-lost` have no explanation beside their message.
    message : str
        What is wrong, what was expected, and a way out. Long parts, such as the text of a whole model, are shortened in the middle.
    path : str or None
        The file, as the caller named it.
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
        # A message that begins with the name of the file does not get the name again.
        is_named = bool(name) and message.startswith(name)
        # Each line is shortened by itself: a message about a table has a line for each wrong row.
        message = "\n".join(map(clipped, message.split("\n")))
        position = "" if line is None or column is None else f":{line}:{column}"
        text = message if is_named or not name else f"{clipped(name)}{position}: {message}"
        excerpt_text = "" if excerpt is None else f"\n{line or '':>6} | {clipped(printable(excerpt.expandtabs(2)))}"
        super().__init__()
        # Not by the constructor, which OSError leaves to `__new__`.
        self.args = (text + excerpt_text,)
        self.code = code
        self.message = message
        self.path = path
        self.line = line
        self.column = column
        self.excerpt = excerpt
        self.keywords = tuple(keywords)

    # That of Python's OSError is about its number.
    __str__ = Exception.__str__

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (type(self), self.code, self.message, self.__dict__)


def _unpickled(kind: type[ContactScaleError], code: str, message: str, state: dict[str, Any]) -> ContactScaleError:
    names = ("path", "line", "column", "excerpt", "keywords")
    return kind(code, message, **{name: state[name] for name in names})


class ModelError(ContactScaleError):
    """A model, or a file that it needs, cannot be used. If the file is missing, this is a `FileNotFoundError`, too."""

    def __new__(cls, code: str, message: str, **details: Any) -> ModelError:
        is_missing = cls is ModelError and "there is no such file" in message
        kind = MissingFile if is_missing else cls
        return super(ModelError, kind).__new__(kind)


class MissingFile(ModelError, FileNotFoundError):
    def __init__(self, code: str, message: str, **details: Any) -> None:
        super().__init__(code, message, **details)
        self.errno, self.filename = errno.ENOENT, self.path


class NeedsAnswer(ContactScaleError):
    """A keyword is missing, and this package must not guess its value.

    `keywords` names the keywords that answer: pass the first, or one of the others.
    """

    @property
    def keyword(self) -> str | None:
        """The keyword that answers, if the message names one."""
        return self.keywords[0] if self.keywords else None


class RequestError(ContactScaleError, ValueError):
    """The call itself is wrong: a value, or keywords that cannot be used together."""

    @property
    def keyword(self) -> str | None:
        """The keyword that is wrong, if the message names one."""
        return self.keywords[0] if self.keywords else None


class OutputError(ContactScaleError):
    """A file cannot be written: the folder is read-only, the disk is full, or it exists already. No file is half written.

    If it exists already, this is a `FileExistsError`, too.
    """

    def __new__(cls, code: str, message: str, **details: Any) -> OutputError:
        exists = cls is OutputError and " exists already" in message
        kind = ExistingFile if exists else cls
        return super(OutputError, kind).__new__(kind)


class ExistingFile(OutputError, FileExistsError):
    def __init__(self, code: str, message: str, **details: Any) -> None:
        super().__init__(code, message, **details)
        self.errno = errno.EEXIST
