"""Types of the equations, as type checkers see them."""

import os
import subprocess
import sys

from conftest import TOP

CALLS = """
from typing import Any, assert_type

import numpy as np
import pandas as pd
import polars as pl
from numpy.typing import NDArray
from osim_contact_scale import scaling

# Of np.array without a type, mypy knows no type of elements, and then none of the result.
array: NDArray[np.float64] = np.array([1.0, 2.0])
table = pd.DataFrame({"radius": [1.0, 2.0]})
column: pd.Series[Any] = table["radius"]
wholes = pd.Series([1, 2])
series = pl.Series("radius", [1.0, 2.0])
frame = pl.DataFrame({"radius": [1.0, 2.0]})

assert_type(scaling.dissipation(radius_ratio=4), float)
assert_type(scaling.dissipation(radius_ratio=np.float32(4), gravity_ratio=1.0), float)
assert_type(scaling.dissipation(radius_ratio=array, nan="propagate"), NDArray[np.float64])
assert_type(scaling.dissipation(radius_ratio=[1, 2], gravity_ratio=2), NDArray[np.float64])
assert_type(scaling.dissipation(radius_ratio=[[1.0], [2.0]]), NDArray[np.float64])
assert_type(scaling.dissipation(radius_ratio=column, gravity_ratio=array), "pd.Series[float]")
assert_type(scaling.dissipation(radius_ratio=wholes, gravity_ratio=2), "pd.Series[float]")
assert_type(scaling.dissipation(radius_ratio=table), pd.DataFrame)
assert_type(scaling.dissipation(radius_ratio=2, gravity_ratio=series), pl.Series)
assert_type(scaling.dissipation(radius_ratio=frame), pl.DataFrame)
assert_type(scaling.mean_square_radius(radius=column), float)
assert_type(scaling.mean_square_radius(radius=series), float)
scaling.dissipation(radius_ratio="4")  # type: ignore[arg-type]
"""


def test_mypy_knows_what_comes_out(tmp_path):
    calls = tmp_path / "calls.py"
    calls.write_text(CALLS, encoding="utf-8")
    options = ["--config-file", TOP / "pyproject.toml", "--cache-dir", tmp_path / "cache"]
    command = [sys.executable, "-m", "mypy", *options, calls]
    environment = {**os.environ, "MYPYPATH": str(TOP / "python")}
    ran = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
