#!/usr/bin/env python3
"""Writes python/osim_contact_scale/_verbs.py: a typed function with a docstring for each verb, from the schemas of requests.

    python3 dev/generate_python.py           writes it
    python3 dev/generate_python.py --check   fails where it differs, as after a new option in Rust
"""

import difflib
import keyword
import re
import sys
import textwrap
from dataclasses import dataclass
from pathlib import Path

from request_schemas import Field, Verb, verbs

OUTPUT = Path(__file__).resolve().parent.parent / "python" / "osim_contact_scale" / "_verbs.py"

WRITTEN = "a plan is written by Result.write"
SHOWN = "Python shows results itself, and has no exit status"
MANY = "these are for many models at once: rescale_many and many have them"
# Groups of fields that are no keywords, with the reason. How results are shown is none of any function.
GROUPS_LEFT_OUT = {
    "change": {"output": WRITTEN, "many": MANY},
    "fit": {"output": WRITTEN, "many": MANY},
    "plot": {"output": "Figure.save"},
    "reproduce": {"output": "Reproduction has the table, plot the figures"},
}
# Single fields that are no keywords, with the reason.
LEFT_OUT = {
    "change": {"dry_run": "a plan writes nothing", "report": "Result.report"},
    "fit": {"dry_run": "a plan writes nothing", "report": "Result.report"},
    "batch": {"output": "a column of the table", "geometry_output": "a column of the table"},
}

# OpenSim's properties, which `set` takes by their names.
PROPERTIES = (
    "stiffness", "dissipation", "static_friction", "dynamic_friction", "viscous_friction", "transition_velocity",
    "constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing", "radius",
)


@dataclass(frozen=True)
class Shape:
    """How a verb is called in Python."""

    group: str
    # Parameters without a keyword: their name, type, default and meaning, and the field that each is.
    positional: tuple[tuple[str, str, str, str, str], ...]
    returns: str
    returned: str
    body: str


SOURCE = ("source", "Source", "", "Path of a model (.osim) or ForceSet (.xml), its bytes, a Result, or an `opensim.Model`.", "models")
SOURCE_OF_SUBJECT = (*SOURCE[:4], "subject")
CHANGE = Shape("change", (SOURCE,), "Result", "The plan. Nothing is written before `Result.write`.", "plan")


def shape_of(verb: Verb) -> Shape:
    sources = ("sources", "Sources", "", "One or several: paths of models or folders, bytes, results, live models.", "models")
    shapes = {
        "inspect": Shape("survey", (sources,), "Inspection", "The models, their spheres and forces as tables.", "survey"),
        "check": Shape("survey", (sources,), "Check", "What is wrong with them, each with its remedy.", "survey"),
        "design": Shape(
            "change", (("source", "Source | None", "None", "The model as for `rescale`; without one this is a calculator.", "models"),),
            "Result | DesignSheet", "The plan, or the quantities where no model is given.", "design"),
        "drop-test": Shape(
            "drop-test", (("subject", "Source | None", "None", "A model as for `rescale`, or the name of a preset.", "subject"),),
            "DropTest", "What happens, and the motion as `series`.", "drop_test"),
        "motion": Shape(
            "motion", (SOURCE_OF_SUBJECT, ("recording", "Any", "", "Coordinates over time: a path (.mot, .sto), or a table with a column `time` and one for each coordinate, in rad and m.", "motion")),
            "Motion", "Each foot and sphere beside the plates, and all frames as `rows`.", "motion"),
        "fit": Shape(
            "fit", (("measured", "Any", "", "Measured indentation and force: a path (.csv), or a table with columns. With `motion`, the model as for `rescale`.", "file"),),
            "Fit | Result", "A `Fit`: the parameters with their uncertainty. With `motion`, a `Result`: the plan for the model.", "fit"),
        "plot": Shape(
            "plot", (("kind", "KIND", "", "What to draw.", "kind"), ("*models", "Source", "", "Models or presets, overlaid in one figure.", "models")),
            "Figure", "The figure, which a notebook shows.", "plot"),
        "presets": Shape(
            "presets", (("name", "str | None", "None", "One preset; all without it.", "name"),),
            "list[Preset]", "Published contacts, and one's own.", "presets"),
        "explain": Shape(
            "explain", (("*topics", "str", "", "Equations, quantities, codes of warnings and errors; none lists all.", "topics"),),
            "list[Explanation]", "Each with its text.", "explain"),
        "reproduce": Shape("reproduce", (), "Reproduction", "Table 1 of the paper, as printed and computed.", "reproduce"),
        "sweep": Shape(
            "sweep", (("source", "StrPath", "", "Path of a model.", "model"),),
            "Sweep", "The variants, and the table of what is in which file.", "sweep"),
        "batch": Shape(
            "batch", (("table", "Any", "", "A DataFrame, a dictionary of columns, a list of dictionaries, or the path of a table (.csv). One row per model, with columns named like the keywords of the verbs.", "manifest"),),
            "Any", "A row for each model: what was done, old and new values, errors. A DataFrame where pandas is there.", "batch"),
    }
    return shapes.get(verb.name, CHANGE)


def main() -> int:
    text = module()
    if "--check" not in sys.argv[1:]:
        OUTPUT.write_text(text, encoding="utf-8")
        return 0
    there = OUTPUT.read_text(encoding="utf-8")
    diff = difflib.unified_diff(there.splitlines(), text.splitlines(), str(OUTPUT.name), "from the schemas", lineterm="")
    lines = list(diff)
    if lines:
        print("\n".join(lines), "\n_verbs.py is out of date: run python3 dev/generate_python.py", sep="\n")
    return 1 if lines else 0


def module() -> str:
    functions = [function(verb, shape_of(verb)) for verb in verbs()]
    names = [f'    "{name_of(verb)}",' for verb in sorted(verbs(), key=name_of)]
    return "\n".join([HEAD, "__all__ = [", *names, "]", "", "\n\n".join(functions)])


HEAD = '''"""The verbs as functions. Written by dev/generate_python.py from the schemas of requests: do not edit."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Literal

from . import _run
from ._answers import DesignSheet, DropTest, Explanation, Fit, Motion, Preset, Reproduction
from ._figure import Figure
from ._progress import Progress
from ._request import Source
from ._result import Result
from ._survey import Check, Inspection, Sources
from ._sweep import Sweep

StrPath = str | os.PathLike[str]
'''


def name_of(verb: Verb) -> str:
    return "rescale_many" if verb.name == "batch" else verb.name.replace("-", "_")


def keyword_of(name: str) -> str:
    return f"{name}_" if keyword.iskeyword(name) else name


def fields_of(verb: Verb, shape: Shape) -> list[Field]:
    left_out, groups = LEFT_OUT.get(shape.group, {}), {"shown": SHOWN, **GROUPS_LEFT_OUT.get(shape.group, {})}
    unknown = [name for name in left_out if name not in {field.name for field in verb.fields}]
    if unknown:
        raise SystemExit(f"{verb.name} has no {', '.join(unknown)}: take it out of LEFT_OUT")
    idle = set(GROUPS_LEFT_OUT.get(shape.group, {})) - {field.group for field in verb.fields}
    if idle:
        raise SystemExit(f"{verb.name} has no field of {', '.join(sorted(idle))}: take it out of GROUPS_LEFT_OUT")
    positional = {field for *_, field in shape.positional}
    if positional != set(verb.positional):
        raise SystemExit(f"{verb.name} has no names for {', '.join(verb.positional)}: put them into its shape")
    said = [field for field in verb.fields if field.name not in left_out and field.group not in groups]
    return [field for field in said if field.name not in positional and field.name != "set"]


def type_of(field: Field) -> str:
    if field.choices:
        one = "Literal[" + ", ".join(f'"{choice}"' for choice in field.choices) + "]"
        return f"{one} | Sequence[{one}]" if "list" in field.kinds else one
    if "boolean" in field.kinds:
        return "bool"
    own = {"path": "StrPath", "number": "float", "integer": "int", "string": "str"}
    kinds = field.kinds - {"list", "object"}
    if "path" in kinds:
        kinds -= {"string"}
        own["path"] = "Source" if field.name in ("from", "geometry", "model") else "StrPath"
    names = [own[kind] for kind in ("path", "number", "integer", "string") if kind in kinds]
    if "list" in field.kinds:
        names.append(f"Sequence[{names[0] if len(names) == 1 else 'Any'}]")
    if "object" in field.kinds:
        names.append("Mapping[str, Any]")
    return " | ".join(names)


def described(field: Field) -> str:
    text = field.description.replace("; may be repeated", "; one or several in a list").replace(", separated by commas", "")
    text = re.sub(r"`(from|class)`", r"`\1_`", text)
    text = text.replace("Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input", "")
    return text + ("" if text.endswith((".", "]", ")")) else ".")


def function(verb: Verb, shape: Shape) -> str:
    fields = fields_of(verb, shape)
    parameters, documented, passed = [], [], []
    for name, kind, default, meaning, field_name in shape.positional:
        if kind == "KIND":
            kind = type_of(next(field for field in verb.fields if field.name == field_name))
        parameters.append(f"{name}: {kind}" + (f" = {default}" if default else ""))
        optional = ", optional" if default else ""
        documented.append((name.lstrip("*") + " : " + readable(kind) + optional, meaning))
    stars = any(name.startswith("*") for name, *_ in shape.positional)
    if shape.positional and not stars:
        parameters.append("/")
    if verb.name == "set":
        parameters += ["*"] + [f"{name}: float | str | None = None" for name in PROPERTIES]
        documented += [(f"{', '.join(PROPERTIES)} : float or str, optional", 'The value of this property, or a factor such as "x2".')]
    elif not stars and (fields or shape.group in ("batch", "sweep", "survey")):
        parameters.append("*")
    for field in fields:
        name, kind = keyword_of(field.name), type_of(field)
        parameters.append(f"{name}: bool = False" if kind == "bool" else f"{name}: {kind} | None = None")
        documented.append((f"{name} : {readable(kind)}, optional", described(field)))
        passed.append(f'"{field.name}": {name}' + (" or None" if kind == "bool" else ""))
    if shape.group == "survey":
        parameters.append("jobs: int | None = None")
        documented.append(("jobs : int, optional", "Models to work on at once [default: one per processor]"))
    if shape.group in ("batch", "sweep", "survey"):
        parameters.append("progress: Progress = False")
        documented.append(("progress : bool or callable, optional", "Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model."))
    head = f"def {name_of(verb)}(\n" + "".join(f"    {parameter},\n" for parameter in parameters) + f") -> {shape.returns}:\n"
    if not parameters:
        head = f"def {name_of(verb)}() -> {shape.returns}:\n"
    keywords = "{" + ", ".join(passed) + "}"
    if verb.name == "set":
        given = ", ".join(f'"{name}": {name}' for name in PROPERTIES)
        keywords = "{" + ", ".join([f'"set": _run.assignments({{{given}}})', *passed]) + "}"
    return head + docstring(verb, shape, documented) + body(verb, shape, keywords)


def readable(kind: str) -> str:
    """A type as people say it."""
    if kind.startswith("Literal[") and " | " not in kind:
        return "{" + kind[8:-1] + "}"
    parts = [part for part in kind.split(" | ") if part != "None"]
    if len(parts) > 1:
        return " or ".join(readable(part) for part in parts)
    if kind.startswith("Sequence["):
        return "list of " + readable(kind[9:-1]).replace("table or path", "values")
    names = {"StrPath": "path", "Source": "path, bytes or opensim.Model", "Sources": "path or list", "Any": "table or path"}
    return {**names, "Mapping[str, Any]": "dict"}.get(parts[0], parts[0])


def docstring(verb: Verb, shape: Shape, documented: list[tuple[str, str]]) -> str:
    lines = ['"""' + " ".join(verb.summary.split()), ""]
    if documented:
        lines += ["Parameters", "----------"]
        for name, meaning in documented:
            lines += [name, *textwrap.wrap(meaning, 110, initial_indent="    ", subsequent_indent="    ")]
        lines.append("")
    lines += ["Returns", "-------", shape.returns, f"    {shape.returned}", ""]
    lines += ["Raises", "------", "ContactScaleError", "    It cannot be done: the subclass says why.", '"""']
    return textwrap.indent("\n".join(lines), "    ", lambda line: bool(line.strip())) + "\n"


def body(verb: Verb, shape: Shape, keywords: str) -> str:
    arguments = [name.lstrip("*") for name, *_ in shape.positional]
    if shape.body == "plan":
        arguments = [f'"{verb.name}"', *arguments]
    if shape.body == "survey":
        arguments = [f'"{verb.name}"', *arguments]
    said = ""
    if shape.body == "explain":
        arguments.append(keywords)
    elif shape.body != "reproduce":
        # In a line of its own: a traceback shows the line of the call to people whose model is wrong.
        said = f"    keywords = {keywords}\n"
        arguments.append("keywords")
    if shape.group == "survey":
        arguments.append("jobs")
    if shape.group in ("batch", "sweep", "survey"):
        arguments.append("progress")
    call = f"_run.{shape.body}({', '.join(arguments)})"
    # Its result has one of several types, which depend on the verb or on what is given.
    cast = "  # type: ignore[no-any-return]" if shape.body in ("survey", "design") else ""
    return f"{said}    return {call}{cast}\n"


if __name__ == "__main__":
    sys.exit(main())
