"""The equations over Series and DataFrames of polars."""

import numpy as np
import osim_contact_scale as ocs
import polars as pl
import pytest
from osim_contact_scale import scaling
from polars.testing import assert_frame_equal, assert_series_equal


def test_a_series_comes_out_with_its_name():
    # 1/sqrt(R'/R), by hand.
    radius = pl.Series("radius", [0.25, 1.0, 4.0])
    assert_series_equal(scaling.dissipation(radius_ratio=radius), pl.Series("radius", [2.0, 1.0, 0.5]))
    both = scaling.dissipation(radius_ratio=radius, gravity_ratio=pl.Series("gravity", [1, 1, 4]))
    assert_series_equal(both, pl.Series("", [2.0, 1.0, 0.25]))
    assert scaling.mean_square_radius(radius=pl.Series([3, 4])) == 12.5


@pytest.mark.parametrize("kind", [pl.Float64, pl.Float32, pl.Int64, pl.UInt8])
def test_null_is_nan(kind):
    column = pl.Series("radius", [1, None, 4], dtype=kind)
    values = scaling.dissipation(radius_ratio=column, nan="propagate")
    assert_series_equal(values, pl.Series("radius", [1.0, np.nan, 0.5]))
    with pytest.raises(ocs.RequestError, match=r"^radius_ratio\[1\] is NaN"):
        scaling.dissipation(radius_ratio=column)


def test_a_data_frame():
    frame = pl.DataFrame({"left": [0.25, 1.0], "right": [1, None]})
    values = scaling.dissipation(radius_ratio=frame, nan="propagate")
    assert_frame_equal(values, pl.DataFrame({"left": [2.0, 1.0], "right": [1.0, np.nan]}))
    with pytest.raises(ocs.RequestError, match=r"^radius_ratio\[1, 1\] \(column 'right'\) is NaN"):
        scaling.dissipation(radius_ratio=frame)
    with pytest.raises(ocs.RequestError, match="different lengths or columns"):
        scaling.dissipation(radius_ratio=frame, gravity_ratio=frame.select("right", "left"))


def test_what_does_not_go_together_is_refused():
    radius = pl.Series("radius", [1.0, 4.0])
    with pytest.raises(ocs.RequestError, match="radius_ratio and gravity_ratio have different lengths"):
        scaling.dissipation(radius_ratio=radius, gravity_ratio=pl.Series([1.0]))
    with pytest.raises(ocs.RequestError, match="a Series of polars, gravity_ratio is a Series of pandas"):
        scaling.dissipation(radius_ratio=radius, gravity_ratio=radius.to_pandas())
    for column in (["1", "4"], [True, False], [True, None]):
        with pytest.raises(TypeError, match="radius_ratio: expected real numbers"):
            scaling.dissipation(radius_ratio=pl.Series(column))
