//! A register of every equation: number, formula, symbols with units, and where it comes from.
//!
//! The functions of this crate compute; the register says what they compute, for help texts and reports. A test compares it
//! with `docs/reference/equations.md`, formula by formula.
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
mod equation;
mod paper;
pub mod symbols;

pub use equation::{Equation, Form};
pub use symbols::Symbol;

/// Every equation, in the order of the paper, then those beyond it.
pub fn all() -> impl Iterator<Item = &'static Equation> {
    [paper::LAWS, paper::SURFACES, paper::STIFFNESS, paper::SMOOTH, beyond::ALL].into_iter().flatten()
}

/// The equation with this number or name: `10`, `(10)`, `C.5`, `eq. (C.5)`, `exact`.
#[must_use]
pub fn find(name: &str) -> Option<&'static Equation> {
    let wanted = plain(name);
    all().find(|equation| {
        std::iter::once(&equation.label).chain(equation.aliases).any(|known| plain(known) == wanted)
    })
}

/// How a text refers to the equation of this label: numbers of the paper are in brackets, as there.
///
/// ```
/// use contact_scaling::equations::reference;
/// assert_eq!([reference("C.5"), reference("Fig. 3")], ["(C.5)", "Fig. 3"]);
/// ```
#[must_use]
pub fn reference(label: &str) -> String {
    let is_number = label.ends_with(|c: char| c.is_ascii_digit()) && !label.contains(' ');
    if is_number { format!("({label})") } else { label.to_owned() }
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
