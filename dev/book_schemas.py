"""The records of JSON in the book, each with a table of its fields. A hook of MkDocs; mkdocs.yml names it.

docs/reference/json.md has a row with the names of the fields for each record, between `<!-- begin records-... -->` and `<!-- end ... -->`.
The book has room for what `schemas/` says of each field, too.
"""

import json
import posixpath
import re
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent
PAGE = "reference/json.md"

PART = re.compile(r"<!-- begin records-(?P<name>\S+) -->\n(?P<rows>.*?)<!-- end records-(?P=name) -->", re.S)
SCHEMA = re.compile(r"\]\(\.\./\.\./(?P<path>schemas/[^)]*\.json)\)")

#: Every record has them, and the page says so.
EVERYWHERE = ("schema_version", "_bytes")

#: Records that the first table of the page has, and what they are called there.
SHARED = {"FindingRecord": "finding", "ContactsMass": "mass", "Dimensionless": "dimensionless"}


def on_page_markdown(markdown, page, config, files):
    """The page with tables in the place of rows."""
    if page.file.src_uri != PAGE:
        return markdown
    return PART.sub(lambda part: "\n".join(tables(path) for path in dict.fromkeys(SCHEMA.findall(part["rows"]))), markdown)


def tables(path):
    """A table for each record of a schema."""
    schema = json.loads((TOP / path).read_text(encoding="utf-8"))
    title = posixpath.basename(path).removesuffix(".schema.json")
    result = []
    for kind in schema.get("oneOf", [schema]):
        name = kind["properties"].get("kind", {}).get("const")
        kind_text = f" of kind `{name}`" if name else ""
        record(f"[`{title}`](../../{path}){kind_text}", "", kind, schema.get("$defs", {}), result, set())
    return "\n".join(result)


def record(label, path, schema, definitions, found, visited):
    """Adds the table of a record, then those of the records in it."""
    inner, rows = [], []
    for name, field in schema["properties"].items():
        if name.endswith(EVERYWHERE):
            continue
        of = reference(field)
        if "properties" in definitions.get(of, {}) and of not in SHARED and of not in visited:
            visited.add(of)
            inner.append((f"{path}{name}{'[]' if is_of(field, 'array') else ''}", of))
        meaning = " ".join(field.get("description", "").split())
        rows.append(f"| `{name}` | {type_of(field, definitions)} | {escaped(meaning)} |")
    found.append(f"\n{label}\n\n| field | type | meaning |\n|---|---|---|\n" + "\n".join(rows) + "\n")
    for place, of in inner:
        record(f"`{place}`", f"{place}.", definitions[of], definitions, found, visited)


def escaped(text):
    """Outside of code, what Markdown would read as marks."""
    return "`".join(piece if index % 2 else re.sub(r"[*_<|]", r"\\\g<0>", piece) for index, piece in enumerate(text.split("`")))


def reference(field):
    """The record that a field has, or a list of them; None without one."""
    places = [field, field.get("items", {}), *field.get("anyOf", [])]
    return next((place["$ref"].rsplit("/", 1)[1] for place in places if "$ref" in place), None)


def is_of(schema, kind):
    """Whether a type is among those of a schema."""
    return kind in ([schema["type"]] if isinstance(schema.get("type"), str) else schema.get("type", []))


def type_of(field, definitions):
    """A type in words."""
    of = reference(field)
    target = definitions.get(of, {}) if of else field.get("items", field)
    if of in SHARED:
        word = SHARED[of]
    elif is_of(target, "object"):
        word = "object"
    elif is_of(target, "string") or "const" in target or any(is_of(kind, "string") for kind in target.get("oneOf", [])):
        word = "text"
    elif is_of(target, "boolean"):
        word = "true or false"
    else:
        word = "integer" if is_of(target, "integer") else "number"
    many = "list: " if is_of(field, "array") else ""
    null = " or null" if is_of(field, "null") or any(is_of(kind, "null") for kind in field.get("anyOf", [])) else ""
    return f"{many}{word}{null}"
