"""Random variants, each read by OpenSim and by the command, rescaled, and read again.

`ORACLE_VARIANTS` says how many (40), `ORACLE_SEED` where to start (1). A failure names its seed and what was drawn.
"""

import os

import pytest

import command
import compare
from variants import variant

COUNT = int(os.environ.get("ORACLE_VARIANTS", "40"))
FIRST = int(os.environ.get("ORACLE_SEED", "1"))
SEEDS = range(FIRST, FIRST + COUNT)
MU = 0.21


@pytest.fixture(scope="module")
def variant_models(readings, tmp_path_factory):
    """`{seed: (model, story, outcome, output)}`; OpenSim reads them two at a time."""
    folder = tmp_path_factory.mktemp("variants")
    models = {}
    for seed in SEEDS:
        data, description = variant(seed)
        models[seed] = folder / f"variant_{seed}.osim", description
        models[seed][0].write_bytes(data)
    readings.fetch([path for path, _ in models.values()])
    done = {}
    for seed, (path, description) in models.items():
        output = folder / f"rescaled_{seed}.osim"
        mass = float.fromhex(readings[path]["mass_sum"])
        done[seed] = path, description, command.rescale(path, MU * mass, output), output
    readings.fetch([output for *_, output in done.values() if output.exists()])
    return done


@pytest.mark.parametrize("seed", SEEDS)
def test_opensim_builds_the_variant(seed, variant_models, readings):
    """A variant OpenSim refuses would test nothing."""
    path, description, _, _ = variant_models[seed]
    assert readings[path]["builds"], (description, readings[path])


@pytest.mark.parametrize("seed", SEEDS)
def test_inspect_equals_opensim(seed, variant_models, readings):
    path, description, _, _ = variant_models[seed]
    outcome = command.inspect(path)
    assert outcome.status == 0, (description, outcome)
    compare.inspect_equals_opensim(outcome.report, readings[path])


@pytest.mark.parametrize("seed", SEEDS)
def test_rescaled_by_the_rule(seed, variant_models, readings):
    path, description, outcome, output = variant_models[seed]
    assert outcome.status == 0, (description, outcome)
    planned = compare.plan(outcome.report)
    compare.plan_is_what_opensim_reads(planned, readings[path], readings[output])
    contacts, target = command.masses(outcome.report)
    expected = compare.expected(readings[path], target / contacts)
    compare.plan_follows_the_rule(planned, expected, readings[path])
