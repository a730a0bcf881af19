//! The Python function of a list of radii: the mean R² of spheres with one modulus, which replaces their radii in equation (3).

use contact_scaling::equations::symbols::R_SQUARE;
use contact_scaling::mixed_radii;

use crate::scaling::function::{Argument, EquationError, Parameter, Returns, docstring, forms, parameter};
use crate::scaling::spheres::LIST_TYPE;

pub(crate) const NAME: &str = "mean_square_radius";
/// Name of the function in `contact-scaling` that computes the equation.
pub(crate) const COMPUTES: &str = "mixed_radii::mean_square";
/// The argument that takes a list of values.
pub(crate) const RADIUS: Parameter = parameter!(radius: R_I);

/// The value of the equation for a list of numbers.
///
/// # Errors
/// The list is empty, or an element is not a finite number above 0.
pub(crate) fn value(list: &[f64]) -> Result<f64, EquationError> {
    for (index, &element) in list.iter().enumerate() {
        EquationError::unless_finite(std::iter::once((RADIUS.name, element)))
            .map_err(|failure| failure.at(index))?;
    }
    mixed_radii::mean_square(list).map_err(|error| {
        let named = list.iter().map(|&element| (RADIUS.name, element));
        let failure = EquationError::from(error).with_argument(named);
        match list.iter().position(|element| *element == failure.value) {
            Some(index) if failure.parameter.is_some() => failure.at(index),
            _ => failure,
        }
    })
}

pub(crate) fn docstring_of_function() -> String {
    let argument = Argument::new(RADIUS, LIST_TYPE);
    docstring(forms(COMPUTES), std::iter::once(argument), Returns::Value(R_SQUARE))
}
