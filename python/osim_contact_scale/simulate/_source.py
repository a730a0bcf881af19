"""Describes a function for the key of a row: its code, and all of the user's code that it uses.

Comments and blanks make no difference. Functions, classes and constants are followed through your modules, if the code names them.
Installed packages are not followed, because they have versions.
"""

from __future__ import annotations

import dis
import functools
import hashlib
import inspect
import json
import os
import site
import sys
import sysconfig
import types
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from .._errors import RequestError
from ._values import describe_value

#: Attributes of a module that describe its place, not its code.
_MODULE_ATTRIBUTES = {"__builtins__", "__file__", "__name__", "__package__", "__spec__"}

#: Attributes with one underscore that the standard library adds to classes.
_CLASS_NOTES = {"_abc_impl", "_field_defaults", "_fields"}


class Source:
    """The code of a function with all that it uses.

    Attributes
    ----------
    digest : str
        SHA-256 of it.
    modules : list of str
        Modules of yours that it uses, which are sent to the workers with it.
    """

    def __init__(self, call: Any) -> None:
        self._numbers_by_id: dict[int, int] = {}
        # Temporary objects must live as long as this object, so that their ids stay unique.
        self._kept_alive: list[Any] = []
        self.modules: list[str] = []
        text = json.dumps(self._describe(call, "the task"), sort_keys=True)
        self.digest = hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()

    def _describe(self, value: Any, name: str) -> Any:
        """A nested list of texts that is equal for equal values in every process."""
        plain = describe_value(value)
        if plain is not None:
            return plain
        if id(value) in self._numbers_by_id:
            return ["above", self._numbers_by_id[id(value)]]
        self._numbers_by_id[id(value)] = len(self._numbers_by_id)
        self._kept_alive.append(value)
        if isinstance(value, types.ModuleType):
            return ["module", value.__name__]
        if isinstance(value, types.BuiltinFunctionType):
            return ["built in", value.__module__, value.__qualname__]
        if isinstance(value, types.FunctionType):
            return self._describe_function(value, name) if self._is_user_code(value) else _describe_installed(value)
        if isinstance(value, type):
            return self._describe_class(value, name) if self._is_user_code(value) else _describe_installed(value)
        if isinstance(value, functools.partial):
            return ["partial", self._describe([value.func, value.args, value.keywords], name)]
        if isinstance(value, types.MethodType):
            return ["method", self._describe([value.__func__, value.__self__], name)]
        if isinstance(value, (staticmethod, classmethod)):
            return [type(value).__name__, self._describe(value.__func__, name)]
        if isinstance(value, property):
            return ["property", self._describe([value.fget, value.fset], name)]
        if isinstance(value, Mapping):
            return [
                "mapping",
                _sorted([self._describe(key, name), self._describe(item, name)] for key, item in value.items()),
            ]
        if isinstance(value, (set, frozenset)):
            return ["set", _sorted(self._describe(item, name) for item in value)]
        if isinstance(value, (list, tuple)):
            return [type(value).__name__, [self._describe(item, name) for item in value]]
        return self._describe_object(value, name)

    def _describe_function(self, function: types.FunctionType, name: str) -> Any:
        code = function.__code__
        parts: list[Any] = ["function", self._describe_code(code)]
        cells = [] if function.__closure__ is None else [_cell_content(cell) for cell in function.__closure__]
        parts += [
            self._describe([function.__defaults__, function.__kwdefaults__], f"a default of {function.__qualname__}"),
            [self._describe(cell, global_names) for global_names, cell in zip(code.co_freevars, cells)],
            self._describe(function.__dict__, f"an attribute of {function.__qualname__}"),
        ]
        instructions = list(_instructions(code))
        global_names = {item.argval for item in instructions if item.opname in ("LOAD_GLOBAL", "LOAD_NAME")}
        attributes = {
            item.argval for item in instructions if item.opname in ("LOAD_ATTR", "LOAD_METHOD", "IMPORT_FROM")
        }
        for used_name in sorted(global_names & function.__globals__.keys() - _MODULE_ATTRIBUTES):
            parts.append([used_name, self._describe_global(function.__globals__[used_name], used_name, attributes)])
        return parts

    def _describe_code(self, code: types.CodeType) -> Any:
        constants = [
            self._describe_code(item) if isinstance(item, types.CodeType) else self._describe(item, "a constant")
            for item in code.co_consts
        ]
        return [code.co_code.hex(), list(code.co_names), constants]

    def _describe_global(self, value: Any, name: str, attributes: Iterable[str]) -> Any:
        """Describes a global value of a function: of a module of yours the members named `attributes`, of anything else the whole value."""
        if isinstance(value, types.ModuleType) and self._is_user_code(value):
            members = vars(value)
            return [[used, self._describe(members[used], used)] for used in sorted(attributes) if used in members]
        return self._describe(value, name)

    def _describe_class(self, kind: type, name: str) -> Any:
        members = {member: value for member, value in vars(kind).items() if not _is_generated(member, value)}
        bases = [self._describe(base, name) for base in kind.__bases__]
        return ["class", kind.__qualname__, bases, self._describe(members, f"an attribute of {kind.__qualname__}")]

    def _describe_object(self, value: Any, name: str) -> Any:
        try:
            # The state that pickle would save.
            state = value.__reduce_ex__(2)
        except Exception:
            state = None
        if not isinstance(state, tuple) or " at 0x" in repr(state[1:2]):
            raise _needs_version_error(f"{name} is {type(value).__name__}, which cannot be compared")
        return ["object", self._describe(type(value), name), self._describe(list(state[1:3]), name)]

    def _is_user_code(self, value: Any) -> bool:
        """Whether a value belongs to a module that is neither an installed package nor part of Python."""
        name = value.__name__ if isinstance(value, types.ModuleType) else getattr(value, "__module__", None)
        module = sys.modules.get(name or "")
        if name is None or module is None:
            return True
        file = getattr(module, "__file__", None)
        is_yours = name == "__main__" or (
            file is not None and not os.path.realpath(file).startswith(installed_folders())
        )
        if is_yours and name not in self.modules:
            self.modules.append(name)
        return is_yours


@functools.cache
def installed_folders() -> tuple[str, ...]:
    """Folders of Python, of installed packages and of this package."""
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    names = ("stdlib", "platstdlib", "purelib", "platlib")
    folders = [
        package,
        site.getusersitepackages(),
        *site.getsitepackages(),
        *(sysconfig.get_path(name) for name in names),
    ]
    return tuple(os.path.realpath(folder) + os.sep for folder in folders)


def _instructions(code: types.CodeType) -> Iterator[dis.Instruction]:
    """Instructions of a function and of all functions inside it."""
    yield from dis.get_instructions(code)
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _instructions(constant)


def _is_generated(member: str, value: Any) -> bool:
    """Whether Python or a decorator such as `dataclass` generated a member from the rest of the class."""
    if isinstance(value, types.FunctionType):
        is_generated: bool = inspect.unwrap(value).__code__.co_filename == "<string>"
        return is_generated
    if isinstance(value, (types.MemberDescriptorType, types.GetSetDescriptorType)):
        return True
    # Python adds attributes to a class, some only when the class is used.
    return member.startswith("_") and not _is_code(value) and (member in _CLASS_NOTES or member.startswith("__"))


def _is_code(value: Any) -> bool:
    return isinstance(value, (types.FunctionType, staticmethod, classmethod, property, Mapping))


def _cell_content(cell: types.CellType) -> Any:
    try:
        return cell.cell_contents
    except ValueError:
        return None  # Not filled yet.


def _describe_installed(value: Any) -> list[str]:
    return ["installed", value.__module__ or "", value.__qualname__]


def _sorted(items: Iterable[Any]) -> list[Any]:
    return sorted(items, key=lambda item: json.dumps(item, sort_keys=True))


def _needs_version_error(message: str) -> RequestError:
    return RequestError(
        "usage",
        f"{message}: say simulate.Function(..., version=...), and another version when it changes",
        keywords=("version",),
    )
