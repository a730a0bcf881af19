"""Series and DataFrames of pandas and polars, distinguished without an import: nothing is of the classes of what is not imported."""

from __future__ import annotations

import sys
from typing import Any

#: Module and class of each kind.
KINDS = (("pandas", "Series"), ("pandas", "DataFrame"), ("polars", "Series"), ("polars", "DataFrame"))


def kind_of(value: Any) -> tuple[str, str] | None:
    """Which of `KINDS` a value is; None for everything else."""
    for module, name in KINDS:
        kind = getattr(sys.modules.get(module), name, None)
        if kind is not None and isinstance(value, kind):
            return module, name
    return None
