"""A model rescaled by 3.7: OpenSim reads the plan's numbers from it, the rule gives them, and nothing else differs."""

import pytest

import command
import compare
import models
import rules
from refusals import LENIENT, REFUSED, RENAMED

MU = 3.7
GOOD = [path for path in models.fixtures("reads") + models.corpus() if path.parent.name != "bad"]
UNCONNECTED = [path for path in models.fixtures("loads") if path.parent.name != "bad"]
BAD = [models.FIXTURES / folder / file for folder, file, _ in models.readme_rows() if folder == "bad"]


def mass(reading):
    return float.fromhex(reading["mass_sum"])


@pytest.fixture(scope="module")
def rescaled(readings, tmp_path_factory):
    """`{model: (outcome, output)}` of all models; OpenSim then reads all outputs at once."""
    folder = tmp_path_factory.mktemp("rescaled")
    readings.fetch(GOOD + UNCONNECTED)
    done = {}
    for path in GOOD + UNCONNECTED:
        output = folder / f"{path.parent.name}_{path.name}"
        done[path] = command.rescale(path, MU * mass(readings[path]), output), output
    readings.fetch([output for _, output in done.values() if output.exists()])
    return done


@pytest.mark.parametrize("path", [path for path in GOOD if path.name not in REFUSED], ids=models.label)
def test_opensim_reads_the_plan_and_nothing_else_differs(path, rescaled, readings):
    outcome, output = rescaled[path]
    assert outcome.status == 0, outcome
    contacts, target = command.masses(outcome.report)
    assert target == MU * mass(readings[path])
    before, after = readings[path], readings[output]
    if path.name in RENAMED:
        return renamed(outcome.report, before, after)
    planned = compare.plan(outcome.report)
    compare.plan_is_what_opensim_reads(planned, before, after)
    expected = compare.expected(before, target / contacts)
    compare.plan_follows_the_rule(planned, expected, before)


def renamed(report, before, after):
    """If OpenSim gives other names than the file, the prints differ in the planned numbers."""
    expected = sorted((change["property"], change["from"].hex(), change["to"].hex()) for change in report["changes"])
    assert sorted(compare.differing_lines(before["dump"], after["dump"]).elements()) == expected


@pytest.mark.parametrize("path", [path for path in GOOD if path.name in REFUSED], ids=models.label)
def test_what_is_refused_on_purpose_is_refused_and_writes_nothing(path, rescaled):
    outcome, output = rescaled[path]
    assert outcome.status == 1 and outcome.error["code"], f"{REFUSED[path.name]}, and yet: {outcome}"
    assert not output.exists()


@pytest.mark.parametrize("path", UNCONNECTED, ids=models.label)
def test_a_model_opensim_cannot_connect_is_refused_or_scaled_right(path, rescaled, readings):
    """OpenSim reads the values all the same; only what belongs together is not known from it."""
    outcome, output = rescaled[path]
    if outcome.status:
        assert outcome.status == 1 and outcome.error["code"] and not output.exists(), outcome
        return
    contacts, target = command.masses(outcome.report)
    factor = rules.factors(MU, rules.isometric(target / contacts))
    for change in outcome.report["changes"]:
        assert rules.close(change["to"], change["from"] * factor[change["property"]]), change
    by_key = {entry["path"]: entry for entry in readings[path]["forces"] + readings[path]["spheres"]}
    planned = {
        place: change
        for place, change in compare.plan(outcome.report).items()
        if place[0] in by_key and (place[2] != "radius" or "radius" in by_key[place[0]])
    }  # without the radii Moco 0.1 to 0.3 kept in the force: OpenSim 4.6 does not know them
    compare.plan_is_what_opensim_reads(planned, readings[path], readings[output])


@pytest.mark.parametrize("path", BAD, ids=models.label)
def test_a_bad_model_is_refused_in_place_and_writes_nothing(path, tmp_path, readings):
    output = tmp_path / "out.osim"
    outcome = command.rescale(path, 229.4, output)
    if outcome.status == 0 and path.name in LENIENT:
        if readings[path]["loads"]:
            compare.plan_is_what_opensim_reads(compare.plan(outcome.report), readings[path], readings[output])
        return
    assert outcome.status == 1 and outcome.error["code"] and outcome.error["message"], outcome
    assert not output.exists()


RADII_MODELS = [path for path in GOOD if path.parent.name in ("table1", "corpus") or "terrain" in path.name]


@pytest.mark.parametrize("path", RADII_MODELS, ids=models.label)
def test_with_radii_kept_stiffness_alone_goes_with_mass(path, tmp_path, readings):
    """rho = 1: E1* goes with mu, and alpha, cf, bd and bv stay. Shared spheres are no obstacle then."""
    output = tmp_path / "out.osim"
    outcome = command.rescale(path, MU * mass(readings[path]), output, "--radius", "keep")
    if path.name in REFUSED and outcome.status:
        assert outcome.status == 1 and outcome.error["code"] and not output.exists(), outcome
        return
    assert outcome.status == 0, outcome
    planned, (contacts, target) = compare.plan(outcome.report), command.masses(outcome.report)
    compare.plan_is_what_opensim_reads(planned, readings[path], readings[output])
    expected = compare.expected(readings[path], target / contacts, rho=1.0)
    compare.plan_follows_the_rule(planned, expected, readings[path])
