"""The JSON Schemas of `schemas/`: what the command printed is one of its results, or a failure."""

import json
from functools import cache
from pathlib import Path

from jsonschema import Draft202012Validator

SCHEMAS = Path(__file__).resolve().parents[2] / "schemas"
# Verbs that are not named here print changes.
RESULTS = {
    "inspect": "inspection",
    "check": "check",
    "sweep": "sweep",
    "drop-test": "drop-test",
    "motion": "motion",
    "reproduce": "reproduction",
    "presets": "preset",
    "explain": "explanation",
}
# These print changes of a model, or what they find without one.
WITHOUT_MODEL = {"design": "design", "fit": "fit"}


@cache
def validator(name):
    return Draft202012Validator(json.loads((SCHEMAS / f"{name}.schema.json").read_text("utf-8")))


def check(verb, printed):
    """Raise ValidationError where `printed` is not what a call of `verb` may print."""
    name = f"results/{RESULTS.get(verb, 'change')}"
    if "error" in printed:
        name = "failure"
    elif verb in WITHOUT_MODEL and "changes" not in printed:
        name = f"results/{WITHOUT_MODEL[verb]}"
    validator(name).validate(printed)
