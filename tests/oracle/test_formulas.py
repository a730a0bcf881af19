"""The formulas that `explain` prints, computed as they stand, give the values of 50-digit arithmetic.

A formula is text; a slip of the hand in it would mislead whoever reads it, and no other test would notice.
"""

import csv
import json
import math
import re
import subprocess

import pytest

import command
import schemas

REFERENCE = command.ROOT / "crates/contact-scaling/tests/data/reference.csv"
NUMBER, NAME = r"\d+(?:\.\d+)?(?:e-?\d+)?", r"[A-Za-z_]\w*"
FUNCTIONS = {"sqrt": math.sqrt, "tanh": math.tanh, "atanh": math.atanh}
RATIOS = "M n R g"  # those of b to those of a
HERTZ, SMOOTH = "E* R eta", "E* R alpha cf bd bv x xdot"

# Label and variant of a formula: the function of reference.csv, and what its inputs are called in the formula.
FORMULAS = {
    ("1", ""): ("Hertz::force", f"{HERTZ} x"),
    ("1", "for x"): ("Hertz::indentation_from_force", f"{HERTZ} F_e"),
    ("2", ""): ("Hertz::relative_indentation", f"{HERTZ} x"),
    ("2", "for x"): ("Hertz::indentation", f"{HERTZ} xhat"),
    ("3", ""): ("Hertz::force_at_relative_indentation", f"{HERTZ} xhat"),
    ("8", ""): ("Ratios::plane_strain_modulus", RATIOS),
    ("10", ""): ("Ratios::plane_strain_modulus", "M_b n_b R_b g"),
    ("11", ""): ("design::composite_modulus", "R xhat F n"),
    ("11", "for xhat"): ("design::relative_indentation", "E* R F n"),
    ("12", "the sum"): ("HuntCrossley::force", "E* R alpha x xdot"),
    ("12", ""): ("HuntCrossley::dissipative_force", "E* R alpha x xdot"),
    ("13", ""): ("restitution::approximate", "alpha xdot_before"),
    ("13", "for alpha"): ("restitution::dissipation", "c_r xdot_before"),
    ("14", ""): ("Ratios::dissipation", RATIOS),
    ("14", "by mass"): ("Ratios::dissipation_by_mass", RATIOS),
    ("15", ""): ("patch::mean_stress", "F_c R xhat"),
    ("A.1", ""): ("modulus::plane_strain", "E1 nu1"),
    ("A.2", ""): ("modulus::composite_johnson", "E1* E2*"),
    ("A.3", ""): ("modulus::composite_sherman", "E1* E2*"),
    ("A.4", ""): ("modulus::of_equal_surfaces", "E*"),
    ("A.4", "for E*"): ("modulus::composite_of_equal", "E1*"),
    ("A.5", "to write"): ("modulus::stiffness_on_rigid_ground", "E1 nu1"),
    ("Simbody", ""): ("modulus::mixed_dissipation", "E1* alpha1 E2* alpha2"),
    ("Johnson", ""): ("modulus::composite_radius", "R1 R2"),
    ("B.1", ""): ("Hertz::stiffness", f"{HERTZ} x"),
    ("B.2", ""): ("Hertz::stiffness_at_relative_indentation", f"{HERTZ} xhat"),
    ("B.2", "for E*"): ("design::composite_modulus_for_stiffness", "k R xhat"),
    ("B.2", "with (11)"): ("design::radius_for_stiffness", "k xhat F n"),
    ("B.3", ""): ("stiffness::dimensionless", "k R F_c n"),
    ("B.3", "Hertz"): ("stiffness::dimensionless_hertz", "xhat"),
    ("B.4", ""): ("stiffness::natural_frequency", "k M"),
    ("B.5", ""): ("stiffness::equilibrium_frequency", "xhat_eq R g"),
    ("C.1", ""): ("SmoothSphere::constant_indentation_force", SMOOTH),
    ("C.2", ""): ("smoothing::constant_contact_force", "xhat_c R"),
    ("C.2", "for xhat_c"): ("smoothing::constant_indentation", "cf R"),
    ("C.2", "a to b"): ("Ratios::constant_contact_force", RATIOS),
    ("C.3", ""): ("SmoothSphere::elastic_force", SMOOTH),
    ("C.4", ""): ("SmoothSphere::contact_state", SMOOTH),
    ("C.5", ""): ("smoothing::hertz_smoothing", "b_xhat R"),
    ("C.5", "a to b"): ("Ratios::hertz_smoothing", RATIOS),
    ("C.6", ""): ("smoothing::threshold_indentation", "t bd R"),
    ("C.7", ""): ("smoothing::transition_width", "t bd R"),
    ("C.8", ""): ("smoothing::hertz_smoothing_for_width", "t Delta_xhat R"),
    ("C.9", ""): ("SmoothSphere::force", SMOOTH),
    ("C.9", "second factor"): ("SmoothSphere::speed_state", SMOOTH),
    ("C.9", "second factor at rest"): ("smoothing::speed_state_at_rest", "alpha bv"),
    ("C.9", "at rest"): ("SmoothSphere::rest_force", SMOOTH),
    ("C.10", ""): ("smoothing::hunt_crossley_smoothing", "b_xdot R"),
    ("C.10", "from a speed"): ("smoothing::hunt_crossley_smoothing_for_speed_width", "t Delta_v"),
    ("C.10", "as printed"): ("smoothing::hunt_crossley_smoothing_for_reduced_width", "t Delta_xdot R"),
    ("C.10", "a to b"): ("Ratios::hunt_crossley_smoothing", RATIOS),
}


def explained():
    """Formulas in plain letters, by label and variant."""
    process = subprocess.run([command.BINARY, "explain", "--format", "json"], check=True, capture_output=True)
    topics = [json.loads(line) for line in process.stdout.decode("utf-8").splitlines()]
    spelled = {"x̂": "xhat", "α": "alpha", "x̂_c": "xhat_c"}
    result = {}
    for topic in topics:
        schemas.check("explain", topic)
        for formula in topic.get("formulas", []):
            variant = formula["variant"]
            for symbol in sorted(spelled, key=len, reverse=True):
                variant = variant.replace(symbol, spelled[symbol])
            result.setdefault((topic["label"], variant), formula["ascii"])
    return result


@pytest.fixture(scope="module")
def formulas():
    return explained()


def python(expression):
    """The expression as Python reads it: products written out, `E*` and `E1*` as names."""
    expression = re.sub(r"\b(E[12]?)\*", r"\1_star", expression).replace("^", "**")
    tokens = re.findall(rf"{NUMBER}|{NAME}|\*\*|[-+*/()]", expression)
    out = []
    for token in tokens:
        if out and re.match(rf"{NUMBER}$|{NAME}$|\($", token) and re.match(rf"{NUMBER}$|{NAME}$|\)$", out[-1]):
            if not (token == "(" and out[-1] in FUNCTIONS):
                out.append("*")
        out.append(token)
    return "".join(out)


def value_of(expression, values):
    names = {name.replace("*", "_star"): value for name, value in values.items()}
    return eval(python(expression), {"__builtins__": {}}, FUNCTIONS | {"pi": math.pi} | names)


def right_hand_side(formula):
    """The text after the equals sign, without a second equation that defines a symbol of the first."""
    return re.split(r" [=~] ", formula, maxsplit=1)[-1].replace("s_c(x)", "s_c")


def inputs_of(names, numbers):
    values = {"eta": 1.0, "p": 1.5, "M_a": 1.0, "n_a": 1.0, "R_a": 1.0, "E*_a": 1.0}
    return values | dict(zip(names.split(), numbers, strict=True))


def complete(values, formulas):
    """Forces that a formula takes from another formula."""
    if "x" in values:
        values.setdefault("F_e", value_of(right_hand_side(formulas["1", ""]), values))
    if "cf" in values and "bd" in values:
        values["F_cf"] = value_of(right_hand_side(formulas["C.1", ""]), values)
        values["s_c"] = value_of(right_hand_side(formulas["C.4", ""]), values)
        values["F_s"] = value_of(right_hand_side(formulas["C.3", ""]), values)
    return values


def rows_of(function):
    with REFERENCE.open(encoding="utf-8") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        result = [([float(x) for x in row[1].split()], float(row[2])) for row in rows if row[0] == function]
    assert result, f"{function} is not in reference.csv"
    return result


@pytest.mark.parametrize("key", FORMULAS, ids=lambda key: " ".join(key).strip())
def test_the_printed_formula_is_the_equation(key, formulas):
    function, names = FORMULAS[key]
    for numbers, wanted in rows_of(function):
        values = complete(inputs_of(names, numbers), formulas)
        expression = right_hand_side(formulas[key])
        if key == ("Simbody", ""):
            expression, share = expression.split(", s1 = ")
            values["s1"] = value_of(share, values)
        got = value_of(expression, values)
        if function.startswith("Ratios::"):
            # The page says which power of gravity comes in addition, as an extension.
            power = {"plane_strain_modulus": 1, "dissipation": -0.5, "dissipation_by_mass": -0.5, "hunt_crossley_smoothing": -0.5}
            got *= numbers[3] ** power.get(function.removeprefix("Ratios::"), 0)
        if key == ("12", "the sum"):
            got = max(got, 0.0)
        assert got == pytest.approx(wanted, rel=1e-9, abs=1e-300), f"{expression} with {values}"


def test_no_formula_is_left_out(formulas):
    """Every numbered equation that computes something; (4) to (7) are steps, (9) is (10), (A.5) a limit, (C.3) and (C.9) have slopes."""
    left = {("4", ""), ("5", ""), ("6", ""), ("7", ""), ("9", ""), ("A.5", "")}
    left |= {("C.3", "its slope"), ("C.9", "its slope at rest")}
    numbered = {key for key in formulas if re.match(r"\d|[ABC]\.\d", key[0])}
    assert numbered - set(FORMULAS) == left
