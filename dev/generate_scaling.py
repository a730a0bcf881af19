#!/usr/bin/env python3
"""Writes python/osim_contact_scale/scaling.py: a function with a docstring for each equation, from the register in Rust.

    python dev/generate_scaling.py           writes it; the package must be installed, built from what is here
    python dev/generate_scaling.py --check   fails where it differs, as after a new equation in Rust
"""

import difflib
import sys
import textwrap
from pathlib import Path

from osim_contact_scale import _native

OUTPUT = Path(__file__).resolve().parent.parent / "python" / "osim_contact_scale" / "scaling.py"

HEAD = '''# Written by dev/generate_scaling.py: do not edit.
"""Every equation of the paper as a function of NumPy arrays.

All arguments have names, so that no order can be mixed up; all numbers are in SI units. Arrays are broadcast against each other; the
result is an array of float64, or a float where every argument is a number. A value outside of the domain of an equation is a
`osim_contact_scale.RequestError` (which is a ValueError) that names the argument and the element. NaN and infinity are such
values, too: fill or drop gaps first.

A name without "for" is what the name says. A property of OpenSim alone, such as `dissipation`, is the factor by which it grows from
one animal to another; `dissipation_for_restitution` is its value for what is wanted. Moduli are E* of both surfaces unless the name
says plane strain: OpenSim's `stiffness` is a plane strain modulus.

    >>> from osim_contact_scale import scaling
    >>> scaling.dissipation(radius_ratio=4)
    0.5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from ._arrays import Number, NumberList, Steps, call, call_of_list, call_of_steps

if TYPE_CHECKING:
    from ._arrays import Values
'''

STEPS = '''def continuation_steps(
    *, first: float, last: float, dissipation_ratio: float = 1.0, count: int = 5
) -> Steps:
    """Steps from soft contacts to those that are wanted, for a ladder of optimisations (section 4.3 of the paper).

    Parameters
    ----------
    first, last : float
        Dimensionless stiffness k̂ (B.3) at the load of the first and the last step; without unit.
    dissipation_ratio : float, default 1
        What α begins with, over its last value; without unit.
    count : int, default 5
        How many steps, the last one included.

    Returns
    -------
    Steps
        Arrays of float64: `dimensionless_stiffness`, and what E* and α of the last step are multiplied by, `modulus_factor` and
        `dissipation_factor`; without unit.
    """
    return call_of_steps(first, last, dissipation_ratio, count)
'''


def main() -> int:
    text = module()
    if "--check" not in sys.argv[1:]:
        OUTPUT.write_text(text, encoding="utf-8")
        return 0
    there = OUTPUT.read_text(encoding="utf-8")
    lines = list(difflib.unified_diff(there.splitlines(), text.splitlines(), OUTPUT.name, "from Rust", lineterm=""))
    if lines:
        print("\n".join(lines), "\nscaling.py is out of date: run python dev/generate_scaling.py", sep="\n")
    return 1 if lines else 0


def module() -> str:
    functions = _native.equations()
    names = sorted([name for name, *_ in functions] + ["continuation_steps"])
    exported = "__all__ = [\n" + "".join(f'    "{name}",\n' for name in names) + "]\n"
    return "\n\n".join([HEAD + "\n" + exported, *(function(*one) for one in functions), STEPS])


def function(name: str, kind: str, parameters: list, takes_rule: bool, doc: str) -> str:
    kinds = {"numbers": "Number", "list": "NumberList", "spheres": "float | NumberList"}
    signature = [f"{one}: {kinds[kind]}" + ("" if default is None else f" = {default!r}") for one, default in parameters]
    given = ", ".join(f'"{one}": {one}' for one, _ in parameters)
    body = f'call("{name}", {{{given}}})'
    returns = "Values"
    if kind == "spheres":
        # The load comes first, the height of each sphere last, where they are not level.
        signature = ["load: float", *[one for one in signature if "=" not in one], *[one for one in signature if "=" in one]]
        signature.append("height: NumberList | None = None")
        body, returns = f'call_of_list("{name}", {{{given}}}, height, load)', "float"
    elif kind == "list":
        body, returns = f'call_of_list("{name}", {{{given}}})', "float"
    if takes_rule:
        rules = ", ".join(f'"{rule}"' for rule in _native.mixing_rules())
        signature.append(f'rule: Literal[{rules}] = "{_native.mixing_rules()[0]}"')
        body = body[:-1] + ", rule)"
    head = f"def {name}(\n    *,\n" + "".join(f"    {one},\n" for one in signature) + f") -> {returns}:\n"
    raises = "\n\nRaises\n------\nRequestError\n    A value outside of the domain, by its argument and element."
    text, _, references = doc.partition("\n\nReferences\n")
    documented = '"""' + text.rstrip() + raises + ("\n\nReferences\n" + references.rstrip() if references else "") + '\n"""\n'
    return head + textwrap.indent(documented, "    ", lambda line: bool(line.strip())) + f"    return {body}\n"


if __name__ == "__main__":
    sys.exit(main())
