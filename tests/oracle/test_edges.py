"""Numbers at the edge of a double: what is not finite is not written, every JSON is one of its schema, and OpenSim reads what was written.

`ORACLE_MUTANTS` / 4 models have one to three such numbers each; `ORACLE_SEED` says where to begin. Several verbs change each.
"""

import os
import random
import re
import sys
from concurrent.futures import ThreadPoolExecutor

import command
import compare
import opensim_reads
import pytest
from models import FIXTURES

sys.path.insert(0, str(FIXTURES))

from quirks import base  # noqa: E402  (the fixtures' own building blocks)

COUNT = max(int(os.environ.get("ORACLE_MUTANTS", "200")) // 4, 1)
FIRST = int(os.environ.get("ORACLE_SEED", "1"))
SEEDS = range(FIRST, FIRST + COUNT)
EDGES = ["1e-308", "1e308", "5e-324", "2.2250738585072014e-308", "1.7976931348623157e308", "1e-150", "1e150", "1e-5", "1e300", "1"]
SELDOM = ["0", "nan", "inf"]
NUMBERS = re.compile(
    r"<(radius|location|mass|stiffness|dissipation|\w*friction|transition_velocity|constant_contact_force|\w*smoothing|gravity|orientation|"
    r"contact_sphere_radius)>([^<>]+)</\1>"
)
NOT_FINITE = re.compile(r"(?<![\w.+-])[-+]?(nan|inf|infinity)(?![\w.])", re.I)
MODELS = [base.ONE_FOOT, base.ONE_FOOT_HUNT, base.TWO_FEET, base.TWO_FEET_HUNT] + [
    (FIXTURES / "format" / f"{name}.osim").read_text() for name in ("three_materials", "floor_of_its_own", "shared_by_materials", "moco_sphere_in_force")
]
CONFIRMED = [word for question in ("implausible-mass", "mass-in-pounds", "implausible-radius", "wrong-afterwards") for word in ("--yes", question)]


def model(draw):
    """A model of these with one to three numbers at the edge of a double."""
    return with_edges(draw, draw.choice(MODELS))


def with_edges(draw, text):
    """A model with one to three numbers at the edge of a double."""
    found = draw.sample(list(NUMBERS.finditer(text)), draw.randint(1, 3))
    for number in sorted(found, key=lambda one: -one.start()):
        parts = number[2].split()
        new = [draw.choice(EDGES if draw.random() < 0.9 else SELDOM) if len(parts) == 1 or draw.random() < 0.6 else part for part in parts]
        text = text[: number.start(2)] + " ".join(new) + text[number.end(2) :]
    return text


def calls(draw):
    """Verbs that change a model, with such numbers."""

    def edge():
        return draw.choice(EDGES)

    return [
        ("rescale", "--target-mass", edge(), "--contacts-mass", edge()),
        ("rescale", "--target-mass", edge(), "--radius", draw.choice(["keep", f"x{edge()}", edge()])),
        ("set", f"stiffness=x{edge()}", f"radius=x{edge()}"),
        ("set", f"dissipation={edge()}", f"hertz_smoothing=x{edge()}"),
        ("set", f"constant_contact_force={edge()}"),
        ("convert", "--to", "smooth"),
        ("convert", "--to", "smooth", "--hertz-smoothing", edge(), "--constant-contact-force", edge()),
        ("convert", "--to", "hunt-crossley"),
        ("design", "--indentation", draw.choice(["0.16", "1e-300", "5e-324"]), "--spheres", "2"),
        ("design", "--indentation", "0.3", "--load", edge(), "--spheres", "2"),
        ("design", "--constant-indentation", edge(), "--restitution", "1e-300"),
        ("transfer", "--from", "falisse2022", "--spheres", "2", "--mass", edge()),
        ("note", "--contacts-mass", edge()),
        ("remove",),
    ]


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """`{seed: (model, [(call, outcome, output)])}`; that each JSON is one of its schema is what `command.run` looks at."""
    folder = tmp_path_factory.mktemp("edges")

    def run(seed):
        draw = random.Random(f"edges {seed}")
        path = folder / f"{seed}.osim"
        path.write_text(model(draw))
        outcomes = [(("inspect",), command.run("inspect", path), None), (("check",), command.run("check", path), None)]
        outcomes.append((("drop-test",), command.run("drop-test", path), None))
        for number, call in enumerate(calls(draw)):
            output = folder / f"{seed}.{number}.osim"
            outcomes.append((call, command.run(call[0], path, *call[1:], "-o", output, *CONFIRMED), output))
        return path, outcomes

    with ThreadPoolExecutor(2) as pool:
        return dict(zip(SEEDS, pool.map(run, SEEDS)))


@pytest.mark.parametrize("seed", SEEDS)
def test_nothing_that_is_not_finite_is_written(seed, runs):
    path, outcomes = runs[seed]
    before = len(NOT_FINITE.findall(path.read_text()))
    for call, outcome, output in outcomes:
        assert outcome.status in (0, 1), (call, outcome)
        if output and output.exists():
            found = NOT_FINITE.findall(output.read_text())
            assert len(found) <= before, (call, found)


def test_opensim_reads_what_was_written(runs):
    """OpenSim reads the numbers that every change says; of `convert`, all numbers of each new force."""
    written = [(path, call, outcome, output) for path, outcomes in runs.values() for call, outcome, output in outcomes if output and output.exists()]
    readings = opensim_reads.read_models({path for path, *_ in written} | {output for *_, output in written})
    compared = 0
    for path, call, outcome, output in written:
        before, after = readings[str(path)], readings[str(output)]
        if not (before["loads"] and after["loads"] and after["connects"]):
            continue
        if call[0] in ("rescale", "set"):
            compare.values_are_what_opensim_reads(compare.plan(outcome.report), before, after)
        for outcomes in outcome.report.get("objects", []):
            if call[0] == "convert" and outcomes["change"] == "added" and outcomes["parameters"]:
                (force,) = [one for one in after["forces"] if one["path"] == outcomes["path"]]
                assert {name: value.hex() for name, value in outcomes["parameters"].items()} == force["parameters"], (call, outcomes["path"])
        compared += 1
    assert compared > 3 * COUNT, compared
