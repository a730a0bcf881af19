//! The equations for arrays. Python broadcasts the arrays and hands over the bytes of their numbers.

use contact_scaling::continuation::{self, Step};
use pyo3::exceptions::PyOverflowError;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyByteArray;

use crate::calls_into_rust::without_gil;
use crate::problem::Problem;
use crate::scaling::{
    EquationError, MIXING_RULES, Parameter, SPHERE_LIST_FUNCTIONS, all, mean_square_radius, rule_by_name,
};

/// The placeholder in a message for the indices of an array's element: only Python knows the shapes of its arrays.
const ELEMENT_PLACEHOLDER: &str = "{}";

/// A refusal: the argument, the element of the flattened array, and the message with `{}` for the indices of the element.
type Refusal = (Option<&'static str>, Option<usize>, String);

/// A function: its name, its kind of arguments (`numbers`, `list`, `spheres`), the arguments with their defaults, whether it takes a
/// rule, and its docstring.
type DescribedFunction = (&'static str, &'static str, Vec<(&'static str, Option<f64>)>, bool, String);

/// Every function of `osim_contact_scale.scaling`, in the order of the paper.
#[pyfunction]
pub(crate) fn equations() -> Vec<DescribedFunction> {
    let named =
        |parameters: &[Parameter]| parameters.iter().map(|one| (one.name, one.default)).collect::<Vec<_>>();
    let mut described: Vec<DescribedFunction> = all()
        .map(|one| (one.name, "numbers", named(one.parameters), one.takes_rule, one.docstring()))
        .collect();
    let radius = named(&[mean_square_radius::RADIUS]);
    let docstring = mean_square_radius::docstring_of_function();
    described.push((mean_square_radius::NAME, "list", radius, false, docstring));
    let spheres = SPHERE_LIST_FUNCTIONS.iter();
    described.extend(spheres.map(|one| (one.name, "spheres", named(one.spheres), false, one.docstring())));
    described
}

/// The names of the rules for the modulus of two surfaces; the first is the usual one.
#[pyfunction]
pub(crate) fn mixing_rules() -> Vec<&'static str> {
    MIXING_RULES.iter().map(|(name, _)| *name).collect()
}

/// The result of an equation, or the refusal.
type ValueOrRefusal<T> = (Option<T>, Option<Refusal>);

/// The values of an equation for rows of arguments, as bytes of float64.
#[pyfunction]
pub(crate) fn equation<'py>(
    py: Python<'py>,
    name: &str,
    rule_name: Option<&str>,
    columns: Vec<PyBackedBytes>,
) -> PyResult<ValueOrRefusal<Bound<'py, PyByteArray>>> {
    let values = without_gil(py, || {
        let Some(function) = all().find(|one| one.name == name) else { return Err(unknown_equation(name)) };
        let rule = rule_by_name(rule_name.unwrap_or(OPENSIM_RULE));
        let rule = rule.ok_or_else(|| unknown_mixing_rule(rule_name))?;
        let columns: Vec<Vec<f64>> = columns.iter().map(|column| to_floats(column)).collect();
        let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        Ok(function.values(rule, &columns))
    })?;
    Ok(value_or_refusal(values.map(|values| to_bytes(py, &values))))
}

/// The value of an equation over spheres: a list for each argument, and their heights where they are not level. Of one over a list
/// alone there is no load.
#[pyfunction]
pub(crate) fn equation_of_list(
    py: Python<'_>,
    name: &str,
    columns: Vec<PyBackedBytes>,
    heights: Option<PyBackedBytes>,
    load: f64,
) -> PyResult<ValueOrRefusal<f64>> {
    let value = without_gil(py, || {
        let columns: Vec<Vec<f64>> = columns.iter().map(|column| to_floats(column)).collect();
        let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        if name == mean_square_radius::NAME {
            return Ok(mean_square_radius::value(columns.first().copied().unwrap_or_default()));
        }
        let function = SPHERE_LIST_FUNCTIONS.iter().find(|one| one.name == name);
        let function = function.ok_or_else(|| unknown_equation(name))?;
        Ok(function.value(&columns, heights.as_ref().map(|heights| to_floats(heights)).as_deref(), load))
    })?;
    Ok(value_or_refusal(value))
}

/// For each step of a continuation: the dimensionless stiffness, the factor of the modulus and the factor of the dissipation.
type Columns = (Vec<f64>, Vec<f64>, Vec<f64>);

/// Most steps of a continuation from soft to stiff contacts. Each step is an optimisation of a movement, and nobody runs more.
const MOST_STEPS: u32 = 10_000;

/// The steps from soft contacts to stiff ones.
#[pyfunction]
pub(crate) fn steps(
    py: Python<'_>,
    first: f64,
    last: f64,
    dissipation_ratio: f64,
    count: &Bound<'_, PyAny>,
) -> PyResult<ValueOrRefusal<Columns>> {
    let count = match count.extract::<u32>() {
        Ok(count) if count <= MOST_STEPS => count,
        Err(error) if !error.is_instance_of::<PyOverflowError>(py) => return Err(error),
        _ => {
            let message = format!("count is out of range, expected a whole number from 2 to {MOST_STEPS}");
            return Ok((None, Some((Some("count"), None, message))));
        }
    };
    let steps = without_gil(py, || Ok(continuation::steps(first, last, dissipation_ratio, count)))?;
    let columns = |steps: Vec<Step>| {
        let column = |value: fn(&Step) -> f64| steps.iter().map(value).collect();
        (
            column(|step| step.dimensionless_stiffness),
            column(|step| step.modulus_factor),
            column(|step| step.dissipation_factor),
        )
    };
    Ok(value_or_refusal(steps.map(columns).map_err(EquationError::from)))
}

/// The name of OpenSim's rule for the modulus of two surfaces, which is used if the call names no rule.
const OPENSIM_RULE: &str = MIXING_RULES[0].0;

fn unknown_mixing_rule(name: Option<&str>) -> Problem {
    let message =
        format!("rule={:?}: expected one of {}", name.unwrap_or_default(), mixing_rules().join(", "));
    Problem::general("RequestError", "usage", message)
}

fn unknown_equation(name: &str) -> Problem {
    Problem::defect(format!("there is no equation {name}"))
}

fn value_or_refusal<T>(result: Result<T, EquationError>) -> ValueOrRefusal<T> {
    let refusal = |failure: EquationError| {
        let place = if failure.index.is_some() { ELEMENT_PLACEHOLDER } else { "" };
        (None, Some((failure.parameter, failure.index, failure.message(place))))
    };
    result.map_or_else(refusal, |value| (Some(value), None))
}

fn to_floats(bytes: &[u8]) -> Vec<f64> {
    let (numbers, _) = bytes.as_chunks::<8>();
    numbers.iter().map(|number| f64::from_ne_bytes(*number)).collect()
}

fn to_bytes<'py>(py: Python<'py>, values: &[f64]) -> Bound<'py, PyByteArray> {
    PyByteArray::new(py, &values.iter().flat_map(|value| value.to_ne_bytes()).collect::<Vec<u8>>())
}
