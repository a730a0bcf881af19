"""From keywords to the fields of a request."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Mapping, Sequence
from keyword import iskeyword
from pathlib import Path, PurePath
from typing import Any, TypeGuard

from . import _live
from ._errors import ModelError, RequestError
from ._options import PATHS
from ._text import printable
from .types import Source

#: How a model is called that has no file.
UNNAMED = "model.osim"

#: Keywords that are models, too.
MODELS = ("from", "geometry", "model", "compare")

#: No system has longer paths than Windows.
LONGEST_PATH = 32_767


class Memory(dict[str, bytes]):
    """Models without a file of their own, by the names that they have in a request.

    A result has the name of the model that it was made from. Where that file is in the same request, one of the two gets another
    name: else both would be read from memory, and a model would be compared with itself.
    """

    def __init__(self) -> None:
        super().__init__()
        self.files: set[PurePath] = set()


def fields_of(verb: str, keywords: Mapping[str, Any], memory: Memory | None = None) -> dict[str, Any]:
    """The fields of a request for `verb`. Keywords that are None are left out.

    Raises
    ------
    RequestError
        A value that no request can hold, such as NaN.
    """
    fields: dict[str, Any] = {"verb": verb}
    for keyword, value in keywords.items():
        name = keyword.rstrip("_")
        if value is not None and memory is not None and name in MODELS:
            fields[name] = model_of(value, memory)
        elif isinstance(value, str) and name in PATHS:  # `~` is the home folder.
            fields[name] = path_of(value)
        elif value is not None:
            # Messages name what the caller wrote: `class_`, where the field is `class`.
            fields[name] = _plain(value, f"{name}_" if iskeyword(name) else name)
    return fields


def path_of(path: Any) -> Any:
    """A name of a file as a request has it; `~` is the home folder.

    Raises
    ------
    TypeError
        Neither a text nor a path.
    """
    path = at_home(path)
    try:
        path.encode("utf-8")
    except UnicodeEncodeError:
        try:
            return {"bytes": list(os.fsencode(path))}
        except UnicodeEncodeError as error:
            message = f"{path!a}: no file has such a name: it has half of a letter in it"
            raise RequestError("usage", message) from error
    return path


def at_home(path: str | bytes | os.PathLike[str] | os.PathLike[bytes]) -> str:
    """A path as text, with the home folder for `~`.

    Raises
    ------
    RequestError
        The text of a model, or `~` of a user whom this computer does not know: as the name of a folder it is hardly meant.
    TypeError
        Neither a text nor a path.
    """
    text = os.fsdecode(path)
    _refuse_content(text)
    whole = os.path.expanduser(text)
    user = re.match(r"~[^/\\]+", whole)
    if user is not None and user[0] != whole and not os.path.isdir(user[0]):
        message = f"{printable(whole)}: there is no user {printable(user[0][1:])} here; if it is a folder, write ./{printable(whole)}"
        raise RequestError("usage", message)
    return whole


def _refuse_content(text: str) -> None:
    """Refuses what is in a file in place of its path. The message does not repeat it: it may be long."""
    if re.match(r"[\ufeff\s]*<[^>]*>", text):
        raise RequestError("usage", "this is the text of a model: give its path, or bytes")
    if len(text) > LONGEST_PATH:
        raise RequestError("usage", f"a text of {len(text)} characters is no path: give the path of a file, or bytes")


def models_of(sources: Sequence[Source], memory: Memory) -> list[Any]:
    """Several models as a request names them. Files and folders keep their names."""
    named = {index: model_of(source, memory) for index, source in enumerate(sources) if is_path(source)}
    return [named[index] if index in named else model_of(source, memory) for index, source in enumerate(sources)]


def is_path(source: Any) -> TypeGuard[str | os.PathLike[str]]:
    """Whether it names a file or folder."""
    return isinstance(source, (str, os.PathLike))


def model_of(source: Source, memory: Memory) -> Any:
    """A model as a request names it; what has no file of its own goes into `memory`, by its name.

    Raises
    ------
    TypeError
        Something that is no model.
    """
    if isinstance(source, (bytes, bytearray, memoryview)):
        return _remembered(UNNAMED, bytes(source), memory)
    if hasattr(source, "to_bytes") and hasattr(source, "path"):  # A result: its new model.
        return _remembered(source.path, source.to_bytes(), memory)
    if is_path(source):
        if os.fspath(source) == "-":
            message = "a Python program has no model on its standard input: give a path, bytes or an opensim.Model"
            raise RequestError("usage", message)
        return _of_disk(path_of(source), memory)
    if _live.is_model(source):
        name, data = _live.to_bytes(source)
        return _remembered(name or UNNAMED, data, memory)
    raise TypeError(
        f"expected the path of a model, its bytes, a Result or an opensim.Model, not {type(source).__name__}"
    )


def with_own_files(source: Source | None, keywords: Mapping[str, Any], memory: Memory) -> dict[str, Any]:
    """The keywords of a call about `source`, and the other files of its model where it is a result of a ForceSet by itself.

    Its new geometry belongs to it, also where the old file of that name is given.
    """
    keywords = dict(keywords)
    own = getattr(source, "_companions", None)
    for name, (path, data) in (own() if own is not None else {}).items():
        given = keywords.get(name)
        if given is None or (is_path(given) and PurePath(at_home(given)) == PurePath(path)):
            keywords[name] = InMemory(path, data)
    return keywords


class InMemory:
    """A model or another file in memory, with the name of its file."""

    def __init__(self, path: str, data: bytes) -> None:
        self.path = path
        self._data = data

    def to_bytes(self) -> bytes:
        return self._data


def _of_disk(path: Any, memory: Memory) -> Any:
    """A file as a request names it: under another name where a model in memory has its name already."""
    if not isinstance(path, str):
        return path
    if PurePath(path) in map(PurePath, memory):
        try:
            return _remembered(path, Path(path).read_bytes(), memory)
        except OSError as error:
            raise ModelError("unreadable", f"cannot be read: {error.strerror}", path=path) from error
    memory.files.add(PurePath(path))
    return path


def _remembered(name: str, data: bytes, memory: Memory) -> str:
    """A name for `data` that nothing else of the request has: no model in memory, no file, and none in a folder of it."""

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


def _plain(value: Any, keyword: str) -> Any:
    """A value as JSON would have it."""
    if isinstance(value, os.PathLike):
        return path_of(value)
    if isinstance(value, str):
        return value
    if isinstance(value, Mapping):
        # Each property that is set is a keyword of its own.
        return {str(key): _plain(item, str(key) if keyword == "set" else keyword) for key, item in value.items()}
    if hasattr(value, "tolist"):  # NumPy's numbers and arrays, and pandas' columns.
        item = value.tolist()
        if item is None:
            message = f"{keyword}: the value is missing (masked, or None in an array): leave the keyword out where nothing is known"
            raise RequestError("usage", message, keywords=(keyword,))
        # Numbers with more digits than a float give themselves.
        return _plain(float(item) if type(item) is type(value) else item, keyword)
    if isinstance(value, (list, tuple, set, frozenset)):
        return [_plain(item, keyword) for item in value]
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
