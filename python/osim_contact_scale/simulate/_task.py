"""The task of a run, and the key of a row: what its results depend on."""

from __future__ import annotations

import dataclasses
import hashlib
import inspect
import json
import os
import sys
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from .._errors import RequestError
from .._text import clipped, printable
from ._source import Source


class Function:
    """A function of yours with its settings.

    Parameters
    ----------
    function : callable
        `function(path, **values)`: the path of a model, and those columns of the model's row that it has parameters for (with
        `**values` all of them). It returns a dictionary of numbers, with their units in the names, or a tuple of that and a dictionary of
        equally long series.
    settings : dict, optional
        Further keyword arguments, equal for all models: numbers, texts, lists and dictionaries of them. They are part of a row's key.
    version : str or int, optional
        The part of a row's key that is about the function. By default it is the function's code, with that of everything
        that it uses: after a change of the code, all rows are computed again. Give a version if results depend on more than code, such as
        a file, and change the version with it.
    """

    def __init__(
        self, function: Callable[..., Any], settings: Mapping[str, Any] | None = None, version: str | int | None = None
    ) -> None:
        self.function = function
        self.settings = dict(settings or {})
        self.version = version

    def __repr__(self) -> str:
        return f"<Function {task_name(self.function)} with {self.settings}>"


@dataclasses.dataclass(frozen=True)
class Task:
    """A callable, its arguments, and its part of the key of a row."""

    call: Callable[..., Any]
    settings: Mapping[str, Any]
    identity: Mapping[str, Any]
    #: Names of the columns that it takes; None for all.
    columns: frozenset[str] | None
    #: The name of its parameter for the path, which no column may fill.
    reserved: frozenset[str]
    #: Columns that it requires.
    needed: frozenset[str]
    #: Modules of yours that are sent with it.
    modules: tuple[str, ...]

    def arguments(self, row: Mapping[str, Any]) -> dict[str, Any]:
        """The keyword arguments for a row."""
        values = row if self.columns is None else {name: row[name] for name in self.columns if name in row}
        return {**{name: value for name, value in values.items() if name not in self.reserved}, **self.settings}

    def check_columns(self, columns: Iterable[str]) -> None:
        """Refuses a table without a column that the task requires, or with a column that has the name of a setting.

        Raises
        ------
        RequestError
            A column is missing, or has the name of a setting.
        """
        missing = sorted(self.needed - set(columns))
        if missing:
            there = ", ".join(columns)
            message = f"{task_name(self.call)} needs {missing[0]!r}, which is neither a column nor a setting; there are: {there}"
            raise RequestError("usage", message, keywords=("points", "settings"))
        ambiguous = sorted(self.settings.keys() & set(columns))
        if ambiguous:
            message = f"{ambiguous[0]!r} is a column of the points and a setting, too: call one of them differently"
            raise RequestError("usage", message, keywords=("points", "settings"))

    def pickled(self) -> tuple[bytes, tuple[str, ...]]:
        """The callable as a pickle for another process, and the folders in which Python looks for its modules.

        Raises
        ------
        RequestError
            The callable cannot be pickled.
        """
        import cloudpickle

        folders = (os.getcwd() if not folder else os.path.abspath(folder) for folder in sys.path)
        # The modules in the key are sent by value: a worker may find another file of that name, or have an older module in memory.
        yours = [sys.modules[name] for name in self.modules if name in sys.modules and name != "__main__"]
        yours = [module for module in yours if module.__name__ not in cloudpickle.list_registry_pickle_by_value()]
        for module in yours:
            cloudpickle.register_pickle_by_value(module)
        try:
            blob = cloudpickle.dumps(self.call)
        except Exception as error:
            message = f"{task_name(self.call)} cannot be sent to another process: {error}"
            raise RequestError("usage", message, keywords=("task",)) from error
        finally:
            for module in yours:
                cloudpickle.unregister_pickle_by_value(module)
        return blob, tuple(folder for folder in folders if os.path.isdir(folder))


def prepare_task(task: Any) -> Task:
    """Prepares a task: reads its parameters and its part of the key.

    Raises
    ------
    RequestError
        It cannot be called with a path, a setting is not a plain value, or its source is unknown and no version was given.
    """
    function = task if isinstance(task, Function) else Function(task)
    call = function.function
    if not callable(call) or isinstance(call, type):
        hint = ": make one, such as simulate.Drop()" if isinstance(call, type) else ""
        task_text = clipped(printable(repr(call)), 200)
        raise RequestError("usage", f"task={task_text}: expected a function, or a task{hint}", keywords=("task",))
    _check_settings(function.settings)
    identity, modules = _identity_of_function(function)
    first, columns, needed = _parameters_of_function(call, function.settings)
    return Task(call, function.settings, identity, columns, first, needed, modules)


def task_name(call: Any) -> str:
    """The name of a task for messages."""
    return str(getattr(call, "__qualname__", None) or type(call).__name__)


def _identity_of_function(function: Function) -> tuple[dict[str, Any], tuple[str, ...]]:
    call = function.function
    if (
        dataclasses.is_dataclass(call)
        and not isinstance(call, type)
        and type(call).__module__.startswith(f"{__package__}.")
    ):
        # A task of this package has the version of the package.
        return {"task": type(call).__name__, "settings": {**dataclasses.asdict(call), **function.settings}}, ()
    if function.version is not None:
        return {"task": task_name(call), "settings": function.settings, "version": str(function.version)}, ()
    source = Source(call)
    return {"task": task_name(call), "settings": function.settings, "version": source.digest}, tuple(source.modules)


def _check_settings(settings: Mapping[str, Any]) -> None:
    for name, value in settings.items():
        try:
            json.dumps(value)
        except (TypeError, ValueError):
            message = (
                f"settings: {name} is {type(value).__name__}, expected numbers, texts, lists or dictionaries of them"
            )
            raise RequestError("usage", message, keywords=("settings",)) from None


def _parameters_of_function(
    call: Callable[..., Any], settings: Mapping[str, Any]
) -> tuple[frozenset[str], frozenset[str] | None, frozenset[str]]:
    """The name of its first parameter, the columns that it takes (None for all), and those that it needs."""
    kinds = inspect.Parameter
    parameters = list(inspect.signature(call).parameters.values())
    if not parameters or parameters[0].kind in (kinds.KEYWORD_ONLY, kinds.VAR_KEYWORD):
        raise RequestError(
            "usage", f"{task_name(call)}: its first parameter is the path of a model", keywords=("task",)
        )
    first = frozenset({parameters[0].name} if parameters[0].kind is kinds.POSITIONAL_OR_KEYWORD else ())
    named = {
        item.name: item for item in parameters[1:] if item.kind in (kinds.POSITIONAL_OR_KEYWORD, kinds.KEYWORD_ONLY)
    }
    takes_all = any(item.kind is kinds.VAR_KEYWORD for item in parameters)
    unknown = sorted(name for name in settings if name in first or (name not in named and not takes_all))
    if unknown:
        raise RequestError("usage", f"{task_name(call)} has no parameter {unknown[0]!r}", keywords=("settings",))
    needed = frozenset(name for name, item in named.items() if item.default is kinds.empty and name not in settings)
    return first, None if takes_all else frozenset(named.keys() - settings.keys()), needed


def base_key(identity: Mapping[str, Any], versions: Any) -> str:
    """SHA-256 of everything that all rows of a run depend on.

    Parameters
    ----------
    identity : dict
        Task, settings, and source or version.
    versions : Versions
        Versions of opensim and of this package.
    """
    return _digest_of_identity({**identity, **dataclasses.asdict(versions)})


def row_key(digest: str, base: str, values: Mapping[str, Any]) -> str:
    """SHA-256 of everything that a row depends on: two rows with one key have one result.

    Parameters
    ----------
    digest : str
        SHA-256 of the model's bytes.
    base : str
        SHA-256 of everything that all rows of the run depend on.
    values : dict
        The arguments of the task from the model's row.
    """
    return _digest_of_identity({"model": digest, "base": base, "values": values})


def _digest_of_identity(identity: Mapping[str, Any]) -> str:
    return hashlib.sha256(json.dumps(_normalized(identity), sort_keys=True, default=str).encode()).hexdigest()


def _normalized(value: Any) -> Any:
    """A value with every number in one form: 2 in a file may be 2.0 in a DataFrame."""
    if isinstance(value, Mapping):
        return {str(name): _normalized(item) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_normalized(item) for item in value]
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, float) and value != value:
        return None
    return int(value) if isinstance(value, float) and value.is_integer() else value
