//! A register of every equation: number, formula, symbols with units, and where it comes from.
//!
//! The functions of this crate compute; the register says what they compute, for help texts and reports. A test compares it
//! with `docs/equations.md`, formula by formula.
//!
//! ```
//! use contact_scaling::equations;
//!
//! let scaling = equations::find("(10)").unwrap();
//! assert_eq!(scaling.forms[0].formula, "E*_b = (M_b / M_a) (n_a / n_b) (R_a² / R_b²) E*_a");
//! assert_eq!(equations::find("eq. c.5").unwrap().label, "C.5");
//! assert!(equations::find("C.11").is_none());
//! ```

mod beyond;
mod hertz;
mod smooth;
mod stiffness;
mod surfaces;
mod symbols;

pub use symbols::Symbol;

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

const fn form(note: &'static str, formula: &'static str, function: &'static str, unit: &'static str) -> Form {
    Form { note, formula, function, unit }
}

/// Every equation, in the order of the paper, then those beyond it.
pub fn all() -> impl Iterator<Item = &'static Equation> {
    [hertz::ALL, surfaces::ALL, stiffness::ALL, smooth::ALL, beyond::ALL].into_iter().flatten()
}

/// The equation with this number or name: `10`, `(10)`, `C.5`, `eq. (C.5)`, `exact`.
#[must_use]
pub fn find(name: &str) -> Option<&'static Equation> {
    let wanted = plain(name);
    all().find(|equation| {
        std::iter::once(&equation.label).chain(equation.aliases).any(|known| plain(known) == wanted)
    })
}

/// A name without brackets, blanks, full stops and the word "equation"; a hyphen stays, for codes of warnings have one.
fn plain(name: &str) -> String {
    let plain: String = name.to_lowercase().chars().filter(|&c| c.is_alphanumeric() || c == '-').collect();
    let number = plain.strip_prefix("equation").or_else(|| plain.strip_prefix("eq"));
    // "equal" begins like "eq. 10" and is none.
    match number.filter(|rest| rest.chars().any(|c| c.is_ascii_digit())) {
        Some(rest) => rest.to_owned(),
        None => plain,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{all, find, plain};

    #[test]
    fn every_name_means_one_equation() {
        let mut seen = BTreeSet::new();
        for equation in all() {
            for name in std::iter::once(&equation.label).chain(equation.aliases) {
                assert!(seen.insert(plain(name)), "{name} is taken");
                assert_eq!(find(name), Some(equation));
            }
        }
    }

    #[test]
    fn numbers_are_found_however_they_are_written() {
        for name in ["C.10", "(C.10)", "c10", "Eq. (C.10)", "equation C.10"] {
            assert_eq!(find(name).unwrap().label, "C.10", "{name}");
        }
        assert!(find("").is_none() && find("16").is_none() && find("eq").is_none());
    }

    #[test]
    fn every_symbol_of_an_equation_stands_in_its_formulas() {
        for equation in all() {
            assert!(!equation.title.is_empty() && !equation.source.is_empty() && !equation.forms.is_empty());
            let formulas: String = equation.forms.iter().map(|form| form.formula).collect();
            for symbol in equation.symbols {
                assert!(
                    formulas.contains(symbol.symbol),
                    "{}: {} is not in it",
                    equation.label,
                    symbol.symbol
                );
            }
        }
    }
}
