#!/usr/bin/env python3
"""Writes python/osim_contact_scale/scaling.py: a function with a docstring for each equation, from the register in Rust.

    python dev/generate_scaling.py           writes it; the package must be installed, built from what is here
    python dev/generate_scaling.py --check   fails where it differs, as after a new equation in Rust
"""

import difflib
import re
import sys
import textwrap
from pathlib import Path

from osim_contact_scale import _native
from scaling_examples import EXAMPLES

OUTPUT = Path(__file__).resolve().parent.parent / "python" / "osim_contact_scale" / "scaling.py"

HEAD = '''# Written by dev/generate_scaling.py: do not edit.
# Each overload takes all that those before it take: the first one that fits is meant.
# mypy: disable-error-code="overload-overlap"
# pyright: reportOverlappingOverload=false
"""Every equation of the paper as a function of NumPy arrays, Series and DataFrames.

All arguments have names, so that no order can be mixed up; all numbers are in SI units. Arrays are broadcast against each other; the
result is an array of float64, or a float where every argument is a number. A value outside of the domain of an equation is a
`osim_contact_scale.RequestError` (which is a ValueError) that names the argument and the element. Infinity is such a value, too, and
so is NaN, unless `nan="propagate"` is given: then an element is NaN where any of its arguments is, and the others are calculated.

With a Series or a DataFrame of pandas or polars among the arguments, the result is one, too. Its index and columns are theirs. A
Series keeps its name; of several Series, the name that all of them have. Several must have equal indexes (in polars: lengths), in
the same order: nothing is aligned silently. Numbers, and arrays of the same shape, go together with all of them. NA of pandas and
null of polars are taken for NaN.

A function over a list of spheres takes a Series for a list, and gives one number; it is NaN with `nan="propagate"` where any number
of any list is.

A name without "for" is what the name says. A property of OpenSim alone, such as `dissipation`, is the factor by which it grows from
one animal to another; `dissipation_for_restitution` is its value for what is wanted. Moduli are E* of both surfaces unless the name
says plane strain: OpenSim's `stiffness` is a plane strain modulus.

    >>> from osim_contact_scale import scaling
    >>> scaling.dissipation(radius_ratio=4)
    0.5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, overload

from ._arrays import Number, NumberList, Steps, call, call_of_list, call_of_steps

if TYPE_CHECKING:
    from ._arrays import Array, Floats, Frame, PandasFloats, PandasSeries, Scalar
'''

NAN = 'nan: Literal["raise", "propagate"]'

#: Types of the arguments, and of the result where one of them is no type of a line above.
OVERLOADS = [
    ("Scalar", "float"),
    ("Scalar | Array", "Floats"),
    ("Scalar | Array | PandasSeries", "PandasFloats"),
    ("Scalar | Array | Frame", "Frame"),
]

#: Types of the returned value, by the kind of function.
RETURNS = {"numbers": ("float or numpy.ndarray\n", "float, numpy.ndarray, Series or DataFrame\n")}

#: Help of `nan`, by the kind of function.
NAN_HELP = {
    "numbers": "an element that has it in any argument is NaN, and not looked at further.",
    "list": "the result is NaN where any number of any list is.",
    "steps": "all steps are NaN where any number is.",
}

STEPS = '''def continuation_steps(*, first: float, last: float, dissipation_ratio: float = 1.0, count: int = 5, nan: Literal["raise", "propagate"] = "raise") -> Steps:
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
    return call_of_steps(first, last, dissipation_ratio, count, nan)
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
    exported = "__all__ = [\n" + "".join(f'    "{name}",\n' for name in names) + "]\n\n\ndef __dir__() -> list[str]:\n    return list(__all__)\n"
    functions_by_name = {name: function(name, *rest) for name, *rest in functions}
    functions_by_name["continuation_steps"] = with_nan(STEPS, "steps", "    ")
    examples = examples_of(names)
    return "\n\n".join([HEAD + "\n" + exported, *(with_examples(text, examples[name]) for name, text in functions_by_name.items())])


def examples_of(names: list[str]) -> dict[str, str]:
    """The examples of every function."""
    examples = {}
    for block in EXAMPLES.strip().split("\n\n"):
        name = re.search(r"scaling\.(\w+)\(|$", block)[1]
        if name not in names or name in examples:
            raise SystemExit(f"error: dev/scaling_examples.py has an example of no function, or a second block of one:\n{block}")
        examples[name] = block
    missing = [name for name in names if name not in examples]
    if missing:
        raise SystemExit(f"error: dev/scaling_examples.py has no example of {', '.join(missing)}")
    return examples


def with_examples(text: str, examples: str) -> str:
    """A function with a section of examples as the last one of its docstring."""
    section = textwrap.indent(f"Examples\n--------\n{examples}\n", "    ")
    before, end, after = text.partition('    """\n    return ')
    return f"{before}\n{section}{end}{after}"


def function(name: str, kind: str, parameters: list, takes_rule: bool, doc: str) -> str:
    last = [f'{NAN} = "raise"']
    if takes_rule:
        rules = ", ".join(f'"{rule}"' for rule in _native.mixing_rules())
        last.insert(0, f'rule: Literal[{rules}] = "{_native.mixing_rules()[0]}"')
    arguments = "{" + ", ".join(f'"{one}": {one}' for one, _ in parameters) + "}"
    if kind == "numbers":
        overloads = "".join(overload(name, parameters, last, *types) for types in OVERLOADS)
        body = f'call("{name}", {arguments}, nan' + (", rule)" if takes_rule else ")")
        return overloads + defined(name, typed(parameters, "Number") + last, "Any", documented(doc, kind), body)
    if kind == "list":
        signature, body = typed(parameters, "NumberList"), f'call_of_list("{name}", {arguments}, nan=nan)'
    else:
        # The load comes first, the height of each sphere after all that have no default, where they are not level.
        signature = ["load: float", *typed(parameters, "float | NumberList"), "height: NumberList | None = None"]
        body = f'call_of_list("{name}", {arguments}, height, load, nan=nan)'
    return defined(name, signature + last, "float", documented(doc, "list"), body)


def typed(parameters: list, kind: str) -> list[str]:
    """Parameters of a signature, those without a default first."""
    ordered = sorted(parameters, key=lambda parameter: parameter[1] is not None)
    return [f"{one}: {kind}" + ("" if default is None else f" = {default!r}") for one, default in ordered]


def overload(name: str, parameters: list, last: list[str], kind: str, returns: str) -> str:
    """The types of a function for one kind of arguments, in one line."""
    signature = ", ".join(re.sub(" = .*", " = ...", one) for one in typed(parameters, kind) + last)
    return f"@overload\ndef {name}(*, {signature}) -> {returns}: ...\n"


def defined(name: str, signature: list[str], returns: str, doc: str, body: str) -> str:
    head = f"def {name}(*, {', '.join(signature)}) -> {returns}:\n"
    return head + textwrap.indent(doc, "    ", lambda line: bool(line.strip())) + f"    return {body}\n"


def documented(doc: str, kind: str) -> str:
    """A docstring with what Python adds to that of Rust: `nan`, Series, exceptions."""
    raises = "\n\nRaises\n------\nRequestError\n    A value outside of the domain, by its argument and element."
    if kind == "numbers":
        raises += "\n    Arguments whose shapes or indexes do not go together."
    text, _, references = doc.partition("\n\nReferences\n")
    text = with_nan(text.rstrip().replace(*RETURNS.get(kind, ("", ""))), kind)
    return '"""' + text + raises + ("\n\nReferences\n" + references.rstrip() if references else "") + '\n"""\n'


def with_nan(text: str, kind: str, indent: str = "") -> str:
    """A docstring with the parameter `nan` as the last one."""
    before, heading, after = text.partition(f"\n\n{indent}Returns\n")
    if not heading:
        raise SystemExit(f"error: a docstring says nothing of what is returned: {text}")
    parameter = '\nnan : {"raise", "propagate"}, default "raise"\n    ' + f'Whether NaN is an error. With "propagate", {NAN_HELP[kind]}'
    return before + parameter.replace("\n", "\n" + indent) + heading + after


if __name__ == "__main__":
    sys.exit(main())
