"""`inspect` reads every model as OpenSim does, bit for bit."""

import pytest

import command
import compare
import models
from refusals import REFUSED, RENAMED

MODELS = models.fixtures("reads") + models.corpus()
GOOD = [path for path in MODELS if path.parent.name != "bad"]


@pytest.fixture(scope="module", autouse=True)
def read_all(readings):
    readings.fetch(MODELS)


@pytest.mark.parametrize("path", GOOD, ids=models.label)
def test_inspect_equals_opensim(path, readings):
    outcome, reading = command.inspect(path), readings[path]
    if not compare.ground_contacts(reading) and outcome.error:
        assert path.name in REFUSED, f"{outcome.error} for a model that no one has told us about"
        return
    assert outcome.status == 0, outcome
    if path.name in RENAMED:
        numbers_in_file_order(outcome.report, reading)
    else:
        compare.inspect_equals_opensim(outcome.report, reading)


def numbers_in_file_order(report, reading):
    """If OpenSim gives other names, the reports have the same numbers in the same order."""
    compare.model_equals(report, reading)
    assert len(report["forces"]) == len(reading["forces"])
    for ours, theirs in zip(report["forces"], reading["forces"]):
        compare.numbers_equal(ours["parameters"], theirs["parameters"], ours["name"])
    listed = {compare.hexed(sphere["radius_m"]) for sphere in report["spheres"]}
    assert listed <= {sphere["radius"] for sphere in reading["spheres"]}


@pytest.mark.parametrize("path", [path for path in MODELS if path.parent.name == "bad"], ids=models.label)
def test_inspect_never_shows_other_numbers_than_opensim(path, readings):
    """A bad model may be refused; if it is shown, then with OpenSim's numbers."""
    outcome = command.inspect(path)
    if outcome.status == 0:
        compare.inspect_equals_opensim(outcome.report, readings[path])
    else:
        assert outcome.status == 1 and outcome.error["code"] and outcome.error["message"]


@pytest.mark.skipif(not models.CORPUS, reason=models.NO_CORPUS)
def test_the_corpus_is_there():
    assert len(models.corpus()) >= 10
