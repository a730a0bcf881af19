//! Functions of one list of numbers.

use contact_scaling::equations::symbols::{R_I, R_SQUARE};
use contact_scaling::mixed_radii;

use super::failure::Failure;
use super::function::forms;
use super::parameter::{Parameter, Returns};
use super::text::{Argument, docstring};

/// An equation that takes one list of numbers, and gives one number for all of them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OfList {
    /// As Python calls it.
    pub name: &'static str,
    /// The function of `contact-scaling`.
    pub computes: &'static str,
    /// The list.
    pub parameter: Parameter,
    /// What it gives.
    pub returns: Returns,
}

/// (3) summed over spheres of one modulus: the R² in the place of all their radii.
pub(crate) const MEAN_SQUARE_RADIUS: OfList = OfList {
    name: "mean_square_radius",
    computes: "mixed_radii::mean_square",
    parameter: Parameter { name: "radius", symbol: R_I, default: None },
    returns: Returns::Value(R_SQUARE),
};

impl OfList {
    /// The value for a list.
    ///
    /// # Errors
    /// The list is empty, or an element is not a finite number above 0.
    pub(crate) fn value(&self, list: &[f64]) -> Result<f64, Failure> {
        let name = self.parameter.name;
        for (index, &element) in list.iter().enumerate() {
            Failure::unless_finite(std::iter::once((name, element))).map_err(|failure| failure.at(index))?;
        }
        mixed_radii::mean_square(list).map_err(|error| {
            let failure = Failure::from(error).with_argument(list.iter().map(|&element| (name, element)));
            match list.iter().position(|element| *element == failure.value) {
                Some(index) if failure.parameter.is_some() => failure.at(index),
                _ => failure,
            }
        })
    }

    /// Its text in Python.
    pub(crate) fn docstring(&self) -> String {
        docstring(forms(self.computes), std::iter::once(Argument::of_list(self.parameter)), self.returns)
    }
}
