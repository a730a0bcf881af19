"""Odd spellings, and models changed at random: OpenSim and the command read the same, or the command says why not.

`ORACLE_MUTANTS` says how many changed ones and how many with odd names (200 each), `ORACLE_SEED` where to start (1). A failure names its
seed and what was changed.
"""

import json
import math
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor

import pytest

import command
import compare
import names
import opensim_reads
import words

COUNT = int(os.environ.get("ORACLE_MUTANTS", "200"))
FIRST = int(os.environ.get("ORACLE_SEED", "1"))
TABLE = words.table()
MUTANTS = {f"mutant {seed}: {'; '.join(story)}": model for seed in range(FIRST, FIRST + COUNT) for model, story in [words.changed_model(seed)]}
NAMINGS = {f"naming {seed}: {odd}": model for seed in range(FIRST, FIRST + COUNT) for model, odd in [names.naming(seed)]}

# Refused, though OpenSim builds the model.
STRICT = {"unreadable": "a file that is not there: OpenSim only logs it and goes on without what should be in it"}
# Shown, though OpenSim refuses the model, with one of these findings: such a value is never scaled.
REPORTED_CODES = {"odd-number", "not-finite", "out-of-domain", "mass-unknown", "connectee-by-name", "refused-name", "duplicate-names"}


@pytest.fixture(scope="module")
def readings_and_reports(tmp_path_factory):
    """`{what it is: (OpenSim's reading, exit status of inspect, its JSON)}`."""
    folder = tmp_path_factory.mktemp("words")
    paths = {}
    for number, (what, model) in enumerate((TABLE | MUTANTS | NAMINGS).items()):
        paths[what] = folder / f"{number}.osim"
        paths[what].write_bytes(model.encode())
    with ThreadPoolExecutor(2) as pool:
        theirs = pool.submit(opensim_reads.read_models, paths.values())
        ours = dict(zip(paths, pool.map(inspect, paths.values())))
        readings = theirs.result()
    return {what: (readings[str(path)], *ours[what]) for what, path in paths.items()}


def inspect(path):
    """A report as of `command.inspect`, without the check of the JSON's form, which other tests make."""
    process = subprocess.run([str(command.BINARY), "inspect", str(path), "--format", "json"], capture_output=True, timeout=60)
    return process.returncode, json.loads(process.stdout) if process.stdout else None


@pytest.mark.parametrize("what", TABLE)
def test_spelling(what, readings_and_reports):
    reading, status, report = readings_and_reports[what]
    same(reading, status, report)
    if status == 0 and not (reading["loads"] and reading["connects"]):
        assert REPORTED_CODES & {finding["code"] for finding in report["findings"]}, reading["error"]


@pytest.mark.parametrize("what", [what for what in TABLE if what.startswith(words.VECTORS)])
def test_misleading_locations_and_gravity_are_reported(what, readings_and_reports):
    reading, status, report = readings_and_reports[what]
    if status != 0 or not reading["loads"]:
        return
    is_gravity = what.startswith("gravity")
    values = [float.fromhex(value) for value in (reading["gravity"] if is_gravity else reading["spheres"][0]["location"])]
    result = {finding["code"] for finding in report["findings"]} & {"odd-number", "not-finite"}
    plain = words.as_it_looks(TABLE[what], "gravity" if is_gravity else "location")
    as_seen = plain == values and all(map(math.isfinite, values))
    assert bool(result) != as_seen, f"OpenSim reads {values}, a person {plain}; found: {result}"


@pytest.mark.parametrize("what", MUTANTS)
def test_mutant(what, readings_and_reports):
    same(*readings_and_reports[what])


@pytest.mark.parametrize("what", NAMINGS)
def test_naming(what, readings_and_reports):
    reading, status, report = readings_and_reports[what]
    if status == 0 and not reading.get("builds"):
        assert REPORTED_CODES & {finding["code"] for finding in report["findings"]}, reading
    else:
        same(with_names_of(report, reading), status, report)


def with_names_of(report, reading):
    """The reading, in which what OpenSim has renamed is called as in the file; paths are OpenSim's."""
    names = {one["path"]: one["name"] for kind in ("spheres", "forces") for one in report.get(kind, [])}
    kinds = {kind: [one | {"name": names.get(one["path"], one["name"])} for one in reading.get(kind, [])] for kind in ("spheres", "forces")}
    return reading | kinds


def same(reading, status, report):
    assert status in (0, 1) and report, f"exit status {status}"
    if status == 0:
        if reading["loads"] and reading["connects"]:
            compare.inspect_equals_opensim(report, reading)
        return
    error = report["error"]
    if reading["loads"] and reading.get("builds"):
        assert error["code"] in STRICT, error
