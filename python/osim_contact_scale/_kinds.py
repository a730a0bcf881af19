"""Recognises Series and DataFrames of pandas and polars without an import: no value can be of a class that is not imported."""

from __future__ import annotations

import sys
from typing import Any

#: Module and class of each kind of table.
KINDS = (("pandas", "Series"), ("pandas", "DataFrame"), ("polars", "Series"), ("polars", "DataFrame"))


def kind_of(value: Any) -> tuple[str, str] | None:
    """The entry of `KINDS` that fits a value; None for everything else."""
    for module, name in KINDS:
        kind = getattr(sys.modules.get(module), name, None)
        if kind is not None and isinstance(value, kind):
            return module, name
    return None
