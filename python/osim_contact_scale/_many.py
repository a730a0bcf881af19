"""Makes one change in many models."""

from __future__ import annotations

from collections.abc import Iterable
from typing import get_args

from ._option_names import ChangingVerb, Property
from .types import Progress, StrPath, Table


def many(
    verb: ChangingVerb, models: StrPath | Iterable[StrPath], /, *, progress: Progress = False, **options: object
) -> Table:
    """Makes one change in many models and writes all of them.

    Parameters
    ----------
    verb : str
        `rescale`, `transfer`, `add`, `remove`, `convert`, `design`, `set` or `note`.
    models : path or iterable of path
        Models, and folders of models.
    progress : bool or callable, optional
        Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model.
    **options
        Keywords of the verb, and where results go: `output_dir`, `in_place`, `force`, `dry_run`, `report`, `summary`, `resume`,
        `jobs`, `shard`.

    Returns
    -------
    pandas.DataFrame or list of dict
        A row for each model: what was done, old and new values, errors.

    Raises
    ------
    ContactScaleError
        The call is wrong, or a result exists already. Nothing was written.
    TypeError
        A model is not the path of a file.

    Examples
    --------
    >>> done = ocs.many("set", "fixtures/table1", stiffness="x2", dry_run=True)
    >>> set(done["status"])
    {'dry-run'}
    """
    # Imported here, because most programs do not need it.
    from . import _changes

    keywords = {name.rstrip("_"): value for name, value in options.items()}
    if verb == "set":
        properties = get_args(Property)
        keywords["set"] = {name: keywords.pop(name) for name in properties if keywords.get(name) is not None}
    return _changes.many(verb, models, keywords, progress)
