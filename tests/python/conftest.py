"""Fixtures and functions of several tests: models, the command beside the package, and its output."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

try:
    import opensim
except ImportError:
    pass  # Not every environment of dev/check_python.py has it.
else:
    # Its log would be written wherever a test is, among the fixtures too.
    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Error")

# The date of notes: they are compared with those of the command, and a day may end in between.
os.environ["SOURCE_DATE_EPOCH"] = "1764115200"

TOP = Path(__file__).resolve().parent.parent.parent
FIXTURES = TOP / "fixtures"
HUMAN = FIXTURES / "table1" / "human_62kg_smooth_sphere.osim"

# Words that each front end spells in its own way.
SPELLED = {
    "message",
    "why",
    "advice",
    "command",
    "commands",
    "remarks",
    "limbs_unknown",
    "why_no_body_weight",
    "source",
}


def corpus():
    """Models by other people; none where they are not at hand."""
    folder = os.environ.get("OSIM_CORPUS")
    return sorted(Path(folder).rglob("*.osim")) if folder else []


def fixtures():
    """Our own models: those that can be read, and those that cannot."""
    return sorted(FIXTURES.rglob("*.osim"))


def name_of(path):
    """A short name for a test."""
    return Path(path).relative_to(FIXTURES if FIXTURES in Path(path).parents else path.parent).as_posix()


def kind_of(path):
    """The folder of `fixtures/` that a model is in; none for models by other people. Folders above the project may have any name."""
    return path.relative_to(FIXTURES).parts[0] if FIXTURES in path.parents else None


needs_corpus = pytest.mark.skipif(not corpus(), reason="OSIM_CORPUS is not set: models by other people are not at hand")


def program():
    """The path of the command that was installed with the package, beside this interpreter."""
    scripts = Path(sys.executable).parent
    found = shutil.which("osim-contact-scale", path=str(scripts))
    if found is None:
        pytest.exit(f"osim-contact-scale is not in {scripts}: install the package with pip", 2)
    return found


def asked(**fields):
    """The JSON objects with which the command answers a request."""
    text = json.dumps({"format": "json", **fields}, default=os.fspath)
    ran = subprocess.run([program(), "request", "-"], input=text, capture_output=True, encoding="utf-8")
    lines = [json.loads(line) for line in ran.stdout.splitlines() if line.startswith("{")]
    assert lines, (fields, ran.stdout, ran.stderr)
    return lines


def unspelled(record):
    """The record without texts that each front end spells differently."""
    if isinstance(record, dict):
        # The words of a verdict, which has a sign, too.
        words = SPELLED | {"text"} if "sign" in record else SPELLED
        return {key: unspelled(value) for key, value in record.items() if key not in words}
    if isinstance(record, (list, tuple)):
        return [unspelled(item) for item in record]
    return record


@pytest.fixture
def human(tmp_path):
    """A model that may be changed."""
    return Path(shutil.copy(HUMAN, tmp_path / "human.osim"))
