"""Simulations of many models in the real OpenSim, on one machine or a cluster.

    import osim_contact_scale as ocs
    from osim_contact_scale import simulate

    if __name__ == "__main__":
        points = ocs.sweep("walker.osim", grid={"stiffness": "x0.1..x10/9"}, output_dir="walker.sweep")
        rows = simulate.run(points, simulate.Drop(height="0.5R"), results="walker.results")
        print(rows.table)

Needs the extra `simulate` of this package, and OpenSim for Python.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._drop import Drop
    from ._queue import WorkersLost
    from ._results import Results
    from ._run import run
    from ._stand import Stand
    from ._task import Function

__all__ = ["Drop", "Function", "Results", "Stand", "WorkersLost", "run"]

_MODULES = {
    "Drop": "_drop",
    "Function": "_task",
    "Results": "_results",
    "Stand": "_stand",
    "WorkersLost": "_queue",
    "run": "_run",
}


def __getattr__(name: str) -> Any:
    # The processes of the models import this package, too: without pandas they start at once, and are copied in 3 ms.
    if name in _MODULES:
        try:
            return getattr(importlib.import_module(f"{__name__}.{_MODULES[name]}"), name)
        except ModuleNotFoundError as error:
            missing = f"simulations need {error.name}, which the extra `simulate` brings: pip install {error.name}"
            raise ModuleNotFoundError(missing, name=error.name) from None
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return list(__all__)
