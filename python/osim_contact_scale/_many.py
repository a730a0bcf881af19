"""One change of many models."""

from __future__ import annotations

import typing
from collections.abc import Iterable
from typing import Any

from . import _changes, _verbs
from ._progress import Progress
from ._verbs import StrPath


def many(verb: str, models: StrPath | Iterable[StrPath], /, *, progress: Progress = False, **options: Any) -> Any:
    """Does the same change to many models and writes all of them.

    Parameters
    ----------
    verb : str
        `rescale`, `transfer`, `add`, `remove`, `convert`, `design`, `set` or `note`.
    models : path or iterable of path
        Models, and folders of models.
    progress : bool or callable, optional
        Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model.
    **options
        What the verb takes, and where results go: `output_dir`, `in_place`, `force`, `dry_run`, `report`, `summary`, `resume`,
        `jobs`, `shard`.

    Returns
    -------
    pandas.DataFrame or list of dict
        A row for each model: what was done, old and new values, errors.

    Raises
    ------
    ContactScaleError
        It cannot be done: found before anything is written.
    TypeError
        A model that is not the path of a file.
    """
    keywords = {name.rstrip("_"): value for name, value in options.items()}
    if verb == "set":
        keywords["set"] = {name: keywords.pop(name) for name in _properties() if keywords.get(name) is not None}
    return _changes.many(verb, models, keywords, progress)


def _properties() -> list[str]:
    """OpenSim's properties that `set` takes: the keywords of it that are a number or a factor such as `"x2"`."""
    kinds = typing.get_type_hints(_verbs.set)
    return [name for name, kind in kinds.items() if {*typing.get_args(kind)} == {float, str, type(None)}]
