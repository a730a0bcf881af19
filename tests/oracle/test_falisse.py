"""The model of Falisse et al. (2022) from 62 kg to 500 kg: each number, and each line that may change."""

import difflib
from pathlib import Path

import pytest

import command
import compare
import models

pytestmark = pytest.mark.skipif(not models.CORPUS, reason=models.NO_CORPUS)
WANTED = {  # property: (from, to as ten digits tell it)
    "radius": (0.032, "0.0641715826"),
    "stiffness": (1e6, "2005361.956"),
    "dissipation": (2.0, "1.4123216"),
    "constant_contact_force": (1e-5, "4.0214766e-05"),
    "hertz_smoothing": (300.0, "149.59893"),
    "hunt_crossley_smoothing": (50.0, "35.308041"),
}


@pytest.fixture(scope="module")
def rescaled(tmp_path_factory):
    model = Path(models.CORPUS) / "v40000_falisse_2022_human.osim"
    output = tmp_path_factory.mktemp("falisse") / "out.osim"
    return model, command.rescale(model, 500.0, output), output


def test_numbers(rescaled):
    _, outcome, _ = rescaled
    assert outcome.status == 0, outcome
    found = {
        name: {(change["from"], change["to"]) for change in outcome.report["changes"] if change["property"] == name}
        for name in WANTED
    }
    for name, (old, new) in WANTED.items():
        digits = len(new.split("e")[0].replace(".", "").lstrip("0"))
        (pair,) = found[name]
        assert pair[0] == old and f"{pair[1]:.{digits}g}" == new, (name, pair)
    assert len(outcome.report["changes"]) == 12 * len(WANTED)


def test_lines(rescaled):
    """36 lines changed, 36 inserted, one note, nothing else."""
    model, _, output = rescaled
    lines = [path.read_bytes().split(b"\n") for path in (model, output)]
    changed = inserted = notes = 0
    for tag, i1, i2, j1, j2 in difflib.SequenceMatcher(None, *lines, autojunk=False).get_opcodes():
        new = lines[1][j1:j2]
        notes += sum(line.strip().startswith(b"<!--") for line in new) if tag == "insert" else 0
        changed += i2 - i1
        inserted += (j2 - j1) - (i2 - i1)
        assert tag != "delete" and (j2 - j1) >= (i2 - i1)
    assert (changed, inserted, notes) == (36, 37, 1)


def test_opensim_reads_it(rescaled, readings):
    model, outcome, output = rescaled
    planned = compare.plan(outcome.report)
    compare.plan_is_what_opensim_reads(planned, readings[model], readings[output])
    compare.plan_follows_the_rule(
        planned, compare.expected_isometric(readings[model], 500.0 / outcome.report["contacts_mass_kg"]["from"])
    )
