"""The model of Falisse et al. (2022) from 62 kg to 500 kg: each number, and each line that may change."""

import re
from pathlib import Path

import pytest

import command
import compare
import models

pytestmark = pytest.mark.skipif(not models.CORPUS, reason=models.NO_CORPUS)
EXPECTED = {  # property: (from, to as ten digits tell it)
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
    result = {
        name: {(change["from"], change["to"]) for change in outcome.report["changes"] if change["property"] == name}
        for name in EXPECTED
    }
    for name, (old, new) in EXPECTED.items():
        digits = len(new.split("e")[0].replace(".", "").lstrip("0"))
        (pair,) = result[name]
        assert pair[0] == old and f"{pair[1]:.{digits}g}" == new, (name, pair)
    assert len(outcome.report["changes"]) == 12 * len(EXPECTED)


def test_lines(rescaled):
    """36 lines changed, 36 inserted, one note at the end of the credits, nothing else."""
    model, _, output = rescaled
    old, new = (path.read_bytes().split(b"\n") for path in (model, output))
    note = re.compile(rb"(; )?\[contacts made for 500 kg at [^\]]*\)\]")
    notes = [line for line in new if note.search(line)]
    new = [note.sub(b"", line) for line in new]
    absent = re.compile(rb"\t{5}<(constant_contact_force|hertz_smoothing|hunt_crossley_smoothing)>[^<]+</\1>")
    inserted = [line for line in new if absent.fullmatch(line)]
    assert (len(inserted), len(notes)) == (36, 1)
    remaining = [line for line in new if line not in inserted]
    assert len(remaining) == len(old)
    changed = [(one, other) for one, other in zip(old, remaining) if one != other]
    element = re.compile(rb"\t{5}<(radius|stiffness|dissipation)>[^<]+</\1>")
    assert len(changed) == 36
    for pair in changed:
        tags = [element.fullmatch(line)[1] for line in pair]
        assert tags[0] == tags[1]


def test_opensim_reads_it(rescaled, readings):
    model, outcome, output = rescaled
    planned = compare.plan(outcome.report)
    compare.plan_is_what_opensim_reads(planned, readings[model], readings[output])
    expected = compare.expected(readings[model], 500.0 / outcome.report["contacts_mass_kg"]["value"])
    compare.plan_follows_the_rule(planned, expected, readings[model])
