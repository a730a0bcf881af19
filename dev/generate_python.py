#!/usr/bin/env python3
"""Writes files of python/osim_contact_scale/ from the schemas of requests and results.

_verbs.py has a typed function with a docstring for each verb; _option_names.py the names of options that a table may have as columns, and of
those that name files; _answer_fields.py the types of the fields of answers. Of __init__.py only the names of the verbs are written.

    python3 dev/generate_python.py           writes them
    python3 dev/generate_python.py --check   fails where they differ, as after a new option in Rust
"""

import difflib
import json
import keyword
import re
import sys
import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from request_schemas import Field, Verb, verbs

TOP = Path(__file__).resolve().parent.parent
FOLDER = TOP / "python" / "osim_contact_scale"
RESULTS = TOP / "schemas" / "results"

WRITTEN = "a plan is written by Result.write"
NOT_FOR_PYTHON = "Python shows results itself, and has no exit status"
MANY = "these are for many models at once: rescale_many and many have them"
# Groups of fields that are no keywords, with the reason. How results are shown is none of any function.
GROUPS_LEFT_OUT = {
    **{key: {"output": WRITTEN, "many": MANY} for key in ("change", "fit")},
    "plot": {"output": "Figure.save"},
    "reproduce": {"output": "Reproduction has the table, plot the figures"},
}
# Single fields that are no keywords, with the reason.
LEFT_OUT = {
    **{key: {"dry_run": "a plan writes nothing", "report": "Result.report"} for key in ("change", "fit")},
    "batch": {"output": "a column of the table", "geometry_output": "a column of the table"},
}

# OpenSim's properties, which `set` takes by their names.
PROPERTIES = (
    "stiffness", "dissipation", "static_friction", "dynamic_friction", "viscous_friction", "transition_velocity",
    "constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing", "radius",
)

# Keywords that the schemas leave open, and that the program asks for in every call.
NEEDED = {"rescale": {"target_mass"}}
# Fields of answers that are properties of the classes in _answers.py.
PROPERTIES_OF_ANSWERS = {"series"}
# Types that say more than the schemas.
TYPES = {
    "body_scale": "str | Sequence[str] | Mapping[str, float | Sequence[float]]",
    "grid": "str | Sequence[str] | Mapping[str, float | str | Sequence[object]]",
    "keep": "Property | Sequence[Property]",
    "only": "Property | Sequence[Property]",
    "yes": "Question | Sequence[Question]",
}
# Fields that are files for the command, and tables too for Python.
TABLES = {
    ("fit", "motion"): "StrPath | TableLike | Sequence[StrPath | TableLike]",
    ("fit", "plates"): "StrPath | TableLike | Sequence[StrPath | TableLike]",
    ("motion", "plates"): "StrPath | TableLike",
    ("plot", "table"): "StrPath | TableLike",
}


@dataclass(frozen=True)
class Form:
    """A way to call a verb, as type checkers see it."""

    returns: str
    # Types of parameters without a keyword, where they are others than those of the whole verb.
    positional: Mapping[str, str] = field(default_factory=dict)
    # Keywords that this way needs, and those that it does not have.
    needed: tuple[str, ...] = ()
    without: tuple[str, ...] = ()


@dataclass(frozen=True)
class Shape:
    """How a verb is called in Python."""

    group: str
    # Parameters without a keyword: their name, type, default and meaning, and the field that each is.
    positional: tuple[tuple[str, str, str, str, str], ...]
    returns: str
    returned: str
    body: str
    forms: tuple[Form, ...] = ()


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
            "Result | DesignSheet", "The plan, or the quantities where no model is given.", "design",
            (Form("DesignSheet", {"source": "None"}), Form("Result", {"source": "Source"}))),
        "drop-test": Shape(
            "drop-test", (("subject", "Source | None", "None", "A model as for `rescale`, or the name of a preset.", "subject"),),
            "DropTest", "What happens, and the motion as `series`.", "drop_test"),
        "motion": Shape(
            "motion", (SOURCE_OF_SUBJECT, ("recording", "StrPath | TableLike", "", "Coordinates over time: a path (.mot, .sto), or a table with a column `time` and one for each coordinate, in rad and m.", "motion")),
            "Motion", "Each foot and sphere beside the plates, and all frames as `rows`.", "motion"),
        "fit": Shape(
            "fit", (("measured", "StrPath | TableLike | Source", "", "Measured indentation and force: a path (.csv), or a table with columns. With `motion`, the model as for `rescale`.", "file"),),
            "Fit | Result", "A `Fit`: the parameters with their uncertainty. With `motion`, a `Result`: the plan for the model.", "fit",
            (Form("Fit", {"measured": "StrPath | TableLike"}, without=("motion",)), Form("Result", {"measured": "Source"}, needed=("motion",)))),
        "plot": Shape(
            "plot", (("kind", "KIND", "", "What to draw.", "kind"), ("*models", "Source", "", "Models or presets, overlaid in one figure.", "models")),
            "Figure", "The figure, which a notebook shows.", "plot"),
        "presets": Shape(
            "presets", (("name", "str | None", "None", "One preset; all without it.", "name"),),
            "Presets", "Published contacts, and one's own: a list.", "presets"),
        "explain": Shape(
            "explain", (("*topics", "str", "", "Equations, quantities, codes of findings and errors; none lists all.", "topics"),),
            "list[Explanation]", "Each with its text.", "explain"),
        "reproduce": Shape("reproduce", (), "Reproduction", "Table 1 of the paper, as printed and computed.", "reproduce"),
        "sweep": Shape(
            "sweep", (("source", "StrPath", "", "Path of a model.", "model"),),
            "Sweep", "The variants, and the table of what is in which file.", "sweep",
            (Form("Sweep", needed=("grid",), without=("ladder", "soft")), Form("Sweep", needed=("ladder", "indentation"), without=("grid",)))),
        "batch": Shape(
            "batch", (("table", "StrPath | TableLike | Polars", "", "A DataFrame of pandas, polars or another library, a dictionary of columns, a list of dictionaries, or the path of a table (.csv). One row per model, with columns named like the keywords of the verbs. A missing value is an empty cell.", "manifest"),),
            "Table | Polars", "A row for each model: the user's own columns, what was done, old and new values, errors. A DataFrame with the index of the table; one of polars where the table is; without pandas a list of dictionaries.", "batch",
            (Form("PolarsTable", {"table": "PolarsTable"}), Form("Table", {"table": "StrPath | TableLike"}))),
    }
    return shapes.get(verb.name, CHANGE)


def main() -> int:
    is_check, differs = "--check" in sys.argv[1:], False
    files = {"_verbs.py": module(), "_option_names.py": options(), "_answer_fields.py": answer_fields(), "__init__.py": package()}
    for name, text in files.items():
        path = FOLDER / name
        if not is_check:
            path.write_text(text, encoding="utf-8")
            continue
        there = path.read_text(encoding="utf-8") if path.exists() else ""
        diff = difflib.unified_diff(there.splitlines(), text.splitlines(), name, "from the schemas", lineterm="")
        lines = list(diff)
        if lines:
            print("\n".join(lines), f"\n{name} is out of date: run python3 dev/generate_python.py", sep="\n")
            differs = True
    return 1 if differs else 0


def module() -> str:
    functions = [function(verb, shape_of(verb)) for verb in verbs()]
    names = [f'    "{name}",' for name in sorted(exported_verbs())]
    return "\n".join([HEAD, "__all__ = [", *names, "]", "", "\n\n".join(functions)])


def exported_verbs() -> set[str]:
    """Names of the verbs but `set`: `from ... import *` would put it in the place of Python's own."""
    return {name_of(verb) for verb in verbs() if verb.name != "set"}


def package() -> str:
    """The package, with the verbs among what it imports and exports."""
    text, verbs_now = (FOLDER / "__init__.py").read_text(encoding="utf-8"), exported_verbs()
    head, imported, rest = re.split(r"(?s)(?<=_verbs import \(\n)(.*?)(?=    \)\n)", text)
    middle, exported, rest = re.split(r"(?s)(?<=__all__ = \[\n)(.*?)(?=\]\n)", rest)
    others = {*re.findall(r"\w+", exported)} - {*re.findall(r"\w+", imported)}
    imported = "".join(f"        {name},\n" for name in sorted(verbs_now))
    exported = "".join(f'    "{name}",\n' for name in sorted(others | verbs_now))
    return f"{head}{imported}{middle}{exported}{rest}"


def options() -> str:
    changing = [verb for verb in verbs() if verb.changes]
    fields_by_name = {field.name: field for verb in changing for field in verb.fields}
    run_options = {name for name, field in fields_by_name.items() if field.is_of_run}
    parts = {
        "ROW_OPTIONS": (set(fields_by_name) - run_options - {"models", "file"} | {"model", "set", "verb"}, "Options that a row of a table has as columns."),
        "RUN_OPTIONS": (run_options, "Options of a whole run, which no row can have."),
        "PATHS": ({field.name for verb in verbs() for field in verb.fields if "path" in field.kinds}, "Options that name files or folders."),
    }
    sets = []
    for name, (fields, meaning) in parts.items():
        words = ", ".join(f'"{field}"' for field in sorted(fields))
        wrapped = textwrap.fill(words, 118, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
        sets.append(f"#: {meaning}\n{name} = frozenset({{\n{wrapped},\n}})\n")
    questions = next(field.choices for field in changing[0].fields if field.name == "yes")
    many_verbs = [verb.name for verb in sorted(changing, key=lambda verb: verb.changes) if verb.positional == ("models",)]
    words = {
        "Property": ("OpenSim's properties that verbs change.", PROPERTIES),
        "Question": ("Codes of questions, which `yes` answers.", questions),
        "ChangingVerb": ("Verbs that change any number of models.", many_verbs),
    }
    return OPTIONS_HEAD + "\n".join([*(literal(name, *of) for name, of in words.items()), *sets])


def answer_fields() -> str:
    """A class for each answer with the types of its fields, and one for each record in them."""
    answers = {"DropTest": "drop-test", "Motion": "motion", "Fit": "fit", "DesignSheet": "design", "Preset": "preset", "Reproduction": "reproduction", "Explanation": "explanation"}
    records, parts = {}, []
    for name, result in answers.items():
        schema = json.loads((RESULTS / f"{result}.schema.json").read_text(encoding="utf-8"))
        for record, definition in schema.get("$defs", {}).items():
            records[record] = class_of(f"{record}(TypedDict)", field_types([definition]))
        types = field_types(schema.get("oneOf", [schema]))
        types = {field_name: kind for field_name, kind in types.items() if field_name not in PROPERTIES_OF_ANSWERS}
        if name == "DesignSheet":
            types |= dict.fromkeys(schema["$defs"]["DesignFigure"]["properties"]["name"]["enum"], "float")
        parts.append(class_of(f"{name}Fields", types, "    __slots__ = ()", ""))
    return "\n\n".join([ANSWER_FIELDS_HEAD, *records.values(), *parts])


def field_types(variants: Iterable[Mapping[str, Any]]) -> dict[str, str]:
    """The type of each field; a field of several variants has the types of all."""
    types: dict[str, dict[str, None]] = {}
    for variant in variants:
        for name, schema in variant["properties"].items():
            # Names of files that are not UTF-8 have their bytes beside them: fields that are almost never there.
            if name != "schema_version" and not name.endswith("_bytes"):
                kind = field_type(schema)
                # A field that is not required is left out in place of null.
                types.setdefault(name, {})[kind if name in variant["required"] else kind.removesuffix(" | None")] = None
    return {name: " | ".join(of_variants) for name, of_variants in types.items()}


def field_type(schema: Mapping[str, Any]) -> str:
    kinds = {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "null": "None"}
    if "$ref" in schema:
        return schema["$ref"].removeprefix("#/$defs/")
    if "anyOf" in schema:
        return " | ".join(map(field_type, schema["anyOf"]))
    words = [schema["type"]] if isinstance(schema["type"], str) else schema["type"]
    return " | ".join(f"list[{field_type(schema['items'])}]" if word == "array" else kinds[word] for word in words)


def class_of(name: str, types: Mapping[str, str], *first: str) -> str:
    return "\n".join([f"class {name}:", *first, *(f"    {field_name}: {kind}" for field_name, kind in types.items()), ""])


def literal(name: str, meaning: str, words: Iterable[str]) -> str:
    wrapped = textwrap.fill(", ".join(f'"{word}"' for word in words), 118, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
    return f"#: {meaning}\n{name} = Literal[\n{wrapped},\n]\n"


OPTIONS_HEAD = '''"""Names of options. Written by dev/generate_python.py from the schemas of requests: do not edit."""

from __future__ import annotations

from typing import Literal

'''

ANSWER_FIELDS_HEAD = '''"""Types of the fields of answers. Written by dev/generate_python.py from the schemas of results: do not edit."""

from __future__ import annotations

from typing import TypedDict
'''

HEAD = '''"""The verbs as functions. Written by dev/generate_python.py from the schemas of requests: do not edit."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from typing import Literal, overload

from . import _run
from ._answers import DesignSheet, DropTest, Explanation, Fit, Motion, Presets, Reproduction
from ._figure import Figure
from ._option_names import Property, Question
from ._result import Result
from ._survey import Check, Inspection
from ._sweep import Sweep
from .types import Polars, PolarsTable, Progress, Source, Sources, StrPath, Table, TableLike
'''


# Types whose names say too little to people.
RETURNS = {"Table | Polars": "pandas.DataFrame, polars.DataFrame or list of dict"}

# What runs as a test, in the project's folder.
HUMAN = '"fixtures/table1/human_62kg_smooth_sphere.osim"'
SCALED, GENERIC = '"fixtures/scale_tool/scaled_smooth.osim"', '"fixtures/scale_tool/generic_smooth.osim"'
EXAMPLES = {
    "add": [
        f'>>> len(ocs.add("fixtures/feet/human_40000.osim", from_={HUMAN}, radius="isometric").objects)',
        "25",
    ],
    "batch": [
        f'>>> table = [{{"model": {HUMAN}, "target_mass": 70, "age": 31}}]',
        '>>> ocs.rescale_many(table, keep=["age"], dry_run=True)[["age", "status", "target_mass_kg"]].values.tolist()',
        "[[31, 'dry-run', 70.0]]",
    ],
    "check": [f">>> ocs.check({SCALED}, from_={GENERIC}).findings[0].code", "'spheres-left-behind'"],
    "convert": [f'>>> ocs.convert({HUMAN}, to="hunt-crossley")', f"<Result of convert: {HUMAN[1:-1]}: 24 objects to change>"],
    "design": [
        ">>> round(ocs.design(mass=62, spheres=6, radius=0.032, indentation=0.16, gravity=9.81).stiffness)",
        "3281223",
        f">>> ocs.design({HUMAN}, indentation=0.16)",
        f"<Result of design: {HUMAN[1:-1]}: 12 numbers to change>",
    ],
    "drop-test": ['>>> round(ocs.drop_test("falisse2022").peak_force_bw, 3)', "2.492"],
    "explain": ['>>> ocs.explain("13")[0].title', "'Coefficient of restitution, approximate'"],
    "fit": ['>>> ocs.fit("fixtures/measured/heel_pad.csv", radius=0.03, indentation_unit="mm").frame()["name"][1]', "'stiffness'"],
    "inspect": [f'>>> ocs.inspect({HUMAN})[0]["mass_kg"]', "62.0"],
    "motion": ['>>> walk = ocs.motion("fixtures/motion/walker.osim", "fixtures/motion/walk.mot")', ">>> len(walk.rows)", "964"],
    "note": [f'>>> ocs.note({HUMAN}, contacts_mass=60).target_mass_kg', "60.0"],
    "plot": ['>>> ocs.plot("drop", "falisse2022")', "<Figure: Drop test: falisse2022: show it in a notebook, or write it with save()>"],
    "presets": ['>>> ocs.presets("falisse2022")[0].mass_kg', "62.0"],
    "remove": [f">>> ocs.remove({HUMAN})", f"<Result of remove: {HUMAN[1:-1]}: 24 objects to change>"],
    "reproduce": [">>> ocs.reproduce()", "<Reproduction: numbers=42, within_last_digit=41>"],
    "rescale": [f">>> ocs.rescale({HUMAN}, target_mass=1190)", f"<Result of rescale: {HUMAN[1:-1]}: 72 numbers to change>"],
    "set": [f'>>> ocs.set({HUMAN}, stiffness="x2", dissipation=1)', f"<Result of set: {HUMAN[1:-1]}: 24 numbers to change>"],
    "sweep": [f'>>> len(ocs.sweep({HUMAN}, grid={{"stiffness": "x0.1..x10/3"}}, dry_run=True))', "3"],
    "transfer": [f">>> ocs.transfer({SCALED}, from_={GENERIC}, follow_bodies=True, level=True)", f"<Result of transfer: {SCALED[1:-1]}: 42 numbers to change>"],
}


def name_of(verb: Verb) -> str:
    return "rescale_many" if verb.name == "batch" else verb.name.replace("-", "_")


def keyword_of(name: str) -> str:
    return f"{name}_" if keyword.iskeyword(name) else name


def fields_of(verb: Verb, shape: Shape) -> list[Field]:
    left_out, groups = LEFT_OUT.get(shape.group, {}), {"shown": NOT_FOR_PYTHON, **GROUPS_LEFT_OUT.get(shape.group, {})}
    unknown = [name for name in left_out if name not in {field.name for field in verb.fields}]
    if unknown:
        raise SystemExit(f"{verb.name} has no {', '.join(unknown)}: take it out of LEFT_OUT")
    idle = set(GROUPS_LEFT_OUT.get(shape.group, {})) - {field.group for field in verb.fields}
    if idle:
        raise SystemExit(f"{verb.name} has no field of {', '.join(sorted(idle))}: take it out of GROUPS_LEFT_OUT")
    positional = {field for *_, field in shape.positional}
    if positional != set(verb.positional):
        raise SystemExit(f"{verb.name} has no names for {', '.join(verb.positional)}: put them into its shape")
    offered = [field for field in verb.fields if field.name not in left_out and field.group not in groups]
    return [field for field in offered if field.name not in positional and field.name != "set"]


def type_of(verb: Verb, field: Field) -> str:
    if (verb.name, field.name) in TABLES or field.name in TYPES:
        return TABLES.get((verb.name, field.name)) or TYPES[field.name]
    if field.choices:
        one = "Literal[" + ", ".join(f'"{choice}"' for choice in field.choices) + "]"
        return f"{one} | Sequence[{one}]" if "list" in field.kinds else one
    if "boolean" in field.kinds:
        return "bool"
    python_types = {"path": "StrPath", "number": "float", "integer": "int", "string": "str"}
    kinds = field.kinds - {"list", "object"}
    if "path" in kinds:
        kinds -= {"string"}
        python_types["path"] = "Source" if field.name in ("from", "geometry", "model") else "StrPath"
    names = [python_types[kind] for kind in ("path", "number", "integer", "string") if kind in kinds]
    if "list" in field.kinds:
        if len(names) != 1:
            raise SystemExit(f"{verb.name}: items of {field.name} are of several kinds: say its type in TYPES")
        names.append(f"Sequence[{names[0]}]")
    if "object" in field.kinds:
        raise SystemExit(f"{verb.name}: {field.name} is a dictionary: say its type in TYPES")
    return " | ".join(names)


def described(field: Field) -> str:
    text = field.description.replace("; may be repeated", "; one or several in a list").replace(", separated by commas", "")
    text = re.sub(r"`(from|class)`", r"`\1_`", text)
    text = text.replace("Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input", "")
    return text + ("" if text.endswith((".", "]", ")")) else ".")


@dataclass(frozen=True)
class Parameter:
    """A parameter of a function."""

    name: str
    kind: str
    default: str = ""
    # How the docstring calls its kind, where that is not its type.
    readable: str = ""
    meaning: str = ""

    def __str__(self) -> str:
        kind = f"{self.kind} | None" if self.default == "None" and not self.kind.endswith("None") else self.kind
        return f"{self.name}: {kind}" + (f" = {self.default}" if self.default else "")


def function(verb: Verb, shape: Shape) -> str:
    fields = fields_of(verb, shape)
    positional = [positional_of(verb, *one) for one in shape.positional]
    keyword_parameters = [keyword_parameter(verb, field) for field in fields]
    extra = own_keywords(shape)
    if shape.group == "batch":
        extra, keyword_parameters = extra[1:], [extra[0], *keyword_parameters]
    properties = [Parameter(name, "float | str", "None") for name in PROPERTIES] if verb.name == "set" else []
    keywords = properties + keyword_parameters + extra
    documented = [(f"{one.name.lstrip('*')} : {one.readable or readable(one.kind)}" + (", optional" if one.default else ""), one.meaning) for one in positional]
    if properties:
        documented.append((f"{', '.join(PROPERTIES)} : float or str, optional", 'The value of this property, or a factor such as "x2".'))
    documented += [(f"{one.name} : {one.readable or readable(one.kind)}" + (", optional" if one.default else ""), one.meaning) for one in keyword_parameters + extra]
    passed = "{" + ", ".join(passed_on(field) for field in fields) + "}"
    if properties:
        assignments = ", ".join(f'"{name}": {name}' for name in PROPERTIES)
        passed = "{" + ", ".join([f'"set": _run.assignments({{{assignments}}})', *map(passed_on, fields)]) + "}"
    overloads = [overload_of(verb, form, positional, keywords) for form in shape.forms]
    words = listed(positional, keywords)
    head = f"def {name_of(verb)}(\n" + "".join(f"    {word},\n" for word in words) + f") -> {shape.returns}:\n"
    if not words:
        head = f"def {name_of(verb)}() -> {shape.returns}:\n"
    return "".join(overloads) + head + docstring(verb, shape, documented) + body(verb, shape, passed)


def positional_of(verb: Verb, name: str, kind: str, default: str, meaning: str, field_name: str) -> Parameter:
    if kind == "KIND":
        kind = type_of(verb, next(field for field in verb.fields if field.name == field_name))
    return Parameter(name, kind, default, meaning=meaning)


def keyword_parameter(verb: Verb, field: Field) -> Parameter:
    kind = type_of(verb, field)
    is_needed = field.name in verb.required | NEEDED.get(verb.name, set())
    default = "False" if kind == "bool" else "" if is_needed else "None"
    return Parameter(keyword_of(field.name), kind, default, meaning=described(field))


def own_keywords(shape: Shape) -> list[Parameter]:
    """Keywords that the command does not have, or has in another way."""
    extra = []
    if shape.group == "batch":
        extra.append(Parameter("keep", "bool | str | Sequence[Hashable]", "False", "bool, str or list of str", KEEP))
    if shape.group == "survey":
        extra.append(Parameter("jobs", "int", "None", meaning="Models to work on at once [default: one per processor]"))
    if shape.group in ("batch", "sweep", "survey"):
        extra.append(Parameter("progress", "Progress", "False", "bool or callable", "Show a bar (where tqdm is there), or call this with 1 and whether it failed for each model."))
    return extra


KEEP = (
    "Columns of the table that are yours: `keep=[\"age\", \"site\"]`, or True for all that are not options. They come first in the result, as "
    "they are in the table. A column whose name begins with # is yours without this. Any other that is not an option is an error."
)


def passed_on(field: Field) -> str:
    name = keyword_of(field.name)
    return f'"{field.name}": {name}' + (" or None" if "boolean" in field.kinds else "")


def listed(positional: list[Parameter], keywords: list[Parameter]) -> list[str]:
    """The parameters as a function has them."""
    has_star = any(one.name.startswith("*") for one in positional)
    parts = [*map(str, positional)]
    if positional and not has_star:
        parts.append("/")
    if keywords and not has_star:
        parts.append("*")
    return parts + [*map(str, keywords)]


def overload_of(verb: Verb, form: Form, positional: list[Parameter], keywords: list[Parameter]) -> str:
    unknown = {*form.needed, *form.without} - {one.name for one in keywords}
    if unknown:
        raise SystemExit(f"{verb.name} has no {', '.join(sorted(unknown))}: take it out of its forms")
    extra = [
        Parameter(one.name, kind, one.default if kind == "None" else "") if (kind := form.positional.get(one.name)) else one
        for one in positional
    ]
    keyword_parameters = [
        Parameter(one.name, one.kind) if one.name in form.needed else Parameter(one.name, "None", "None") if one.name in form.without else one
        for one in keywords
    ]
    return f"@overload\ndef {name_of(verb)}({', '.join(listed(extra, keyword_parameters))}) -> {form.returns}: ...\n"


def readable(kind: str) -> str:
    """A type as people say it."""
    if kind.startswith("Literal[") and " | " not in kind:
        return "{" + kind[8:-1] + "}"
    parts = [part for part in kinds_in(kind) if part != "None"]
    if len(parts) > 1:
        return " or ".join(filter(None, map(readable, parts)))
    if kind.startswith("Sequence["):
        return "list of " + readable(kind[9:-1])
    names = {"StrPath": "path", "Source": "path, bytes or opensim.Model", "Sources": "path or list", "TableLike": "table", "Polars": "", "Property": "str", "Question": "str"}
    return "dict" if kind.startswith("Mapping[") else names.get(parts[0], parts[0])


def kinds_in(kind: str) -> list[str]:
    """The kinds that a type is one of; those within brackets are parts of one."""
    parts, depth = [""], 0
    for piece in re.split(r"( \| |\[|\])", kind):
        depth += (piece == "[") - (piece == "]")
        if piece == " | " and not depth:
            parts.append("")
        else:
            parts[-1] += piece
    return parts


def docstring(verb: Verb, shape: Shape, documented: list[tuple[str, str]]) -> str:
    lines = ['"""' + " ".join(verb.summary.split()), ""]
    if documented:
        lines += ["Parameters", "----------"]
        for name, meaning in documented:
            lines += [name, *textwrap.wrap(meaning, 110, initial_indent="    ", subsequent_indent="    ")]
        lines.append("")
    returned = textwrap.wrap(shape.returned, 110, initial_indent="    ", subsequent_indent="    ", break_on_hyphens=False)
    lines += ["Returns", "-------", RETURNS.get(shape.returns, shape.returns), *returned, ""]
    lines += ["Raises", "------", "ContactScaleError", "    It cannot be done: the subclass says why.", ""]
    lines += ["Examples", "--------", *EXAMPLES[verb.name], '"""']
    return textwrap.indent("\n".join(lines), "    ", lambda line: bool(line.strip())) + "\n"


def body(verb: Verb, shape: Shape, keywords: str) -> str:
    arguments = [name.lstrip("*") for name, *_ in shape.positional]
    if shape.body in ("plan", "survey"):
        arguments = [f'"{verb.name}"', *arguments]
    if shape.body == "batch":
        arguments.append("keep")
    line_of_keywords = ""
    if shape.body == "explain":
        arguments.append(keywords)
    elif shape.body != "reproduce":
        # In a line of its own: a traceback shows the line of the call to people whose model is wrong.
        line_of_keywords = f"    keywords = {keywords}\n"
        arguments.append("keywords")
    if shape.group == "survey":
        arguments.append("jobs")
    if shape.group in ("batch", "sweep", "survey"):
        arguments.append("progress")
    call = f"_run.{shape.body}({', '.join(arguments)})"
    # Its result has one of several types, which depend on the verb or on what is given.
    cast = "  # type: ignore[no-any-return]" if shape.body in ("survey", "design", "batch") else ""
    return f"{line_of_keywords}    return {call}{cast}\n"


if __name__ == "__main__":
    sys.exit(main())
