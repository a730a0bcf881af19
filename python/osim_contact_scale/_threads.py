"""How many threads work on many models."""

from __future__ import annotations

import logging
import operator
import os
from typing import Any

from ._errors import RequestError

log = logging.getLogger("osim_contact_scale")

#: No computer has more processors than this for one program.
_MOST = 4096
_VARIABLE = "OSIM_CONTACT_SCALE_THREADS"

_asked: int | None = None
#: The value of the environment that could not be used, and was reported.
_reported: str | None = None


def set_threads(count: int | None) -> None:
    """Says how many threads work on many models at once.

    Parameters
    ----------
    count : int or None
        None for one per processor, which is also the default. The environment variable `OSIM_CONTACT_SCALE_THREADS` says it for a
        whole session.

    Raises
    ------
    RequestError
        Not a whole number from 1 to 4096.

    Examples
    --------
    >>> ocs.set_threads(2)
    >>> ocs.set_threads(None)
    """
    global _asked
    _asked = _checked(count, "count")


def jobs_of(jobs: Any) -> int | None:
    """How many threads a call has: `jobs`, else the number for all calls; None for one per processor.

    Raises
    ------
    RequestError
        Not a whole number from 1 to 4096.
    """
    return threads() if jobs is None else _checked(jobs, "jobs")


def threads() -> int | None:
    """How many threads were asked for; None for one per processor."""
    global _reported
    if _asked is not None:
        return _asked
    text = os.environ.get(_VARIABLE, "").strip()
    if text.isdecimal() and len(text) < 10 and 1 <= int(text) <= _MOST:
        return int(text)
    if text and text != _reported:
        _reported = text
        message = "%s=%r: expected a whole number, 1 or more and at most %d: one thread per processor is used"
        log.warning(message, _VARIABLE, text[:40], _MOST)
    return None


def _checked(count: Any, keyword: str) -> int | None:
    if count is None:
        return None
    try:
        number = None if isinstance(count, bool) else operator.index(count)
    except TypeError:
        number = None
    if number is None or not 1 <= number <= _MOST:
        message = f"{keyword}={count!r}: expected a whole number, 1 or more and at most {_MOST}, or None"
        raise RequestError("usage", message, keywords=(keyword,))
    return number
