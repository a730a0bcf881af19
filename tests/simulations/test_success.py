"""The count of successful walks from random guesses: the criterion of success, and the confidence interval."""

import sys

import pytest
from conftest import TOP

sys.path.insert(0, str(TOP / "demonstrations" / "walker"))

import criterion

GOOD = {"solved": 1, "solved_twice": "1", "effort_change": "0.019", "held": "1"}


def test_wilsons_interval_is_that_of_r():
    """prop.test(15, 20, correct = FALSE) and prop.test(0, 20, correct = FALSE) of R, to four digits."""
    assert criterion.wilson(15, 20) == pytest.approx((0.5313, 0.8881), abs=5e-5)
    assert criterion.wilson(0, 20) == pytest.approx((0.0, 0.1611), abs=5e-5)


@pytest.mark.parametrize(
    ("change", "counted"),
    [
        ({}, (True, True)),
        ({"held": "0.9"}, (True, False)),
        ({"effort_change": "-0.021"}, (False, False)),
        ({"effort_change": "nan"}, (False, False)),
        ({"solved_twice": "0"}, (False, False)),
        ({"solved": 0, "solved_twice": "", "effort_change": "", "held": ""}, (False, False)),
    ],
)
def test_a_success_is_solved_twice_alike_and_holds(change, counted):
    assert criterion.succeeded(GOOD | change) == counted


@pytest.mark.studies
def test_a_row_of_each_table_is_found_again(tmp_path):
    """A search from a random guess and a climb, each with its check at twice the mesh and forward."""
    import contacts
    import success

    climbed = success.in_order(contacts.ladder(tmp_path / "ladder", 3).manifest, "stiffness")
    (tmp_path / "grid").mkdir()
    stiff = success.in_order(contacts.grid(tmp_path / "grid", dissipations=(1.0,)).manifest, "stiffness")[-1]
    for table, seed, kind, path, below in (
        ("success", 6, {"point": "stiff"}, stiff, ()),
        ("ladder", 1, {"way": "3 rungs"}, climbed[-1], climbed[:-1]),
    ):
        (known,) = [row for row in success.read(table) if row["seed"] == str(seed) and kind.items() <= row.items()]
        found = success.attempt(path, seed, below)
        assert criterion.succeeded({name: str(value) for name, value in found.items()}) == criterion.succeeded(known)
        assert found["effort"] == pytest.approx(float(known["effort"]), rel=1e-3)
