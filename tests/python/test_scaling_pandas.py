"""The equations over Series and DataFrames of pandas: labels come out as they went in."""

import numpy as np
import osim_contact_scale as ocs
import pytest
from osim_contact_scale import scaling

pd = pytest.importorskip("pandas", reason="pandas is not installed: tables are lists of dictionaries")

ANIMALS = pd.Index(["mouse", "human", "horse"], name="animal")
RADIUS = pd.Series([0.25, 1.0, 4.0], index=ANIMALS, name="radius")

NUMBERS = [
    (name, [one for one, _ in parameters])
    for name, kind, parameters, *_ in ocs._native.equations()
    if kind == "numbers"
]
# Where a plain number between 0.2 and 0.4 is outside of the domain.
FIRST = {"sphere_count": 2.0, "threshold": 0.05, "restitution": 0.6}


@pytest.mark.parametrize(("name", "parameters"), NUMBERS, ids=[name for name, _ in NUMBERS])
def test_a_series_equals_numbers_one_by_one(name, parameters):
    function = getattr(scaling, name)
    columns = {key: [FIRST.get(key, 0.2) + 0.05 * row for row in range(3)] for key in parameters}
    values = function(**{key: pd.Series(column, index=ANIMALS, name="x") for key, column in columns.items()})
    singles = [function(**{key: column[row] for key, column in columns.items()}) for row in range(3)]
    pd.testing.assert_series_equal(values, pd.Series(singles, index=ANIMALS, name="x"), check_exact=True)


def test_index_and_name_are_kept():
    # 1/sqrt(R'/R), by hand.
    expected = pd.Series([2.0, 1.0, 0.5], index=ANIMALS, name="radius")
    pd.testing.assert_series_equal(scaling.dissipation(radius_ratio=RADIUS), expected)
    assert scaling.dissipation(radius_ratio=RADIUS).index.name == "animal"
    empty = scaling.dissipation(radius_ratio=RADIUS.iloc[:0])
    pd.testing.assert_series_equal(empty, expected.iloc[:0])


def test_numbers_and_arrays_go_together_with_a_series():
    # m'/m / (n'/n (R'/R)^2), by hand.
    for mass in (2.0, [2.0, 2.0, 2.0], np.array([2.0])):
        ratio = scaling.plane_strain_modulus(mass_ratio=mass, sphere_count_ratio=1, radius_ratio=RADIUS)
        pd.testing.assert_series_equal(ratio, pd.Series([32.0, 2.0, 0.125], index=ANIMALS, name="radius"))


def test_the_name_is_that_of_all():
    assert scaling.dissipation(radius_ratio=RADIUS, gravity_ratio=RADIUS).name == "radius"
    assert scaling.dissipation(radius_ratio=RADIUS, gravity_ratio=RADIUS.rename("gravity")).name is None


@pytest.mark.parametrize("other", [RADIUS.iloc[::-1], RADIUS.iloc[:2], RADIUS.reset_index(drop=True)])
def test_nothing_is_aligned_silently(other):
    with pytest.raises(
        ocs.RequestError, match=r"radius_ratio and gravity_ratio have different indexes: .*\.align"
    ) as caught:
        scaling.dissipation(radius_ratio=RADIUS, gravity_ratio=other)
    assert caught.value.code == "usage" and caught.value.keywords == ("radius_ratio", "gravity_ratio")


def test_what_the_message_says_helps():
    one, other = RADIUS.align(RADIUS.iloc[[2, 0]], join="inner")
    assert scaling.dissipation(radius_ratio=one, gravity_ratio=other).to_dict() == {"mouse": 4.0, "horse": 0.25}
    by_order = scaling.dissipation(radius_ratio=RADIUS, gravity_ratio=RADIUS.iloc[::-1].to_numpy())
    assert by_order.tolist() == [1.0, 1.0, 1.0]


def test_a_result_that_has_no_labels_is_refused():
    with pytest.raises(
        ocs.RequestError, match=r"radius_ratio is a Series of the shape \(3,\).*radius_ratio\.to_numpy\(\)"
    ):
        scaling.dissipation(radius_ratio=RADIUS, gravity_ratio=[[1.0], [2.0]])
    with pytest.raises(ocs.RequestError, match="a Series of pandas, gravity_ratio is a DataFrame of pandas"):
        scaling.dissipation(radius_ratio=RADIUS, gravity_ratio=RADIUS.to_frame())


def test_a_data_frame():
    frame = pd.DataFrame({"left": [0.25, 1.0, 4.0], "right": [1.0, 4.0, 16.0]}, index=ANIMALS)
    expected = pd.DataFrame({"left": [2.0, 1.0, 0.5], "right": [1.0, 0.5, 0.25]}, index=ANIMALS)
    pd.testing.assert_frame_equal(scaling.dissipation(radius_ratio=frame), expected)
    with pytest.raises(ocs.RequestError, match=r"different indexes or columns"):
        scaling.dissipation(radius_ratio=frame, gravity_ratio=frame[["right", "left"]])
    with pytest.raises(ocs.RequestError, match=r"^radius_ratio\[0, 1\] \(index 'mouse', column 'right'\) is -1\.0"):
        scaling.dissipation(radius_ratio=frame * [1, -1])


@pytest.mark.parametrize("kind", ["Float64", "Int64", "float64", "Float32"])
def test_missing_values_are_nan(kind):
    column = pd.Series([1, None, 4], dtype=kind, name="radius")
    values = scaling.dissipation(radius_ratio=column, nan="propagate")
    pd.testing.assert_series_equal(values, pd.Series([1.0, np.nan, 0.5], name="radius"))
    with pytest.raises(ocs.RequestError, match=r"^radius_ratio\[1\] is NaN"):
        scaling.dissipation(radius_ratio=column)
    values = scaling.dissipation(radius_ratio=pd.DataFrame({"a": column, "b": [1.0, 4.0, 4.0]}), nan="propagate")
    pd.testing.assert_frame_equal(values, pd.DataFrame({"a": [1.0, np.nan, 0.5], "b": [1.0, 0.5, 0.5]}))
    assert np.isnan(scaling.mean_square_radius(radius=column, nan="propagate"))


@pytest.mark.parametrize("column", [["1", "4"], [True, False], [1.0, "4"]])
def test_a_series_of_no_numbers_is_refused(column):
    with pytest.raises(TypeError, match="radius_ratio: expected real numbers"):
        scaling.dissipation(radius_ratio=pd.Series(column))


def test_a_bad_element_is_named_by_its_label():
    with pytest.raises(ocs.RequestError, match=r"^radius_ratio\[2\] \(index 'horse'\) is -4\.0"):
        scaling.dissipation(radius_ratio=RADIUS * [1, 1, -1])
    with pytest.raises(ocs.RequestError, match=r"^radius_ratio\[1\] \(index 7\) is -4\.0"):
        scaling.dissipation(radius_ratio=pd.Series([1.0, -4.0], index=[3, 7]))
    # An array beside it is in the same order.
    with pytest.raises(ocs.RequestError, match=r"^gravity_ratio\[1\] \(index 'human'\) is inf"):
        scaling.dissipation(radius_ratio=RADIUS, gravity_ratio=[1.0, np.inf, np.nan], nan="propagate")
    # The label would say the same again.
    with pytest.raises(ocs.RequestError, match=r"^radius_ratio\[1\] is -4\.0"):
        scaling.dissipation(radius_ratio=pd.Series([1.0, -4.0]))


def test_lists_of_spheres():
    radius = pd.Series([3.0, 4.0], index=["heel", "toe"])
    assert type(scaling.mean_square_radius(radius=radius)) is float
    assert scaling.mean_square_radius(radius=radius) == 12.5
    with pytest.raises(ocs.RequestError, match=r"^radius\[1\] \(index 'toe'\) is -4\.0"):
        scaling.mean_square_radius(radius=radius * [1, -1])
    with pytest.raises(ocs.RequestError, match="radius and height have different indexes"):
        scaling.hertz_rest_indentation(load=1.0, composite_modulus=1e6, radius=radius, height=radius.iloc[::-1])
