"""The equations over arrays: equal to numbers one by one, equal to high precision, and clear where an element is wrong."""

import inspect
import subprocess
import sys

import mpmath
import numpy as np
import osim_contact_scale as ocs
import pytest
from osim_contact_scale import scaling

NUMBERS = [
    (name, [one for one, _ in parameters])
    for name, kind, parameters, *_ in ocs._native.equations()
    if kind == "numbers"
]

# Where a plain number between 0.2 and 0.9 is outside of the domain.
RANGES = {
    "sphere_count": (1.0, 9.0),
    "threshold": (0.01, 0.2),
    "poissons_ratio": (0.0, 0.49),
    "restitution": (0.5, 0.99),
}


def points(parameters, count=7):
    random = np.random.default_rng(20260101)
    return {name: random.uniform(*RANGES.get(name, (0.2, 0.9)), count) for name in parameters}


@pytest.mark.parametrize(("name", "parameters"), NUMBERS, ids=[name for name, _ in NUMBERS])
def test_arrays_equal_numbers_one_by_one(name, parameters):
    function, arguments = getattr(scaling, name), points(parameters)
    values = function(**arguments)
    assert isinstance(values, np.ndarray) and values.dtype == np.float64
    singles = [function(**{key: float(column[row]) for key, column in arguments.items()}) for row in range(7)]
    assert all(type(single) is float for single in singles)
    assert [value.hex() for value in values.tolist()] == [single.hex() for single in singles]


# From the paper, in 50-digit arithmetic.
PAPER = {
    "hertz_force": lambda composite_modulus, radius, indentation, shape_factor: mpmath.mpf(4) / 3 * shape_factor * mpmath.sqrt(radius) * composite_modulus * indentation ** mpmath.mpf(1.5),
    "plane_strain_modulus": lambda mass_ratio, sphere_count_ratio, radius_ratio, gravity_ratio: mass_ratio * gravity_ratio / (sphere_count_ratio * radius_ratio**2),
    "dissipation": lambda radius_ratio, gravity_ratio: 1 / mpmath.sqrt(radius_ratio * gravity_ratio),
    "dissipation_by_mass": lambda mass_ratio, gravity_ratio: mass_ratio ** (-mpmath.mpf(1) / 6) / mpmath.sqrt(gravity_ratio),
    "constant_contact_force": lambda radius_ratio: radius_ratio**2,
    "hertz_smoothing": lambda radius_ratio: 1 / radius_ratio,
    "hunt_crossley_smoothing": lambda radius_ratio, gravity_ratio: 1 / mpmath.sqrt(radius_ratio * gravity_ratio),
    "approximate_restitution": lambda dissipation, impact_speed: 1 - dissipation * impact_speed,
    "plane_strain_modulus_of_material": lambda youngs_modulus, poissons_ratio: youngs_modulus / (1 - poissons_ratio**2),
    "hertz_stiffness": lambda composite_modulus, radius, indentation, shape_factor: 2 * shape_factor * mpmath.sqrt(radius) * composite_modulus * mpmath.sqrt(indentation),
    "equilibrium_frequency": lambda relative_indentation, radius, gravity: mpmath.sqrt(mpmath.mpf(3) / 2 * gravity / (relative_indentation * radius)) / (2 * mpmath.pi),
    "contact_state": lambda hertz_smoothing, indentation: (1 + mpmath.tanh(hertz_smoothing * indentation)) / 2,
    "drop_speed": lambda gravity, radius: mpmath.sqrt(gravity * radius / 2),
    "mean_stress": lambda force, radius, relative_indentation: force / (mpmath.pi * radius**2 * relative_indentation),
    "exact_restitution": None,
}  # fmt: skip


@pytest.mark.parametrize("name", [name for name, formula in PAPER.items() if formula])
def test_arrays_equal_high_precision(name):
    arguments = points(dict(NUMBERS)[name], 50)
    values = getattr(scaling, name)(**arguments)
    with mpmath.workdps(50):
        for row, value in enumerate(values):
            exact = PAPER[name](**{key: mpmath.mpf(float(column[row])) for key, column in arguments.items()})
            assert abs(value - exact) <= 1e-15 * abs(exact), (name, row)


def test_exact_restitution_solves_its_equation():
    arguments = points(["dissipation", "impact_speed"], 20)
    values = scaling.exact_restitution(**arguments)
    with mpmath.workdps(50):
        for dissipation, speed, value in zip(*arguments.values(), values):
            d = mpmath.mpf(1.5) * mpmath.mpf(float(dissipation)) * mpmath.mpf(float(speed))
            residual = (
                d - mpmath.log(1 + d) + mpmath.mpf(float(value)) * d + mpmath.log(1 - mpmath.mpf(float(value)) * d)
            )
            assert abs(residual) < 1e-14 * d


def test_table_1_of_the_paper():
    # The horse and the mouse of Table 1 from the human: mass, spheres, radius as printed.
    mass, count, radius = np.array([62, 545, 0.0209]), np.array([6, 4, 2]), np.array([0.032, 0.0637, 0.002])
    ratio = scaling.plane_strain_modulus(
        mass_ratio=mass / 62, sphere_count_ratio=count / 6, radius_ratio=radius / 0.032
    )
    assert ratio[0] == 1 and np.all(np.diff(scaling.dissipation(radius_ratio=radius / 0.032)[[1, 0, 2]]) > 0)
    assert scaling.dissipation(radius_ratio=0.002 / 0.032) * 2 == pytest.approx(8.0, rel=1e-12)  # 8.00 s/m


def test_broadcasting():
    mass, radius = np.array([[1.0], [2.0], [3.0]]), np.array([1.0, 0.5])
    ratio = scaling.plane_strain_modulus(mass_ratio=mass, sphere_count_ratio=1, radius_ratio=radius)
    assert ratio.shape == (3, 2)
    assert ratio.tolist() == [[1.0, 4.0], [2.0, 8.0], [3.0, 12.0]]
    assert scaling.dissipation(radius_ratio=[]).shape == (0,)
    with pytest.raises(ocs.RequestError, match=r"radius_ratio \(2,\)"):
        scaling.plane_strain_modulus(mass_ratio=[1.0, 2.0, 3.0], sphere_count_ratio=1, radius_ratio=radius)


@pytest.mark.parametrize("kind", [int, np.float32, np.int64, object, list, tuple])
def test_other_kinds_of_numbers(kind):
    values = [1, 4] if kind in (list, tuple) else np.array([1, 4], dtype=kind)
    result = scaling.dissipation(radius_ratio=kind(values) if kind in (list, tuple) else values)
    assert result.dtype == np.float64 and result.tolist() == [1.0, 0.5]


def test_a_column_of_a_data_frame():
    pd = pytest.importorskip("pandas", reason="pandas is not installed: tables are lists of dictionaries")
    frame = pd.DataFrame({"radius": [0.032, 0.128, 0.008]})
    assert scaling.dissipation(radius_ratio=frame["radius"] / 0.032).tolist() == [1.0, 0.5, 2.0]


@pytest.mark.parametrize("value", ["1", 1j, None, [True], np.array(["a"]), {"a": 1}])
def test_what_is_no_number_is_refused(value):
    with pytest.raises(TypeError, match="radius_ratio: expected real numbers"):
        scaling.dissipation(radius_ratio=value)


@pytest.mark.parametrize(
    ("array", "place"),
    [
        ([1.0, -3.0, 2.0], "radius_ratio[1]"),
        ([[1.0, 2.0], [np.nan, 3.0]], "radius_ratio[1, 0]"),
        ([1.0, np.inf], "radius_ratio[1]"),
        (0.0, "radius_ratio"),
    ],
)
def test_one_bad_element_is_named(array, place):
    with pytest.raises(ocs.RequestError) as caught:
        scaling.dissipation(radius_ratio=array)
    assert str(caught.value).startswith(f"{place} is ") and caught.value.keyword == "radius_ratio"
    assert isinstance(caught.value, ValueError)


def test_nan_goes_through_where_it_is_wanted():
    # (13) at g'/g = 1: 1/sqrt(R'/R).
    values = scaling.dissipation(radius_ratio=[4.0, np.nan, 16.0], gravity_ratio=1.0, nan="propagate")
    assert values.tolist() == [0.5, pytest.approx(np.nan, nan_ok=True), 0.25]
    ratio = scaling.plane_strain_modulus(
        mass_ratio=[[1.0], [np.nan], [3.0]], sphere_count_ratio=1, radius_ratio=[1.0, 0.5], nan="propagate"
    )
    assert np.array_equal(ratio, [[1.0, 4.0], [np.nan, np.nan], [3.0, 12.0]], equal_nan=True)
    alone = scaling.dissipation(radius_ratio=float("nan"), nan="propagate")
    assert type(alone) is float and np.isnan(alone)
    assert np.isnan(scaling.dissipation(radius_ratio=[4.0, 1.0], gravity_ratio=np.nan, nan="propagate")).all()
    assert scaling.dissipation(radius_ratio=[4.0, 1.0], nan="propagate").tolist() == [0.5, 1.0]


@pytest.mark.parametrize(
    ("array", "place"),
    [
        ([np.nan, 4.0, -1.0], "radius_ratio[2] is -1.0"),
        ([np.nan, -1.0], "radius_ratio[1] is -1.0"),
        ([[np.nan, 4.0], [np.nan, np.inf]], "radius_ratio[1, 1] is inf"),
    ],
)
def test_beside_nan_that_goes_through_errors_are_errors(array, place):
    with pytest.raises(ocs.RequestError) as caught:
        scaling.dissipation(radius_ratio=array, nan="propagate")
    assert str(caught.value).startswith(place)


def test_the_message_of_nan_says_a_way_out():
    with pytest.raises(ocs.RequestError, match=r'radius_ratio\[0\] is NaN, .*nan="propagate"'):
        scaling.dissipation(radius_ratio=[np.nan, 1.0])
    with pytest.raises(ocs.RequestError, match='nan is \'omit\', expected "raise" or "propagate"') as caught:
        scaling.dissipation(radius_ratio=[np.nan, 1.0], nan="omit")
    assert (caught.value.code, caught.value.keyword) == ("usage", "nan")


def test_nan_in_a_list_or_a_ladder():
    assert np.isnan(scaling.mean_square_radius(radius=[3.0, np.nan], nan="propagate"))
    assert scaling.mean_square_radius(radius=[3.0, 4.0], nan="propagate") == 12.5
    spheres = {"load": 100.0, "composite_modulus": 353553.39, "radius": [0.032, 0.032], "height": [0.0, 0.001]}
    for wrong in ({"load": np.nan}, {"radius": [0.032, np.nan]}, {"height": [0.0, np.nan]}):
        assert np.isnan(scaling.hertz_rest_indentation(**spheres | wrong, nan="propagate"))
        with pytest.raises(ocs.RequestError, match='nan="propagate"'):
            scaling.hertz_rest_indentation(**spheres | wrong)
    steps = scaling.continuation_steps(first=np.nan, last=16.0, count=3, nan="propagate")
    assert all(len(column) == 3 and np.isnan(column).all() for column in steps)
    with pytest.raises(ocs.RequestError, match="number of steps"):
        scaling.continuation_steps(first=np.nan, last=16.0, count=1, nan="propagate")


def test_every_function_takes_nan():
    for name in scaling.__all__:
        function = getattr(scaling, name)
        assert inspect.signature(function).parameters["nan"].default == "raise", name
        assert inspect.getdoc(function).count("\nnan : ") == 1, name


def test_importing_the_equations_imports_no_tables():
    code = (
        "import sys, osim_contact_scale.scaling; print([name for name in ('pandas', 'polars') if name in sys.modules])"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout == "[]\n"


def test_a_bad_element_is_named_by_its_place_in_its_own_array():
    with pytest.raises(ocs.RequestError, match=r"^mass_ratio\[2, 0\] is -3\.0"):
        scaling.plane_strain_modulus(mass_ratio=[[1.0], [2.0], [-3.0]], sphere_count_ratio=1, radius_ratio=[1.0, 2.0])


def test_spheres_at_rest():
    # One sphere by hand: x = (F / (4/3 E √R))^(2/3).
    x = scaling.hertz_rest_indentation(load=100.0, composite_modulus=353553.39, radius=[0.032])
    assert x == pytest.approx((100 / (4 / 3 * 353553.39 * 0.032**0.5)) ** (2 / 3), rel=1e-12)
    assert scaling.mean_square_radius(radius=[3.0, 4.0]) == 12.5
    with pytest.raises(ocs.RequestError, match=r"radius\[1\]"):
        scaling.mean_square_radius(radius=[3.0, -4.0])
    with pytest.raises(ocs.RequestError, match="height"):
        scaling.hertz_rest_indentation(
            load=100.0, composite_modulus=353553.39, radius=[0.032, 0.032], height=[0.1, 0.2]
        )


def test_a_ladder():
    steps = scaling.continuation_steps(first=1.0, last=16.0, count=5)
    assert steps.dimensionless_stiffness.tolist() == pytest.approx([1, 2, 4, 8, 16], rel=1e-14)
    # E*_a / E*_b = (k_a / k_b)^(3/2), section 4.3.
    assert steps.modulus_factor.tolist() == pytest.approx([(k / 16) ** 1.5 for k in (1, 2, 4, 8, 16)], rel=1e-14)
    with pytest.raises(ocs.RequestError):
        scaling.continuation_steps(first=-1.0, last=16.0)


def test_every_function_says_its_equation_and_units():
    for name in scaling.__all__:
        text = inspect.getdoc(getattr(scaling, name))
        assert "Parameters" in text and "Returns" in text, name
        assert "unit" in text or " in " in text, name


def test_masked_elements_are_refused():
    depth = np.ma.masked_array([0.001, 1e20], mask=[0, 1])
    with pytest.raises(ocs.RequestError, match="masked"):
        scaling.hertz_force(composite_modulus=1e6, radius=0.03, indentation=depth)
    with pytest.raises(ocs.RequestError, match="masked"):
        scaling.mean_square_radius(radius=depth)
    assert scaling.mean_square_radius(radius=np.ma.masked_array([2.0, 2.0], mask=False)) == 4
