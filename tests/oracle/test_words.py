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
MUTANTS = {f"mutant {seed}: {'; '.join(story)}": model for seed in range(FIRST, FIRST + COUNT) for model, story in [words.mutant(seed)]}
NAMINGS = {f"naming {seed}: {odd}": model for seed in range(FIRST, FIRST + COUNT) for model, odd in [names.naming(seed)]}

# Refused, though OpenSim builds the model.
STRICT = {"unreadable": "a file that is not there: OpenSim only logs it and goes on without what should be in it"}
# Shown, though OpenSim refuses the model, with one of these findings: such a value is never scaled.
SAID = {"odd-number", "not-finite", "out-of-domain", "mass-unknown", "connectee-by-name", "refused-name", "duplicate-names"}


@pytest.fixture(scope="module")
def both(tmp_path_factory):
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
    """As `command.inspect`, without the check of the JSON's form, which other tests make."""
    done = subprocess.run([str(command.BINARY), "inspect", str(path), "--format", "json"], capture_output=True, timeout=60)
    return done.returncode, json.loads(done.stdout) if done.stdout else None


@pytest.mark.parametrize("what", TABLE)
def test_spelling(what, both):
    reading, status, report = both[what]
    same(reading, status, report)
    if status == 0 and not (reading["loads"] and reading["connects"]):
        assert SAID & {finding["code"] for finding in report["findings"]}, reading["error"]


@pytest.mark.parametrize("what", [what for what in TABLE if what.startswith(words.VECTORS)])
def test_location_and_gravity_are_said_where_they_are_not_what_they_look_like(what, both):
    reading, status, report = both[what]
    if status != 0 or not reading["loads"]:
        return
    of_gravity = what.startswith("gravity")
    read = [float.fromhex(value) for value in (reading["gravity"] if of_gravity else reading["spheres"][0]["location"])]
    found = {finding["code"] for finding in report["findings"]} & {"odd-number", "not-finite"}
    plain = words.as_it_looks(TABLE[what], "gravity" if of_gravity else "location")
    as_seen = plain == read and all(map(math.isfinite, read))
    assert bool(found) != as_seen, f"OpenSim reads {read}, a person {plain}; found: {found}"


@pytest.mark.parametrize("what", MUTANTS)
def test_mutant(what, both):
    same(*both[what])


@pytest.mark.parametrize("what", NAMINGS)
def test_naming(what, both):
    reading, status, report = both[what]
    if status == 0 and not reading.get("builds"):
        assert SAID & {finding["code"] for finding in report["findings"]}, reading
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
