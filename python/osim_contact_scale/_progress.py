"""How far a long call is."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from ._errors import RequestError
from .types import Progress

#: What the native half calls back.
Callback = Callable[[int, bool], object] | None


@contextmanager
def progress_callback(progress: Progress, what: str, total: int | None = None) -> Iterator[Callback]:
    """What to call back, while it lasts.

    Raises
    ------
    RequestError
        Something else than `Progress`.
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
