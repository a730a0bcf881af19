"""Makes the fields of a request from keywords."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping, Sequence
from keyword import iskeyword
from pathlib import Path, PurePath
from typing import Any, BinaryIO, TypeGuard

from . import _live
from ._errors import ModelError, RequestError
from ._option_names import PATHS
from ._text import printable
from .types import Source

#: The name of a model without a file.
UNNAMED = "model.osim"

#: Keywords whose values are models.
MODELS = ("from", "geometry", "model", "compare")

#: The length of the longest path on Windows; no other system has longer ones.
LONGEST_PATH = 32_767


class Memory(dict[str, bytes]):
    """Models that are in no file, by their names in a request.

    A result has the name of the model that it was made from. If that file is in the same request, one of the two gets another name:
    otherwise both would be read from memory, and a model would be compared with itself.
    """

    def __init__(self) -> None:
        super().__init__()
        self.files: set[PurePath] = set()


def to_fields(verb: str, keywords: Mapping[str, Any], memory: Memory | None = None) -> dict[str, Any]:
    """The fields of a request for `verb`. Keywords that are None are left out.

    Raises
    ------
    RequestError
        A request cannot hold a value, such as NaN.
    """
    fields: dict[str, Any] = {"verb": verb}
    for keyword, value in keywords.items():
        name = keyword.rstrip("_")
        if value is not None and memory is not None and name in MODELS:
            fields[name] = to_model(value, memory)
        elif isinstance(value, str) and name in PATHS:  # `~` is the home folder.
            fields[name] = to_path(value)
        elif value is not None:
            # Messages have the keyword of the caller: `class_` for the field `class`.
            fields[name] = _plain_value(value, f"{name}_" if iskeyword(name) else name)
    return fields


def to_path(path: Any) -> Any:
    """The path of a file for a request; `~` is the home folder.

    Raises
    ------
    TypeError
        It is neither a text nor a path.
    """
    path = expand_home(path)
    try:
        path.encode("utf-8")
    except UnicodeEncodeError:
        try:
            return {"bytes": list(os.fsencode(path))}
        except UnicodeEncodeError as error:
            message = f"{path!a}: no file has such a name: it has half of a letter in it"
            raise RequestError("usage", message) from error
    return path


def expand_home(path: str | bytes | os.PathLike[str] | os.PathLike[bytes]) -> str:
    """A path as text, with the home folder for `~`.

    Raises
    ------
    RequestError
        It is the text of a model, or begins with `~` and a user whom this computer does not know.
    TypeError
        It is neither a text nor a path.
    """
    text = os.fsdecode(path)
    _refuse_content(text)
    expanded = os.path.expanduser(text)
    user = re.match(r"~[^/\\]+", expanded)
    if user is not None and user[0] != expanded and not os.path.isdir(user[0]):
        message = f"{printable(expanded)}: there is no user {printable(user[0][1:])} here; if it is a folder, write ./{printable(expanded)}"
        raise RequestError("usage", message)
    return expanded


def _refuse_content(text: str) -> None:
    """Refuses the content of a file in place of its path. The message does not repeat the content, which may be long."""
    if re.match(r"[\ufeff\s]*<[^>]*>", text):
        raise RequestError("usage", "this is the text of a model: give its path, or bytes")
    if len(text) > LONGEST_PATH:
        raise RequestError("usage", f"a text of {len(text)} characters is no path: give the path of a file, or bytes")


def to_models(sources: Sequence[Source], memory: Memory) -> list[Any]:
    """Names of several models in a request. Files and folders keep their names."""
    names = {index: to_model(source, memory) for index, source in enumerate(sources) if is_path(source)}
    return [names[index] if index in names else to_model(source, memory) for index, source in enumerate(sources)]


def is_path(source: Any) -> TypeGuard[str | os.PathLike[str]]:
    """Whether a value is the path of a file or folder."""
    return isinstance(source, (str, os.PathLike))


def is_file_object(source: Any) -> TypeGuard[BinaryIO]:
    """Whether a value is an open file, or one in memory."""
    return hasattr(source, "read") and hasattr(source, "readlines")


def to_model(source: Source, memory: Memory) -> Any:
    """The name of a model in a request. A model that is in no file goes into `memory` under that name.

    Raises
    ------
    TypeError
        It is not a model.
    """
    if isinstance(source, (bytes, bytearray, memoryview)):
        return _remember_bytes(UNNAMED, bytes(source), memory)
    if hasattr(source, "to_bytes") and hasattr(source, "path"):  # A result is used as its new model.
        return _remember_bytes(source.path, source.to_bytes(), memory)
    if is_path(source):
        if os.fspath(source) == "-":
            message = "a Python program has no model on its standard input: give a path, bytes or an opensim.Model"
            raise RequestError("usage", message)
        return _file_name(to_path(source), memory)
    if is_file_object(source):
        data, name = source.read(), getattr(source, "name", None)
        if not isinstance(data, bytes):
            kind = type(source).__name__
            raise TypeError(f'a {kind} reads text: open the model as bytes, open(path, "rb"), or give its path')
        return _remember_bytes(name if isinstance(name, str) else UNNAMED, data, memory)
    if _live.is_model(source):
        name, data = _live.to_bytes(source)
        return _remember_bytes(name or UNNAMED, data, memory)
    raise TypeError(
        f"expected the path of a model, its bytes, a Result or an opensim.Model, not {type(source).__name__}"
    )


def with_companions(source: Source | None, keywords: Mapping[str, Any], memory: Memory) -> dict[str, Any]:
    """The keywords of a call about `source`, with the other files of its model if it is the result of a standalone ForceSet.

    The new geometry of the result is used even if the caller names the old file.
    """
    keywords = dict(keywords)
    companions = getattr(source, "_companions", None)
    for name, (path, data) in (companions() if companions is not None else {}).items():
        keyword_value = keywords.get(name)
        if keyword_value is None or (is_path(keyword_value) and PurePath(expand_home(keyword_value)) == PurePath(path)):
            keywords[name] = InMemory(path, data)
    return keywords


class InMemory:
    """A model or another file in memory, with the name of its file."""

    def __init__(self, path: str, data: bytes) -> None:
        self.path = path
        self._data = data

    def to_bytes(self) -> bytes:
        return self._data


def _file_name(path: Any, memory: Memory) -> Any:
    """The name of a file in a request: another name if a model in memory has its name already."""
    if not isinstance(path, str):
        return path
    if PurePath(path) in map(PurePath, memory):
        try:
            return _remember_bytes(path, Path(path).read_bytes(), memory)
        except OSError as error:
            raise ModelError("unreadable", f"cannot be read: {error.strerror}", path=path) from error
    memory.files.add(PurePath(path))
    return path


def _remember_bytes(name: str, data: bytes, memory: Memory) -> str:
    """Puts `data` into memory under a name that no other model, file or file of a folder in the request has."""

    def is_taken(name: str) -> bool:
        folders = memory.files.intersection(PurePath(name).parents)
        is_file = PurePath(name) in memory.files or bool(folders and os.path.exists(name))
        return is_file or (name in memory and memory[name] != data)

    base, count = name, 1
    while is_taken(name):
        count += 1
        root, ending = os.path.splitext(base)
        name = f"{root}-{count}{ending}"
    memory[name] = data
    return name


def _plain_value(value: Any, keyword: str) -> Any:
    """A value as plain Python types, as in JSON."""
    if isinstance(value, os.PathLike):
        return to_path(value)
    if isinstance(value, str):
        return value
    if isinstance(value, Mapping):
        # Each property of `set` is a keyword in Python.
        return {str(key): _plain_value(item, str(key) if keyword == "set" else keyword) for key, item in value.items()}
    if hasattr(value, "tolist"):  # NumPy's numbers and arrays, and pandas' columns.
        item = value.tolist()
        if item is None:
            message = f"{keyword}: the value is missing (masked, or None in an array): leave the keyword out where nothing is known"
            raise RequestError("usage", message, keywords=(keyword,))
        # `tolist` of a number with more digits than a float returns that number itself.
        return _plain_value(float(item) if type(item) is type(value) else item, keyword)
    if isinstance(value, (list, tuple, set, frozenset)):
        return [_plain_value(item, keyword) for item in value]
    if isinstance(value, bool) or value is None:
        return value
    if isinstance(value, int):
        return value
    if isinstance(value, float):
        if not math.isfinite(value):
            message = f"{keyword}={value}: expected a finite number"
            raise RequestError("usage", message, keywords=(keyword,))
        return value
    raise TypeError(f"{keyword}: expected a number, a text or a list of those, not {type(value).__name__}")
