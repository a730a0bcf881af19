"""The number of threads that work on many models."""

from __future__ import annotations

import operator
import os
from typing import Any

from ._errors import RequestError, warn

#: More threads than any computer has processors.
_MAX_THREADS = 4096
_ENVIRONMENT_VARIABLE = "OSIM_CONTACT_SCALE_THREADS"

_default_count: int | None = None
#: The wrong value of the environment variable that was reported already.
_reported_value: str | None = None


def set_threads(count: int | None) -> None:
    """Sets how many threads work on many models at once.

    Parameters
    ----------
    count : int or None
        None for one per processor, which is the default. The environment variable `OSIM_CONTACT_SCALE_THREADS` sets it for a
        whole session.

    Raises
    ------
    RequestError
        `count` is not a whole number from 1 to 4096.

    Examples
    --------
    >>> ocs.set_threads(2)
    >>> ocs.set_threads(None)
    """
    global _default_count
    _default_count = _check_thread_count(count, "count")


def thread_count(jobs: Any) -> int | None:
    """The number of threads of a call: `jobs`, or else the default; None for one per processor.

    Raises
    ------
    RequestError
        `jobs` is not a whole number from 1 to 4096.
    """
    return default_thread_count() if jobs is None else _check_thread_count(jobs, "jobs")


def default_thread_count() -> int | None:
    """The number of threads from `set_threads` or the environment; None for one per processor."""
    global _reported_value
    if _default_count is not None:
        return _default_count
    text = os.environ.get(_ENVIRONMENT_VARIABLE, "").strip()
    if text.isdecimal() and len(text) < 10 and 1 <= int(text) <= _MAX_THREADS:
        return int(text)
    if text and text != _reported_value:
        _reported_value = text
        expected = f"expected a whole number, 1 or more and at most {_MAX_THREADS}: one thread per processor is used"
        warn(f"{_ENVIRONMENT_VARIABLE}={text[:40]!r}: {expected}")
    return None


def _check_thread_count(count: Any, keyword: str) -> int | None:
    if count is None:
        return None
    try:
        number = None if isinstance(count, bool) else operator.index(count)
    except TypeError:
        number = None
    if number is None or not 1 <= number <= _MAX_THREADS:
        message = f"{keyword}={count!r}: expected a whole number, 1 or more and at most {_MAX_THREADS}, or None"
        raise RequestError("usage", message, keywords=(keyword,))
    return number
