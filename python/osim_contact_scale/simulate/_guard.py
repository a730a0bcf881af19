"""Refuses calls of `run` that each worker process would repeat when it imports the program."""

from __future__ import annotations

import ast
import multiprocessing
import os
import sys
import time
from types import FrameType

from .._errors import RequestError

_MESSAGE = (
    '{file}, line {line}: put this call under `if __name__ == "__main__":`, '
    "because each worker imports the file and would run it again"
)

#: The time at which this program imported the package, in s.
_IMPORT_TIME = time.time()

#: A variable in the environment of processes that simulate models, and of all processes that they start.
RUN_VARIABLE = "OSIM_CONTACT_SCALE_WITHIN_A_RUN"


def refuse_nested_run() -> None:
    """Refuses a run that a task or a module of a task starts: each of its models would start another run.

    Raises
    ------
    RequestError
        A task called `run`.
    """
    if RUN_VARIABLE in os.environ:
        message = (
            'a task cannot begin a run; a module that begins one needs `if __name__ == "__main__":` before the call'
        )
        raise RequestError("usage", message)


def refuse_unguarded() -> None:
    """Ends a program that calls `run` from its top level without the guard, before it starts a process.

    Raises
    ------
    SystemExit
        The message is one line.
    """
    if getattr(multiprocessing.current_process(), "_inheriting", False):
        # This process is a worker that imports the program: it must not run the calls.
        raise SystemExit(1)
    main = sys.modules.get("__main__")
    file = getattr(main, "__file__", None)
    if file is None:
        return  # A prompt or a notebook: there is nothing that a worker could import.
    if not os.path.exists(file):
        raise SystemExit('a program from the standard input has no file for workers: save it, or say scheduler="here"')
    frame: FrameType | None = sys._getframe()
    while frame is not None:
        if frame.f_globals is vars(main) and frame.f_code.co_name == "<module>":
            _end_unguarded(frame, file)
        frame = frame.f_back


def _end_unguarded(frame: FrameType, file: str) -> None:
    try:
        if os.path.getmtime(file) > _IMPORT_TIME:
            return  # Edited since: its lines are no longer those of the program that runs.
        with open(file, "rb") as text:
            tree = ast.parse(text.read())
    except (OSError, SyntaxError, ValueError):
        return
    line = frame.f_lineno
    if not any(isinstance(part, ast.If) and _is_main_guard_of(part, line) for part in ast.walk(tree)):
        raise SystemExit(_MESSAGE.format(file=os.path.basename(file), line=line))


def _is_main_guard_of(part: ast.If, line: int) -> bool:
    """Whether this line of the program runs only where `__name__` is `"__main__"`."""
    for test in ast.walk(part.test):
        if isinstance(test, ast.Compare) and {"__name__", "__main__"} <= set(_names_and_constants(test)):
            guarded = part.body if isinstance(test.ops[0], ast.Eq) else part.orelse
            return any(statement.lineno <= line <= (statement.end_lineno or 0) for statement in guarded)
    return False


def _names_and_constants(test: ast.AST) -> list[str]:
    names = [part.id for part in ast.walk(test) if isinstance(part, ast.Name)]
    return names + [str(part.value) for part in ast.walk(test) if isinstance(part, ast.Constant)]
