"""The text of an error that a task raised: its message, and the line of the user's code that it came from."""

from __future__ import annotations

import os
import re
import traceback
from types import FrameType

from .._text import clipped, printable
from ._source import installed_folders

#: Most characters of a message that are searched: a message may have millions.
_MAX_LENGTH = 20_000

#: Names in place of a file: prompts and cells of a notebook.
_PROMPTS = ("<stdin>", "<ipython-input", "<python-input", "<doctest")

#: The file name that cloudpickle gives to all code that it sends.
_CLOUDPICKLE_FILE = "<dynamic-code>"

#: Parts of a message in which OpenSim, Simbody and SWIG name their own source.
_OPENSIM_NOISE = re.compile(
    r"\A(?:std::exception in '.*?': )+"
    r"|SimTK Exception thrown at \S+:\d+:\s*"
    r"|\n[ \t]*Thrown at \S+:\d+ in [^\n]*?\)\.(?=\)|\s|\Z)"
    r"|\n[ \t]*\(Required condition '[^\n]*' was not met\.\)"
    r"|\n[ \t]*(?:Additional information:\s*\n|Possible C/C\+\+ prototypes are:)[\s\S]*\Z"
)


def describe_error(error: BaseException, folder: str | None = None) -> str:
    """The text of an error with its place in the task. It does not depend on the folder of the job."""
    text = _kind_and_message(error)
    for name in (os.path.realpath(folder), folder) if folder else ():
        text = text.replace(name, ".")
    return clipped(printable(text)) + _place_of_error(error)


def _kind_and_message(error: BaseException) -> str:
    kind = type(error).__name__
    try:
        message = _in_one_line(str(error))
    except Exception:
        # If an exception of yours cannot be converted to text, only its type is shown.
        message = ""
    return f"{kind}: {message}" if message else kind


def _in_one_line(message: str) -> str:
    """A message as one line, without the parts about OpenSim's source."""
    text = message if len(message) <= _MAX_LENGTH else clipped(message, _MAX_LENGTH)
    lines = _OPENSIM_NOISE.sub("", text).splitlines()
    return " ".join(line.strip() for line in lines if line.strip())


def _place_of_error(error: BaseException) -> str:
    """The innermost line of your code that led to the error; empty if there is none, as in a task of this package."""
    places = [
        (_frame_file(frame), line, frame.f_code.co_name) for frame, line in traceback.walk_tb(error.__traceback__)
    ]
    yours = [place for place in places if _is_user_code(place[0])]
    if not yours:
        return ""
    file, line, name = yours[-1]
    file_text = "" if _is_typed_code(file) else f"{printable(os.path.basename(file))}, "
    return f" ({file_text}line {line}, in {printable(name)})"


def _frame_file(frame: FrameType) -> str:
    """The file of a frame. Code that cloudpickle sent does not name its file, but its globals do."""
    file = frame.f_code.co_filename
    return str(frame.f_globals.get("__file__") or _PROMPTS[0]) if file == _CLOUDPICKLE_FILE else file


def _is_user_code(file: str) -> bool:
    if file.startswith("<"):
        return file.startswith(_PROMPTS)
    return not os.path.realpath(file).startswith(installed_folders())


def _is_typed_code(file: str) -> bool:
    # Notebooks give the files of their cells new numbers each time.
    return file.startswith("<") or os.path.basename(os.path.dirname(file)).startswith("ipykernel_")
