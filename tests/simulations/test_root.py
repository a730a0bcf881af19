"""Places where functions cross 0, compared with arithmetic."""

import math

import pytest
from osim_contact_scale.simulate._root import find_root


@pytest.mark.parametrize(
    ("function", "left", "right", "crossing"),
    [
        (math.cos, 1.0, 2.0, math.pi / 2),
        (lambda x: x**3 - 2, 0.0, 2.0, 2 ** (1 / 3)),
        (lambda x: math.expm1(30 * (x - 0.9)), 0.0, 1.0, 0.9),
        (lambda x: x - 0.2 if x > 0.2 else 1e-3 * (x - 0.2), 0.0, 100.0, 0.2),
        (lambda x: max(x, 0.0) ** 1.5 - 1, -1.0, 9.0, 1.0),
    ],
)
def test_a_crossing_is_found_from_either_end(function, left, right, crossing):
    for ends in ((left, right), (right, left)):
        assert find_root(function, *ends, close=1e-14) == pytest.approx(crossing, rel=1e-9)


def test_an_end_may_be_the_crossing():
    assert find_root(math.sin, 0.0, 1.0, close=0.0) == 0.0
    assert find_root(lambda x: x - 1, 0.0, 1.0, close=0.0) == 1.0


def test_no_crossing_is_an_error():
    with pytest.raises(ValueError, match="same sign"):
        find_root(math.exp, 0.0, 1.0, close=0.0)


def test_it_needs_few_calls():
    """Each call may be a simulation."""
    calls = []

    def function(x):
        calls.append(x)
        return 1.5 - math.sqrt(x)

    assert find_root(function, 1.0, 4.0, close=1e-12) == pytest.approx(2.25, rel=1e-12)
    assert len(calls) < 15
