"""Writes the functions of the MATLAB package, one for each verb, from the schemas of requests and results.

    python3 dev/generate_matlab.py [--check]

With --check nothing is written: it names the files that are not as they would be, and exits with 1.
Needs Python 3.9.
"""

import argparse
import json
import re
import sys
import textwrap
from pathlib import Path

import request_schemas
from matlab_texts import EXAMPLES, LEFT_OUT, NO_STANDARD_STREAMS, RESULTS, TABLES, WITHOUT

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "matlab/+osimcontact"
RESULT_SCHEMAS = ROOT / "schemas/results"
HEADER = "% Made by dev/generate_matlab.py from the schemas of requests and results: change those, and run it."
WIDTH = 100
#: The name of a field in MATLAB, where `errors` sounds as if the change had failed.
ERRORS_OF_FIT = {"errors": "fit_errors"}
OWN_FUNCTIONS = {
    "apply": "Make the changes of a plan in a live model of OpenSim's own bindings",
    "predsim": "Give a scaled model contacts that fit it, in a new file for PredSim",
    "program": "Say where the program is, or ask for it",
    "read_table": "Read a table (CSV) that the program wrote",
}


def function_name(verb):
    return verb.replace("-", "_")


def result_of(verb):
    """The schema in schemas/results/ of what a verb gives; None: it gives no JSON."""
    return RESULTS.get(verb.name, "change")


def quoted(text):
    return "'" + text.replace("'", "''") + "'"


def cell(texts):
    return "{" + ", ".join(map(quoted, texts)) + "}"


def comment(text, indent="", further=None):
    """Lines of help, which MATLAB shows without the percent sign."""
    further = indent if further is None else further
    lines = textwrap.wrap(text, WIDTH, initial_indent=indent, subsequent_indent=further,
                          break_long_words=False, break_on_hyphens=False)
    return ["%   " + line for line in lines]


def in_matlab(description, used):
    """The words of a description without what is only for a command line."""
    for phrase, instead in NO_STANDARD_STREAMS.items():
        if phrase in description:
            used.add(phrase)
            description = description.replace(phrase, instead)
    return description.replace("`", "")


def what_it_takes(verb, field):
    """`a number`, `true or false` ...: the values of an option in words."""
    if field.name == TABLES.get(verb.name):
        return "the name of a file, or a table, a struct array or a cell array"
    if field.choices:
        takes = " or ".join(quoted(choice) for choice in field.choices)
        takes += " or a cell array of these" if "list" in field.kinds else ""
        return takes + (" or a number" if "number" in field.kinds else "")
    words = [word for kind, word in [
        ("boolean", "true or false"), ("integer", "a whole number"), ("number", "a number"),
        ("object", "a struct or containers.Map"), ("string", "a text")] if kind in field.kinds]
    if "list" in field.kinds:
        words.append("a cell array of these" if len(words) > 1 else "a cell array of texts")
    return ", ".join(words[:-1]) + " or " + words[-1] if len(words) > 1 else words[0]


def default_of(field):
    # Where there is none, or where it depends on the model, the description says what holds.
    if field.default in (None, False) or field.default == [] or field.default == {} or "[default" in field.description:
        return ""
    value = quoted(field.default) if isinstance(field.default, str) else f"{field.default:g}"
    return f" [default: {value}]"


def described(verb, field, used):
    return f"{in_matlab(field.description, used)}{default_of(field)}. Takes {what_it_takes(verb, field)}."


def help_of(verb, verbs, options, used):
    name = function_name(verb.name)
    positional = list(verb.positional)
    fields = {field.name: field for field in verb.fields}
    lines = [f"%{name.upper()} {first_sentence(verb.summary)}"]
    arguments = ", ".join([argument.upper() for argument in positional] + ["NAME, VALUE, ..."])
    lines += comment(f"RESULTS = osimcontact.{name}({arguments})")
    remainder = " ".join(verb.summary.split())[len(first_sentence(verb.summary)):].strip()
    lines += comment(remainder) if remainder else []
    for argument in positional:
        optional = "" if argument in verb.required else " May be left out."
        lines += ["%"] + comment(f"{argument.upper()}: {described(verb, fields[argument], used)}{optional}", "", "    ")
    lines += ["%"] + comment("Options, each a NAME and a VALUE (target_mass and TargetMass are the same):")
    for field in options:
        needed = " Must be given." if field.name in verb.required else ""
        lines += comment(f"{field.name}: {described(verb, field, used)}{needed}", "  ", "      ")
    result = result_of(verb)
    if result:
        lines += comment("AsTable: true gives a table with a row for each result; the name of a list in the results, such as "
                         f"{quoted(a_list(result))}, one with a row for each of its entries. Columns without any value are "
                         "left out. In GNU Octave, which has no tables, a struct of columns.", "  ", "      ")
        fields = top_fields(result)
        lines += ["%"] + comment(f"RESULTS: an array of structs with the fields {', '.join(fields)}. "
                                 "docs/reference/json.md and schemas/ say what each holds; what is missing is NaN, '' or empty.")
    else:
        lines += ["%"] + comment("RESULTS: a struct with the fields output (the file) and text (remarks on it).")
    lines += ["%"] + comment("Example, in the folder of the program's archive:") + ["%       " + line for line in EXAMPLES[verb.name].strip().splitlines()]
    lines += ["%"] + comment("See also " + ", ".join(f"osimcontact.{other}" for other in related_functions(verb, verbs)) + ".")
    return lines


def first_sentence(text):
    return re.split(r"(?<=\.)\s", " ".join(text.split()))[0]


def related_functions(verb, verbs):
    changes = sorted((other for other in verbs if other.name not in RESULTS), key=lambda other: other.changes or len(verbs))
    group = list(RESULTS) if verb.name in RESULTS else [other.name for other in changes]
    return [function_name(other) for other in group if other != verb.name] + ["program"]


def a_list(result):
    """A list in a result that is a table of its own, for an example."""
    by_key = {"change": "changes", "check": "findings", "drop-test": "series", "explanation": "formulas", "inspection": "spheres",
             "motion": "feet.spheres", "reproduction": "table1.values"}
    return by_key.get(result, "error")


def top_fields(result):
    schema = json.loads((RESULT_SCHEMAS / f"{result}.schema.json").read_text(encoding="utf-8"))
    variants = schema.get("oneOf", [schema])
    names = list(dict.fromkeys(name for variant in variants for name in variant["properties"]))
    return [ERRORS_OF_FIT.get(name, name) for name in names if name != "schema_version" and not name.endswith("_bytes")]


def verb_file(verb, verbs, used):
    options = [f for f in verb.fields if f.group != LEFT_OUT and f.name not in verb.positional]
    text = [f"function results = {function_name(verb.name)}(varargin)", *help_of(verb, verbs, options, used), "", HEADER,
            f"    results = osimcontact.internal.run_verb({quoted(function_name(verb.name))}, varargin);", "end", ""]
    return "\n".join(text)


def declared_file(verbs):
    lines = ["function verb = verb_declaration(name)",
             "%VERB_DECLARATION The declaration of a function of this package: its options, positional arguments and results.", "", HEADER,
             "    switch name"]
    for verb in verbs:
        names = [field.name for field in verb.fields if field.group != LEFT_OUT]
        positional = list(verb.positional)
        required = [argument for argument in positional if argument in verb.required]
        if positional[:len(required)] != required:
            sys.exit(f"{verb.name}: what must be given comes first among what has no name: {positional}")
        result = result_of(verb)
        flags = [field.name for field in verb.fields if set(field.kinds) == {"boolean"} and field.name in names]
        options = textwrap.wrap(cell([*names, "as_table"]), WIDTH, break_on_hyphens=False)
        lines += [f"        case {quoted(function_name(verb.name))}",
                  f"            verb.verb = {quoted(verb.name)};",
                  f"            verb.positional = {cell(positional)};",
                  f"            verb.required = {len(required)};",
                  f"            verb.table = {quoted(TABLES.get(verb.name, ''))};",
                  f"            verb.result = {quoted(result or '')};",
                  f"            verb.without = {cell(WITHOUT.get(verb.name, ()))};",
                  f"            verb.flags = {cell(flags)};",
                  "            verb.options = " + " ...\n                ".join(options) + ";"]
    lines += ["        otherwise", "            error('osimcontact:usage', 'there is no verb ''%s''', name);", "    end",
              "    verb.name = name;",
              "    verb.gives_json = ~isempty(verb.result);",
              f"    verb.left_out = {cell(left_out(verbs))};", "end", ""]
    return "\n".join(lines)


def left_out(verbs):
    """The options without use in MATLAB, each once."""
    return list(dict.fromkeys(field.name for verb in verbs for field in verb.fields if field.group == LEFT_OUT))


def shape_of(schema, definitions):
    """The form of a value in MATLAB: the name of a kind, a dict for an object, a list of one for a list of objects."""
    if "$ref" in schema:
        return shape_of(definitions[schema["$ref"].split("/")[-1]], definitions)
    parts = [part for part in schema.get("anyOf", []) if part.get("type") != "null"]
    if parts:
        # A number or three of them: the kind 'number' takes both.
        return shape_of(parts[0], definitions)
    types = schema.get("type")
    types = [kind for kind in ([types] if isinstance(types, str) else types) if kind != "null"]
    if len(types) != 1:
        sys.exit(f"what is this in MATLAB: {schema}")
    kind = types[0]
    if kind == "object":
        if schema.get("properties"):
            fields = {name: shape_of(part, definitions) for name, part in schema["properties"].items()
                      if not name.endswith("_bytes")}
            # Most changes have none: an empty list, not an object of NaN.
            return {ERRORS_OF_FIT.get(name, name): [part] if name in ERRORS_OF_FIT else part for name, part in fields.items()}
        return "map"
    if kind == "array":
        entry = shape_of(schema["items"], definitions)
        if isinstance(entry, dict):
            return [entry]
        return {"number": "numbers", "text": "texts", "numbers": "rows"}[entry]
    return {"number": "number", "integer": "number", "string": "text", "boolean": "truth"}[kind]


def shape_lines(target, shape):
    """Assignments, one for each kind of value at the bottom."""
    lines = []
    for name, part in shape.items():
        place = f"{target}.{name}"
        if isinstance(part, dict):
            lines += shape_lines(place, part)
        elif isinstance(part, list):
            lines += shape_lines(f"{place}{{1}}", part[0])
        else:
            lines.append(f"{place} = {quoted(part)};")
    return lines


def shapes_file():
    lines = ["function shape = shapes(result)",
             "%SHAPES The fields of a result, each with its kind: see complete_fields.m.", "", HEADER, "    switch result"]
    results = {"change", *filter(None, RESULTS.values())} | {result for _, result in WITHOUT.values()}
    paths = [RESULT_SCHEMAS / f"{name}.schema.json" for name in sorted(results)]
    for path in [*paths, ROOT / "schemas/failure.schema.json"]:
        schema = json.loads(path.read_text(encoding="utf-8"))
        shape = {}
        for variant in schema.get("oneOf", [schema]):
            for name, part in shape_of({**variant, "type": "object"}, schema.get("$defs", {})).items():
                if shape.setdefault(name, part) != part:
                    # Of two kinds under one name neither is known beforehand.
                    shape[name] = "any"
        lines.append(f"        case {quoted(path.name.removesuffix('.schema.json'))}")
        lines += ["            " + line for line in shape_lines("shape", shape)]
    lines += ["        otherwise", "            error('osimcontact:programFailed', 'there is no result ''%s''', result);",
              "    end", "end", ""]
    return "\n".join(lines)


def contents_file(verbs):
    rows = {function_name(verb.name): first_sentence(verb.summary) for verb in verbs}
    rows |= {name: f"{text}." for name, text in OWN_FUNCTIONS.items()}
    width = max(map(len, rows))
    lines = ["% OSIMCONTACT  Contact parameters of OpenSim models, right at every body size.", "%",
             "%", "% Every function hands a request to the program osim-contact-scale and gives what comes back as structs.",
             "% Type help osimcontact.rescale, say, for all options of a function. This list is shown by help osimcontact, in GNU",
             "% Octave by help osimcontact.Contents.", "%"]
    lines += [f"%   {name:<{width}} - {text}" for name, text in rows.items()]
    return "\n".join([*lines, "", HEADER, ""])


def files():
    """Every file that is made, by its path."""
    verbs = request_schemas.verbs()
    names = {verb.name for verb in verbs}
    missing = set(RESULTS) - names | names ^ set(EXAMPLES)
    if missing:
        sys.exit(f"in dev/matlab_texts.py and in schemas/requests/ there are not the same verbs: {', '.join(sorted(missing))}")
    used = set()
    written = {PACKAGE / f"{function_name(verb.name)}.m": verb_file(verb, verbs, used) for verb in verbs}
    idle = set(NO_STANDARD_STREAMS) - used
    if idle:
        sys.exit(f"no option says this any more, take it out of dev/matlab_texts.py: {', '.join(sorted(idle))}")
    written[PACKAGE / "Contents.m"] = contents_file(verbs)
    written[PACKAGE / "+internal/verb_declaration.m"] = declared_file(verbs)
    written[PACKAGE / "+internal/shapes.m"] = shapes_file()
    return written


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing, name what differs")
    check = parser.parse_args().check
    expected_files = files()
    there = {path for path in PACKAGE.rglob("*.m") if HEADER in path.read_text(encoding="utf-8")}
    differ = [path for path, text in expected_files.items() if not path.is_file() or path.read_text(encoding="utf-8") != text]
    differ += sorted(there - set(expected_files))
    for path in differ:
        if check:
            print(f"error: {path.relative_to(ROOT)} is not what the schemas say: run python3 dev/generate_matlab.py")
        elif path in expected_files:
            path.write_text(expected_files[path], encoding="utf-8", newline="\n")
        else:
            path.unlink()
    print(f"{len(expected_files)} files, {len(differ)} {'differ' if check else 'written'}")
    return 1 if check and differ else 0


if __name__ == "__main__":
    sys.exit(main())
