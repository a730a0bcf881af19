"""The count of walks from random guesses: what is a success, and its confidence interval."""

import sys

import pytest
from conftest import TOP

sys.path.insert(0, str(TOP / "demonstrations" / "walker"))

import success

GOOD = {"solved": 1, "solved_twice": "1", "effort_change": "0.01", "force_change": "-0.019", "held": "1"}


def test_wilsons_interval_is_that_of_r():
    """prop.test(15, 20, correct = FALSE) and prop.test(0, 20, correct = FALSE) of R, to four digits."""
    assert success.wilson(15, 20) == pytest.approx((0.5313, 0.8881), abs=5e-5)
    assert success.wilson(0, 20) == pytest.approx((0.0, 0.1611), abs=5e-5)


@pytest.mark.parametrize(
    ("change", "counted"),
    [
        ({}, (True, True)),
        ({"held": "0.9"}, (True, False)),
        ({"force_change": "0.021"}, (False, False)),
        ({"effort_change": "nan"}, (False, False)),
        ({"solved_twice": "0"}, (False, False)),
        ({"solved": 0, "solved_twice": "", "effort_change": "", "force_change": "", "held": ""}, (False, False)),
    ],
)
def test_a_success_is_solved_twice_alike_and_holds(change, counted):
    assert success.succeeded(GOOD | change) == counted
