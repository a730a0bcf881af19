//! Tests the equations as Python calls them: Python has every equation, and its values agree with 50-digit arithmetic.
//!
//! The library is made for Python and cannot be linked to a test, so its module is included here.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};

use contact_scaling::modulus::MixingRule;
use contact_scaling::{continuation, equations};

#[path = "../crates/osim-python/src/scaling/mod.rs"]
mod scaling;

use scaling::{
    EquationError, Function, MIXING_RULES, SPHERE_LIST_FUNCTIONS, mean_square_radius, rule_by_name,
};

/// Inputs of each function of `contact-scaling`, and its values in 50-digit arithmetic.
const REFERENCE_VALUES: &str = include_str!("../crates/contact-scaling/tests/data/reference.csv");
/// Largest relative difference from the reference. It is the largest tolerance in the tests of `contact-scaling`.
const RELATIVE_ROUNDING_ERROR: f64 = 2e-14;
const PAGE_OF_EQUATIONS: &str = include_str!("../docs/reference/equations.md");

/// Functions on the page of equations that Python does not have, each with the reason.
const FUNCTIONS_NOT_IN_PYTHON: [(&str, &str); 0] = [];

const COLUMNS_OF_SMOOTHED_LAWS: &[&str] = &[
    "composite_modulus",
    "radius",
    "dissipation",
    "constant_contact_force",
    "hertz_smoothing",
    "hunt_crossley_smoothing",
    "indentation",
    "speed",
];
const COLUMNS_OF_RATIOS: &[&str] = &["mass_ratio", "sphere_count_ratio", "radius_ratio", "gravity_ratio"];

/// Columns of the reference for a function. They are not always its arguments in order: Hertz's law has η third, and smoothed laws
/// and ratios have all their columns.
fn columns(function: &Function) -> Vec<&'static str> {
    let (owner, name) = function.computes.split_once("::").unwrap();
    match (owner, name) {
        ("Hertz", name) => {
            let last = match name {
                "indentation_from_force" => "force",
                name if name.contains("at_relative") || name == "indentation" => "relative_indentation",
                _ => "indentation",
            };
            vec!["composite_modulus", "radius", "shape_factor", last]
        }
        ("SmoothSphere", _) => COLUMNS_OF_SMOOTHED_LAWS.to_vec(),
        ("Ratios", _) => COLUMNS_OF_RATIOS.to_vec(),
        ("design", "composite_modulus") => vec!["radius", "relative_indentation", "load", "sphere_count"],
        _ => {
            let required = function.parameters.iter().filter(|parameter| parameter.default.is_none());
            required.map(|parameter| parameter.name).collect()
        }
    }
}

/// Rows of the reference for a function of `contact-scaling`: the inputs and the value.
fn rows_of_reference(computes: &str) -> Vec<(Vec<f64>, f64)> {
    let rows = REFERENCE_VALUES.lines().filter_map(|line| {
        let [name, inputs, value] = line.split(',').collect::<Vec<_>>()[..] else { return None };
        let inputs = inputs.split(' ').map(|input| input.parse().unwrap_or(f64::NAN)).collect();
        (name == computes).then(|| (inputs, value.parse().unwrap()))
    });
    rows.collect()
}

/// Arguments for a call of `function`: the `inputs` of a row of the reference, and defaults for all other arguments.
fn arguments_from_row(function: &Function, inputs: &[f64]) -> Vec<f64> {
    let names = columns(function);
    assert_eq!(names.len(), inputs.len(), "{}", function.name);
    let named: BTreeMap<&str, f64> = names.into_iter().zip(inputs.iter().copied()).collect();
    let argument = |name: &str, default| named.get(name).copied().or(default);
    function.parameters.iter().map(|p| argument(p.name, p.default).expect(p.name)).collect()
}

#[track_caller]
fn assert_close(value: f64, expected: f64, what: &str) {
    assert!(
        (value - expected).abs() <= RELATIVE_ROUNDING_ERROR * expected.abs(),
        "{what}: {value:e}, expected {expected:e}"
    );
}

#[test]
fn python_has_every_function_on_the_page_of_equations() {
    let rows = PAGE_OF_EQUATIONS.lines().filter(|line| line.starts_with('|'));
    let names = rows.flat_map(|row| row.split('|').nth(3).unwrap().split('`').skip(1).step_by(2));
    let page: BTreeSet<&str> = names.filter(|name| name.contains("::")).collect();
    assert!(page.len() > 60, "the tables of docs/reference/equations.md were not understood");
    let of_spheres = SPHERE_LIST_FUNCTIONS.iter().flat_map(|function| [function.level, function.raised]);
    let here: BTreeSet<&str> = scaling::all()
        .map(|function| function.computes)
        .chain(of_spheres)
        .chain([mean_square_radius::COMPUTES])
        .chain(FUNCTIONS_NOT_IN_PYTHON.map(|(name, _)| name))
        .collect();
    assert_eq!(here, page);
}

#[test]
fn every_function_agrees_with_50_digit_arithmetic() {
    for function in scaling::all() {
        let rows = rows_of_reference(function.computes);
        assert!(!rows.is_empty(), "{} has no reference value", function.name);
        for (inputs, expected) in rows {
            let value = function.value(MixingRule::Sherman, &arguments_from_row(function, &inputs)).unwrap();
            assert_close(value, expected, function.name);
        }
    }
}

#[test]
fn an_array_gives_the_value_of_each_element() {
    for function in scaling::all() {
        let rows = rows_of_reference(function.computes);
        let rows: Vec<Vec<f64>> =
            rows.iter().map(|(inputs, _)| arguments_from_row(function, inputs)).collect();
        let columns: Vec<Vec<f64>> =
            (0..function.parameters.len()).map(|i| rows.iter().map(|row| row[i]).collect()).collect();
        let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        let values = function.values(MixingRule::Sherman, &columns).unwrap();
        for (value, (_, expected)) in values.iter().zip(rows_of_reference(function.computes)) {
            assert_close(*value, expected, function.name);
        }
    }
}

fn function_called(name: &str) -> &'static Function {
    scaling::all().find(|function| function.name == name).unwrap()
}

#[test]
fn a_number_beside_an_array_is_used_for_all_its_elements() {
    // (14): α ∝ 1/√(ρ γ). With γ = 4: 1/√4 and 1/√16; on their own 1 and 1/2.
    let dissipation = function_called("dissipation");
    let values = |lists: &[&[f64]]| dissipation.values(MixingRule::Sherman, lists);
    assert_eq!(values(&[&[1.0, 4.0], &[4.0]]).unwrap(), [0.5, 0.25]);
    assert_eq!(values(&[&[4.0], &[1.0]]).unwrap(), [0.5]);
    assert_eq!(values(&[&[], &[1.0]]).unwrap(), []);
    let message = |lists: &[&[f64]]| values(lists).unwrap_err().to_string();
    assert_eq!(
        message(&[&[1.0, 2.0, 3.0], &[1.0, 2.0]]),
        "gravity_ratio: the number of elements is 2, expected one, or as many as the other arguments have"
    );
    assert_eq!(
        message(&[&[1.0, 2.0, -3.0], &[1.0]]),
        "radius_ratio[2] is -3.0, expected a finite number above 0"
    );
    assert_eq!(message(&[&[1.0, 2.0], &[0.0]]), "gravity_ratio is 0.0, expected a finite number above 0");
    assert_eq!(message(&[&[1.0, f64::NAN], &[1.0]]), "radius_ratio[1] is NaN, expected a finite number");
    assert_eq!(
        values(&[&[1.0, 2.0, -3.0], &[1.0]]).unwrap_err().message("[2, 0]"),
        "radius_ratio[2, 0] is -3.0, expected a finite number above 0"
    );
    assert!(message(&[&[1.0]]).contains("the number of arguments is 1"));
}

#[test]
fn a_fault_of_several_arguments_names_the_element() {
    // 1 − 2 · 0.6 is below 0.
    let failure = function_called("approximate_restitution")
        .values(MixingRule::Sherman, &[&[2.0], &[0.1, 0.6]])
        .unwrap_err();
    assert_eq!((failure.parameter, failure.index), (None, Some(1)));
    let message = failure.to_string();
    assert!(
        message.starts_with("restitution by (13) at [1] is -0.") && message.contains("from 0 to 1"),
        "{message}"
    );
    // 4/3 · 1e200 · (1e100)^(3/2) is more than a float holds.
    let failure =
        function_called("hertz_force").value(MixingRule::Sherman, &[1e200, 1.0, 1e100, 1.0]).unwrap_err();
    assert_eq!(
        failure.to_string(),
        "the result is inf, expected a finite number: an argument is far too large or too small"
    );
}

/// The message names the refused argument, for every argument of every function.
#[test]
fn the_argument_that_is_refused_is_named() {
    for function in scaling::all() {
        let (inputs, _) = rows_of_reference(function.computes).remove(0);
        let good = arguments_from_row(function, &inputs);
        for (index, parameter) in function.parameters.iter().enumerate() {
            for bad in [f64::NAN, f64::INFINITY, -1.5, 0.0, 1.5] {
                let mut arguments = good.clone();
                arguments[index] = bad;
                let Err(failure) = function.value(MixingRule::Sherman, &arguments) else {
                    assert!(bad.is_finite(), "{}: {} = {bad}", function.name, parameter.name);
                    continue;
                };
                // Only these are about two arguments together.
                let together = ["restitution by (13)", "dissipation times impact speed", "the result"];
                if !together.contains(&failure.quantity) {
                    assert_eq!(failure.parameter, Some(parameter.name), "{}: {failure}", function.name);
                    assert!(failure.value == bad || bad.is_nan(), "{}: {failure}", function.name);
                }
            }
        }
    }
}

#[test]
fn the_mixing_rule_is_named_by_a_word() {
    assert_eq!(
        MIXING_RULES.map(|(name, _)| rule_by_name(name)),
        [Some(MixingRule::Sherman), Some(MixingRule::Johnson)]
    );
    assert_eq!(rule_by_name("hertz"), None);
    // (A.4): 2^p E*, p = 1 with Johnson's rule, 3/2 with Sherman's.
    for (name, factor) in [("johnson", 2.0), ("sherman", 2.0_f64 * 2.0_f64.sqrt())] {
        let rule = rule_by_name(name).unwrap();
        assert_close(
            function_called("plane_strain_modulus_of_equal_surfaces").value(rule, &[1e6]).unwrap(),
            factor * 1e6,
            name,
        );
        assert_close(
            function_called("composite_modulus_of_equal_surfaces").value(rule, &[1e6]).unwrap(),
            1e6 / factor,
            name,
        );
    }
    let with_rule = scaling::all().filter(|function| function.takes_rule).count();
    assert_eq!(with_rule, 2);
}

/// Names are valid in Python and differ from each other; arguments with defaults are last.
#[test]
fn names_and_defaults_of_functions_are_valid_in_python() {
    let lists = SPHERE_LIST_FUNCTIONS.iter().map(|function| function.name).chain([mean_square_radius::NAME]);
    let mut seen = BTreeSet::from(["continuation_steps"]);
    for name in scaling::all().map(|function| function.name).chain(lists) {
        assert!(seen.insert(name), "{name} is there twice");
    }
    for function in scaling::all() {
        let mut names = BTreeSet::new();
        let mut with_default = false;
        for parameter in function.parameters {
            assert!(names.insert(parameter.name), "{}: {}", function.name, parameter.name);
            assert!(parameter.default.is_some() || !with_default, "{}: {}", function.name, parameter.name);
            with_default = parameter.default.is_some();
        }
    }
}

/// Arguments and results have the units in the register, and every docstring names its source.
#[test]
fn docstrings_come_from_the_register() {
    for function in scaling::all() {
        let (symbol, unit) =
            (function.returns.symbol(), function.forms().next().map_or("", |(_, form)| form.unit));
        let text = function.docstring();
        let is_factor = text.contains("The factor, without unit, of ");
        assert!(if is_factor { unit == "1" } else { symbol.unit == unit }, "{}: {unit}", function.name);
        for (equation, form) in function.forms() {
            assert!(text.contains(form.formula) && text.contains(equation.source), "{text}");
        }
        for parameter in function.parameters {
            assert!(text.contains(&format!("\n{} : float or array_like", parameter.name)), "{text}");
            assert!(text.contains(parameter.symbol.meaning), "{text}");
        }
    }
    assert_eq!(
        function_called("hertz_indentation").docstring(),
        "Hertz force of one sphere, solved for x.\n\n    \
         x = (F_e / (4/3 η √R E*))^(2/3)    (1)\n\n\
         Parameters\n----------\n\
         composite_modulus : float or array_like\n    \
         E*: composite plane strain modulus of the contact; in N/m².\n\
         radius : float or array_like\n    R: radius of the sphere (OpenSim: radius); in m.\n\
         force : float or array_like\n    F_e: elastic force of one sphere; in N.\n\
         shape_factor : float or array_like, default 1\n    η: shape factor, 1 for spheres; without unit.\n\n\
         Returns\n-------\nfloat or numpy.ndarray\n    \
         x: indentation: how far sphere and ground overlap; in m.\n\n\
         References\n----------\n\
         (1): Van Bijlert (2026), section 2; Hertz's law as in Johnson (1985) and Sherman et al. (2011).\n"
    );
    let [hertz, smooth] = &SPHERE_LIST_FUNCTIONS;
    for text in [hertz.docstring(), smooth.docstring(), mean_square_radius::docstring_of_function()] {
        assert!(
            text.contains("\nradius : sequence of float\n    R_i: ") && text.contains("beyond the paper"),
            "{text}"
        );
    }
    let ratio = function_called("dissipation").docstring();
    assert!(ratio.contains("The factor, without unit, of α: Hunt–Crossley dissipation"), "{ratio}");
    let design = function_called("composite_modulus_for_indentation").docstring();
    // What is in the formula and no argument.
    assert!(
        design.contains("where\n\n    η: shape factor, 1 for spheres; without unit\n\nParameters"),
        "{design}"
    );
    let stiffness = function_called("dimensionless_hertz_stiffness").docstring();
    assert!(!stiffness.contains("where"), "k is not in k̂: {stiffness}");
}

#[test]
fn equilibrium_on_spheres_agrees_with_50_digit_arithmetic() {
    let [hertz, smooth] = &SPHERE_LIST_FUNCTIONS;
    for (name, raised) in [("indentation", false), ("indentation_of_lowest", true)] {
        for (prefix, function) in [("hertz_", hertz), ("", smooth)] {
            let computes = format!("equilibrium::{prefix}{name}");
            let rows = rows_of_reference(&computes);
            assert!(!rows.is_empty(), "{computes}");
            for (inputs, expected) in rows {
                // E*, R, α, cf, bd, bv, n, F, and the height of as many spheres again.
                let columns: Vec<&[f64]> = if prefix.is_empty() {
                    inputs[..7].iter().map(std::slice::from_ref).collect()
                } else {
                    [0, 1, 6].iter().map(|&i| std::slice::from_ref(&inputs[i])).collect()
                };
                let heights: Option<Vec<f64>> = raised.then(|| vec![0.0, inputs[8]]);
                let value = function.value(&columns, heights.as_deref(), inputs[7]).unwrap();
                assert_close(value, expected, &computes);
            }
        }
    }
}

#[test]
fn the_error_names_the_refused_sphere() {
    let [hertz, smooth] = &SPHERE_LIST_FUNCTIONS;
    let message = |columns: &[&[f64]], heights: Option<&[f64]>, load: f64| {
        hertz.value(columns, heights, load).unwrap_err().to_string()
    };
    let (modulus, radius): (&[f64], &[f64]) = (&[1e6], &[0.03, 0.02]);
    assert_eq!(
        message(&[modulus, &[0.03, 0.0], &[1.0]], None, 600.0),
        "radius[1] is 0.0, expected a finite number above 0"
    );
    assert_eq!(
        message(&[modulus, radius, &[1.0, f64::NAN]], None, 600.0),
        "number_of_spheres[1] is NaN, expected a finite number"
    );
    assert_eq!(
        message(&[modulus, radius, &[1.0, 0.0]], None, 600.0),
        "number_of_spheres[1] is 0.0, expected a finite number above 0"
    );
    assert_eq!(
        message(&[modulus, radius, &[1.0]], Some(&[0.0, -0.1]), 600.0),
        "height[1] is -0.1, expected finite and not below 0"
    );
    assert_eq!(
        message(&[modulus, radius, &[1.0]], None, -1.0),
        "load is -1.0, expected a finite number above 0"
    );
    assert_eq!(message(&[modulus, radius, &[1.0]], None, f64::NAN), "load is NaN, expected a finite number");
    assert!(message(&[modulus, radius, &[1.0, 1.0, 1.0]], None, 1.0).contains("the number of elements is 3"));
    assert_eq!(
        message(&[modulus, radius, &[1.0]], Some(&[0.02, 0.01]), 600.0),
        "height is 0.01, expected 0 for the lowest sphere: heights are above that one"
    );
    assert_eq!(message(&[&[], &[], &[]], None, 1.0), "the number of spheres is 0.0, expected 1 or more");
    let cf = smooth.value(&[&[1e6], &[0.03], &[2.0], &[-1e-5], &[300.0], &[50.0], &[1.0]], None, 1.0);
    assert_eq!(
        cf.unwrap_err().to_string(),
        "constant_contact_force is -1e-5, expected a finite number, 0 or above"
    );
}

#[test]
fn a_list_of_radii_has_one_mean_square() {
    // (9 + 16) / 2
    assert_eq!(mean_square_radius::value(&[3.0, 4.0]).unwrap(), 12.5);
    let message = |radii: &[f64]| mean_square_radius::value(radii).unwrap_err().to_string();
    assert_eq!(message(&[3.0, -1.0]), "radius[1] is -1.0, expected a finite number above 0");
    assert_eq!(message(&[3.0, 4.0, f64::NAN]), "radius[2] is NaN, expected a finite number");
    assert_eq!(message(&[]), "number of spheres is 0.0, expected a finite number above 0");
}

#[test]
fn continuation_steps_end_at_the_wanted_contact() {
    let ladder = continuation::steps(1.2, 9.375, 8.0, 3).unwrap();
    // Equally far apart in the logarithm: √(1.2 · 9.375); (1.2 / 9.375)^(3/2) = 0.128^1.5; √8.
    assert_eq!(ladder.len(), 3);
    assert_close(ladder[1].dimensionless_stiffness, 11.25_f64.sqrt(), "stiffness");
    assert!((ladder[0].modulus_factor - 0.045_794_65).abs() < 5e-8);
    assert_close(ladder[1].dissipation_factor, 8.0_f64.sqrt(), "dissipation");
    assert_eq!((ladder[2].modulus_factor, ladder[2].dissipation_factor), (1.0, 1.0));
    let failure = EquationError::from(continuation::steps(2.0, 1.0, 8.0, 3).unwrap_err());
    assert!(failure.to_string().contains("dimensionless stiffness of the first step is 2.0"), "{failure}");
}

#[test]
fn every_computable_equation_of_the_paper_has_a_function() {
    let computes: BTreeSet<&str> = scaling::all().map(|function| function.computes).collect();
    let numbered = equations::all().filter(|equation| equations::reference(equation.label).starts_with('('));
    for equation in numbered {
        for form in equation.forms.iter().filter(|form| !form.function.is_empty()) {
            assert!(computes.contains(form.function), "{}: {}", equation.label, form.function);
        }
    }
}
