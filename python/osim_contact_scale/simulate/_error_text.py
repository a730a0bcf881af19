"""What the row of a model says where its task raised an error: the message, and the line of yours that it came from."""

from __future__ import annotations

import os
import re
import traceback
from types import FrameType

from .._text import clipped, printable
from ._source import installed_folders

#: Letters of an error that are looked at: a message may have millions.
_MAX_LENGTH = 20_000

#: Where there is no file: prompts and cells of a notebook.
_PROMPTS = ("<stdin>", "<ipython-input", "<python-input", "<doctest")

#: How cloudpickle names the file of all code that it sends.
_CLOUDPICKLE_FILE = "<dynamic-code>"

#: What OpenSim, Simbody and SWIG say of themselves around what is wrong.
_OPENSIM_NOISE = re.compile(
    r"\A(?:std::exception in '.*?': )+"
    r"|SimTK Exception thrown at \S+:\d+:\s*"
    r"|\n[ \t]*Thrown at \S+:\d+ in [^\n]*?\)\.(?=\)|\s|\Z)"
    r"|\n[ \t]*\(Required condition '[^\n]*' was not met\.\)"
    r"|\n[ \t]*(?:Additional information:\s*\n|Possible C/C\+\+ prototypes are:)[\s\S]*\Z"
)


def describe_error(error: BaseException, folder: str | None = None) -> str:
    """An error with its place in the task: the same text in whatever folder it happened."""
    text = _kind_and_message(error)
    for name in (os.path.realpath(folder), folder) if folder else ():
        text = text.replace(name, ".")
    return clipped(printable(text)) + _place(error)


def _kind_and_message(error: BaseException) -> str:
    kind = type(error).__name__
    try:
        message = _in_one_line(str(error))
    except Exception:
        # An exception of yours that cannot be shown is shown by its kind.
        message = ""
    return f"{kind}: {message}" if message else kind


def _in_one_line(message: str) -> str:
    """The lines of a message as one, without those that are about OpenSim's own source."""
    text = message if len(message) <= _MAX_LENGTH else clipped(message, _MAX_LENGTH)
    lines = _OPENSIM_NOISE.sub("", text).splitlines()
    return " ".join(line.strip() for line in lines if line.strip())


def _place(error: BaseException) -> str:
    """The innermost line of yours that led to the error; nothing where there is none, as in a task of this package."""
    places = [
        (_frame_file(frame), line, frame.f_code.co_name) for frame, line in traceback.walk_tb(error.__traceback__)
    ]
    yours = [place for place in places if _is_yours(place[0])]
    if not yours:
        return ""
    file, line, name = yours[-1]
    file_text = "" if _is_prompt(file) else f"{printable(os.path.basename(file))}, "
    return f" ({file_text}line {line}, in {printable(name)})"


def _frame_file(frame: FrameType) -> str:
    """The file of a line. Code that travelled has no name of one, but its globals have."""
    file = frame.f_code.co_filename
    return str(frame.f_globals.get("__file__") or _PROMPTS[0]) if file == _CLOUDPICKLE_FILE else file


def _is_yours(file: str) -> bool:
    if file.startswith("<"):
        return file.startswith(_PROMPTS)
    return not os.path.realpath(file).startswith(installed_folders())


def _is_prompt(file: str) -> bool:
    # The names that notebooks give to files of their cells are numbers, other ones each time.
    return file.startswith("<") or os.path.basename(os.path.dirname(file)).startswith("ipykernel_")
