"""Reports the progress of a long call."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from ._errors import RequestError
from .types import Progress

#: The function that the Rust half calls, with a count and whether it failed.
Callback = Callable[[int, bool], object] | None


@contextmanager
def progress_callback(progress: Progress, what: str, total: int | None = None) -> Iterator[Callback]:
    """A context with the function that reports progress; None if nothing is reported.

    Raises
    ------
    RequestError
        `progress` is neither a truth value nor a function.
    """
    if callable(progress):
        yield progress
        return
    if not isinstance(progress, bool):
        message = f"progress={progress!r}: expected True, False or a function"
        raise RequestError("usage", message, keywords=("progress",))
    if not progress or importlib.util.find_spec("tqdm") is None:
        yield None
        return
    from tqdm.auto import tqdm

    with tqdm(total=total, desc=what, unit=" models") as bar:
        yield lambda count, failed: bar.update(count)
