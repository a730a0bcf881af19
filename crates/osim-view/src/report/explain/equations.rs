//! Equations of the paper and beyond, and the rules of this project.

use contact_scaling::Equation;

use super::rules;

/// Equations of the paper and beyond, then the project's own rules.
///
/// Texts may name inputs and calls in backticks, as
/// [`Phrase::template`](osim_model::messages::Phrase::template) reads them.
pub fn equations() -> impl Iterator<Item = &'static Equation> {
    contact_scaling::equations::all().chain(rules::ALL)
}

/// The equation or rule of this name: `10`, `C.5`, `given`.
#[must_use]
pub fn equation(name: &str) -> Option<&'static Equation> {
    let rule = || rules::ALL.iter().find(|rule| rule.label.eq_ignore_ascii_case(name));
    contact_scaling::equations::find(name).or_else(rule)
}
