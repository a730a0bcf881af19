//! One equation, as the register has it.

use super::symbols::Symbol;

/// One equation, perhaps in several forms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Equation {
    /// The paper's number without brackets (`10`, `C.5`), or a name where the paper has no number.
    pub label: &'static str,
    /// Other names under which it is found.
    pub aliases: &'static [&'static str],
    /// What it says, in a few words.
    pub title: &'static str,
    /// The equation as printed first, then solved for something else or between two bodies.
    pub forms: &'static [Form],
    /// Every symbol of the formulas.
    pub symbols: &'static [Symbol],
    /// Where it stands: the paper's section, or another source.
    pub source: &'static str,
}

/// One way to write an equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Form {
    /// What sets it apart, such as `for x`; empty for the first form.
    pub note: &'static str,
    /// The formula in Unicode.
    pub formula: &'static str,
    /// The function of this crate that computes it, as `Type::name` or `module::name`; empty for a step of a derivation.
    pub function: &'static str,
    /// Unit of the result; `1` for a pure number, empty where nothing is computed.
    pub unit: &'static str,
}

pub(super) const fn form(
    note: &'static str,
    formula: &'static str,
    function: &'static str,
    unit: &'static str,
) -> Form {
    Form { note, formula, function, unit }
}
