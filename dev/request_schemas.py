"""The verbs and their fields, as the JSON Schemas in schemas/requests/ have them.

The schemas are made from the Rust types of the requests. What Python and MATLAB say of an option is made from them in turn,
so that an option is declared once. Words that begin with `x-` are this project's: see crates/osim-requests/src/schema.rs.
"""

import json
import re
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "schemas" / "requests"


@dataclass(frozen=True)
class Field:
    """An option of a verb."""

    name: str
    description: str
    """The help of the field, in plain words; other fields are in `backticks`."""
    kinds: frozenset[str]
    """The kinds of value that the field takes: some of number, integer, boolean, string, path, list, object."""
    choices: tuple[str, ...]
    """The texts that it takes, where there are no others."""
    default: object
    group: str | None
    """The subject of the field, where it says nothing about contacts: output, many or shown."""
    is_of_run: bool
    """Whether the field is about a whole run: no row of a table can have its own."""


@dataclass(frozen=True)
class Verb:
    """A verb: what it does, and its options in the order of the help."""

    name: str
    summary: str
    fields: tuple[Field, ...]
    required: frozenset[str]
    positional: tuple[str, ...]
    """The options that a call has without their names, in its order."""
    changes: int
    """The place of the verb among those that change models, from 1; 0 for others."""


def verbs() -> list[Verb]:
    """All verbs, by name."""
    return [_verb(path) for path in sorted(FOLDER.glob("*.schema.json"))]


def _verb(path: Path) -> Verb:
    schema = json.loads(path.read_text(encoding="utf-8"))
    definitions = schema.get("$defs", {})
    fields = tuple(
        _field(name, field, definitions) for name, field in schema["properties"].items() if name != "verb"
    )
    summary = re.split(r"\n\s*\n|```", schema["description"])[0].strip()
    required = frozenset(name for name in schema.get("required", []) if name != "verb")
    positional = tuple(schema.get("x-positional", []))
    changes = schema.get("x-changes", 0)
    return Verb(path.name.removesuffix(".schema.json"), summary, fields, required, positional, changes)


def _field(name: str, schema: dict, definitions: dict) -> Field:
    kinds, choices = set(), []
    _collect(schema, definitions, kinds, choices)
    free_text = "text" in kinds
    kinds.discard("text")
    return Field(
        name=name,
        description=" ".join(schema.get("description", "").split()),
        kinds=frozenset(kinds),
        choices=() if free_text else tuple(choices),
        default=schema.get("default"),
        group=schema.get("x-group"),
        is_of_run=schema.get("x-of-run", False),
    )


def _collect(schema: dict, definitions: dict, kinds: set[str], choices: list[str]) -> None:
    """Collects the kinds of value that a schema takes, with those of the schemas that it is made of."""
    if "$ref" in schema:
        schema = definitions[schema["$ref"].rsplit("/", 1)[-1]]
    if "bytes" in schema.get("properties", {}):
        kinds.add("path")  # The name of a file that is no text: a path all the same.
        return
    types = schema.get("type", [])
    for kind in [types] if isinstance(types, str) else types:
        if kind == "array":
            kinds.add("list")
            _collect(schema.get("items", {}), definitions, kinds, choices)
        elif kind != "null":
            kinds.add(kind)
    texts = [text for text in schema.get("enum", []) if isinstance(text, str)]
    if isinstance(schema.get("const"), str):
        texts.append(schema["const"])
    choices += [text for text in texts if text not in choices]
    if texts:
        kinds.add("string")
    elif "string" in kinds and "string" in (types if isinstance(types, list) else [types]):
        kinds.add("text")
    for part in schema.get("anyOf", []) + schema.get("oneOf", []):
        _collect(part, definitions, kinds, choices)
