"""Contact parameters of OpenSim models, right at every body size.

    import osim_contact_scale as ocs

    result = ocs.rescale("human.osim", target_mass=1190)
    result.changes                 # every number that changes, with its equation
    result.write("giraffe.osim")

Every verb of the command `osim-contact-scale` is a function here, with the same options as keywords. The equations are those of
P. A. van Bijlert (2026), "Scaling contact force parameters across body size, limb count, and number of contact spheres",
Journal of Biomechanics; each is a function in `osim_contact_scale.scaling`.

`explain("default-stiffness")` says what a code, an equation or a quantity means. The book is in `docs` of the sources and of the program's
archive: `docs/python.md` is about this package, `docs/symptoms.md` starts from what goes wrong.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

from . import _native

if TYPE_CHECKING:
    from . import scaling
    from . import simulate as simulate
    from . import types as types
    from ._answers import Answer, DesignSheet, DropTest, Explanation, Fit, Motion, Preset, Presets, Reproduction
    from ._errors import ContactScaleError, ContactScaleWarning, ModelError, NeedsAnswer, OutputError, RequestError
    from ._figure import Figure
    from ._findings import Finding, Findings, Remedy
    from ._many import many
    from ._result import Result
    from ._survey import Check, Inspection
    from ._sweep import Sweep
    from ._threads import set_threads
    from ._verbs import (
        add,
        check,
        convert,
        design,
        drop_test,
        explain,
        fit,
        inspect,
        motion,
        note,
        plot,
        presets,
        remove,
        reproduce,
        rescale,
        rescale_many,
        sweep,
        transfer,
    )

    # Not among the names of `import *`: there it would take the place of Python's own.
    from ._verbs import set as set

__version__ = _native.VERSION
"""Version of the package, and of the command that comes with it."""

__all__ = [
    "Answer",
    "Check",
    "ContactScaleError",
    "ContactScaleWarning",
    "DesignSheet",
    "DropTest",
    "Explanation",
    "Figure",
    "Finding",
    "Findings",
    "Fit",
    "Inspection",
    "ModelError",
    "Motion",
    "NeedsAnswer",
    "OutputError",
    "Preset",
    "Presets",
    "Remedy",
    "Reproduction",
    "RequestError",
    "Result",
    "Sweep",
    "__version__",
    "add",
    "check",
    "convert",
    "design",
    "drop_test",
    "explain",
    "fit",
    "inspect",
    "many",
    "motion",
    "note",
    "plot",
    "presets",
    "remove",
    "reproduce",
    "rescale",
    "rescale_many",
    "scaling",
    "set_threads",
    "sweep",
    "transfer",
]


#: Names that are imported when they are first used, and their modules: a program waits only for the modules that it uses.
_HOMES = {
    **dict.fromkeys(
        ("Answer", "DesignSheet", "DropTest", "Explanation", "Fit", "Motion", "Preset", "Presets", "Reproduction"),
        "_answers",
    ),
    **dict.fromkeys(
        ("ContactScaleError", "ContactScaleWarning", "ModelError", "NeedsAnswer", "OutputError", "RequestError"),
        "_errors",
    ),
    **dict.fromkeys(("Finding", "Findings", "Remedy"), "_findings"),
    **dict.fromkeys(("Check", "Inspection"), "_survey"),
    "Figure": "_figure",
    "Result": "_result",
    "Sweep": "_sweep",
    "many": "_many",
    "set_threads": "_threads",
}
_MODULES = ("scaling", "simulate", "types")

if not TYPE_CHECKING:

    def __getattr__(name):
        if name in _MODULES:
            return importlib.import_module(f"{__name__}.{name}")
        # All others are verbs.
        home = _HOMES.get(name, "_verbs" if name in __all__ or name == "set" else None)
        if home is None:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        value = globals()[name] = getattr(importlib.import_module(f"{__name__}.{home}"), name)
        return value

    def __dir__():
        return sorted({*__all__, *_MODULES, "set"})
