"""Run `osim-contact-scale` and read its JSON, strictly."""

import json
import os
import subprocess
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import schemas

ROOT = Path(__file__).resolve().parents[2]
BINARY = Path(os.environ.get("OSIM_CONTACT_SCALE", ROOT / "target/release/osim-contact-scale"))

# Masses in these tests are meant as they are, however far from the model's own.
YES = ("--yes", "implausible-mass", "--yes", "mass-in-pounds", "--yes", "implausible-radius")


@dataclass(frozen=True)
class Outcome:
    """The outcome of one run: its exit status, its JSON (None where stdout held none) and what it said on stderr."""

    status: int
    report: dict | None
    stderr: str

    @property
    def error(self):
        """The error object of a failure, or None."""
        return (self.report or {}).get("error")


def run(*arguments):
    """A run with `--format json`; stdout must be exactly one JSON object on one line, or nothing."""
    process = subprocess.run([str(BINARY), *map(str, arguments), "--format", "json"], capture_output=True, timeout=60)
    text = process.stdout.decode("utf-8")
    if not text:
        return Outcome(process.returncode, None, process.stderr.decode("utf-8", "replace"))
    assert text.count("\n") == 1 and text.endswith("\n"), f"not one line of JSON: {text[:300]!r}"
    report = json.loads(text, parse_constant=not_json)
    assert report["schema_version"] == 1
    schemas.check(str(arguments[0]), report)
    return Outcome(process.returncode, report, process.stderr.decode("utf-8", "replace"))


def not_json(token):
    """Refuse the `NaN` and `Infinity` that Python would let through."""
    raise ValueError(f"{token} is not JSON")


@cache
def example(name):
    """The example `name` of one of the libraries, built: from what the tests in Rust compiled, where they ran before."""
    cargo = ["cargo", "build", "--workspace", "--example", name, "--message-format=json"]
    process = subprocess.run(cargo, cwd=ROOT, capture_output=True, text=True)
    assert process.returncode == 0, process.stderr
    (path,) = [executable for line in process.stdout.splitlines() if (executable := json.loads(line).get("executable"))]
    return path


def inspect(model, *more):
    return run("inspect", model, *more)


# Known contacts that were published under a body of another mass than they were made for: which is meant has to be said.
NEEDS_MASS = ("v40000_opencap_lai_arnold_crlf",)


def rescale(model, target_mass, output, *more):
    """A rescaling from the mass of the bodies, which is said where it would be asked."""
    if Path(model).stem in NEEDS_MASS and "--contacts-mass" not in more:
        more = (*more, "--contacts-mass", repr(inspect(model).report["mass_kg"]))
    return run(model, "--target-mass", repr(target_mass), *YES, "-o", output, *more)


def masses(report):
    """The mass that contacts were made for before a change, and the one that they are made for after it, kg."""
    return report["contacts_mass_kg"]["value"], report["target_mass_kg"]
