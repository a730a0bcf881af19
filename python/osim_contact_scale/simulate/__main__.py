"""`python -m osim_contact_scale.simulate TABLE --task drop --results FOLDER`: a run without a program of your own."""

from __future__ import annotations

import argparse
import importlib.util
import inspect
import json
import logging
import signal
import sys
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from types import FrameType
from typing import Any

from .._errors import ContactScaleError, OutputError, RequestError
from .._text import printable

try:
    from . import Drop, Function, Stand, WorkersLost, run
except ModuleNotFoundError as missing:
    raise SystemExit(str(missing)) from None

TASKS: dict[str, type[Any]] = {"drop": Drop, "stand": Stand}

_EPILOG = """\
Every model runs in a process of its own in the real OpenSim. Rows go to FOLDER/parts as they come; table.csv and
table.parquet are written at the end. After a stop of any kind, the same call with --resume goes on.

exit status: 0 all models done, 1 some are not (see the columns status and error), 2 the call is wrong, 3 the workers were lost or the
results could not be written, 130 stopped by Ctrl-C, 143 by the system
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the simulations of a command line and returns the exit status."""
    options = _parser().parse_args(arguments)
    _log_to_terminal()
    # Ctrl-C is handled here, too: Python ends itself by the signal if a KeyboardInterrupt is raised in code compiled from a text.
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, _stop)
    try:
        results = run(
            options.table,
            _task_of_options(options.task, _parse_settings(options.set)),
            results=options.results,
            scheduler=options.scheduler,
            workers=options.workers,
            resume=options.resume,
            retry_failed=options.retry_failed,
            time_limit=options.time_limit,
            shard=options.shard,
            progress=sys.stderr.isatty(),
        )
    except (RequestError, OSError) as error:
        return _print_error(error, 2)
    except (WorkersLost, OutputError) as error:
        return _print_error(error, 3)
    except ContactScaleError as error:
        return _print_error(error, 1)
    except _StoppedError as stopped:
        who = " by the system" if stopped.number == signal.SIGTERM else ""
        return _print_error(f"stopped{who}; what was done is kept: run again with --resume", 128 + stopped.number)
    print(_summary(Counter(results.table["status"].fillna("not run")), options))
    return 0 if len(results.failures) == 0 else 1


def _log_to_terminal() -> None:
    """Prints the log of this package, and nothing of Dask's log."""
    log = logging.getLogger("osim_contact_scale")
    log.addHandler(logging.StreamHandler())
    log.setLevel(logging.INFO)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m osim_contact_scale.simulate",
        description="Runs a task on every model of a table.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "table", metavar="TABLE", type=Path, help="CSV with a column path or file, such as a sweep's manifest"
    )
    parser.add_argument("--task", required=True, metavar="TASK", help="drop, stand, or FILE.py:FUNCTION")
    parser.add_argument("--results", required=True, metavar="FOLDER", type=Path, help="where parts and tables go")
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="a setting of the task, such as height=0.5R; again for more",
    )
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="of a Dask scheduler, or `here` for no Dask; by default workers of Dask on this machine",
    )
    parser.add_argument(
        "--workers", type=int, metavar="N", help="models at the same time on this machine; by default one for each core"
    )
    parser.add_argument("--resume", action="store_true", help="go on where an earlier run stopped")
    parser.add_argument("--retry-failed", action="store_true", help="with --resume, do failed rows again")
    parser.add_argument("--time-limit", type=float, metavar="S", help="seconds that one model may take")
    parser.add_argument(
        "--shard", metavar="I/N", help="only share I of N; a call without it joins the tables in the end"
    )
    return parser


def _task_of_options(text: str, settings: dict[str, Any]) -> Any:
    """The task that `--task` and `--set` describe.

    Raises
    ------
    RequestError
        There is no such task or setting.
    """
    task_class = TASKS.get(text)
    if task_class is not None:
        names = list(inspect.signature(task_class).parameters)
        unknown = next((name for name in settings if name not in names), None)
        if unknown is not None:
            raise RequestError("usage", f"--set {printable(unknown)}: {text} has {', '.join(names)}")
        return task_class(**settings)
    file, colon, name = text.rpartition(":")
    if not colon or not file.endswith(".py"):
        raise RequestError("usage", f"--task {printable(text)}: expected {', '.join(TASKS)} or FILE.py:FUNCTION")
    return Function(_function_in_file(Path(file), name), settings)


def _function_in_file(file: Path, name: str) -> Callable[..., Any]:
    if not file.is_file():
        raise RequestError("usage", f"--task: there is no file {printable(str(file))}")
    # The module is loaded from its file, because another module may have its name. It can import modules of its folder.
    sys.path.insert(0, str(file.resolve().parent))
    module_name = file.stem if file.stem not in sys.modules else f"{file.stem}_of_task"
    spec = importlib.util.spec_from_file_location(module_name, file)
    try:
        if spec is None or spec.loader is None:
            raise ImportError("it is no module")
        module = importlib.util.module_from_spec(spec)
        sys.modules[module_name] = module
        spec.loader.exec_module(module)
    except (Exception, SystemExit) as error:
        why = printable(f"{type(error).__name__}: {error}")
        raise RequestError("usage", f"--task: {printable(str(file))} cannot be imported: {why}") from error
    function = getattr(module, name, None)
    if not callable(function):
        raise RequestError("usage", f"--task: {printable(str(file))} has no function {printable(name)}")
    task_function: Callable[..., Any] = function
    return task_function


def _parse_settings(items: Sequence[str]) -> dict[str, Any]:
    """The settings of `NAME=VALUE` arguments; a value is a number, true, false or null if JSON reads it as one, else a text."""
    settings: dict[str, Any] = {}
    for item in items:
        name, equals, text = item.partition("=")
        if not equals or not name.isidentifier():
            raise RequestError("usage", f"--set {printable(item)}: expected NAME=VALUE")
        if name in settings:
            raise RequestError("usage", f"--set {name}: said twice")
        try:
            settings[name] = json.loads(_PYTHON_LITERALS.get(text, text))
        except (ValueError, RecursionError):
            settings[name] = text
    return settings


#: Words of Python and their spelling in JSON.
_PYTHON_LITERALS = {"True": "true", "False": "false", "None": "null"}


def _summary(counts: Counter[str], options: argparse.Namespace) -> str:
    counted = ", ".join(f"{count} {status}" for status, count in counts.items()) or "no models"
    where = options.results if options.shard is not None else options.results / "table.csv"
    return f"{counted}: {printable(str(where))}"


def _print_error(what: object, status: int) -> int:
    print(printable(str(what)), file=sys.stderr)
    return status


class _StoppedError(BaseException):
    """A signal stopped the program."""

    def __init__(self, number: int) -> None:
        self.number = number


def _stop(number: int, frame: FrameType | None) -> None:
    raise _StoppedError(number)


if __name__ == "__main__":
    sys.exit(main())
