//! A register of all equations: number, formula, symbols with units, and source.
//!
//! The functions of this crate compute; the register has their formulas for help texts and reports. A test compares the register
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

/// Equations, each as: label, aliases and title; forms; symbols and source.
macro_rules! equations {
    ($($label:literal $aliases:tt $title:literal: $($form:expr),+; $symbols:tt $source:literal;)+) => {
        &[$(Equation {
            label: $label,
            aliases: &$aliases,
            title: $title,
            forms: &[$($form),+],
            symbols: &$symbols,
            source: $source,
        }),+]
    };
}

mod paper;
pub mod symbols;

use crate::equations::symbols::{
    ALPHA, C_EXACT, D, E_A, E_B, E_I, F_I, F_LOAD, G, H_I, IMPACT, K_HAT_A, K_HAT_B, N, R, R_EQUIVALENT, R_I,
    SPEED, U_V, V_T, X, form,
};
pub use symbols::{Equation, Form, Symbol};

/// All equations: first the equations of the paper in its order, then further equations.
pub fn all() -> impl Iterator<Item = &'static Equation> {
    [
        paper::EQUATIONS_OF_LAWS,
        paper::EQUATIONS_OF_SURFACES,
        paper::EQUATIONS_OF_STIFFNESS,
        paper::EQUATIONS_OF_SMOOTHING,
        EQUATIONS_BEYOND_PAPER,
    ]
    .into_iter()
    .flatten()
}

/// The equation with this number or name, such as `10`, `(10)`, `C.5`, `eq. (C.5)`, `exact`; `None` if there is none.
pub fn find(name: &str) -> Option<&'static Equation> {
    let name = normalised_name(name);
    all().find(|equation| {
        std::iter::once(&equation.label).chain(equation.aliases).any(|label| normalised_name(label) == name)
    })
}

/// The text that refers to the equation with this label: numbers of the paper are in brackets, as in the paper.
///
/// ```
/// use contact_scaling::equations::reference;
/// assert_eq!([reference("C.5"), reference("Fig. 3")], ["(C.5)", "Fig. 3"]);
/// ```
pub fn reference(label: &str) -> String {
    let is_number = label.ends_with(|c: char| c.is_ascii_digit()) && !label.contains(' ');
    if is_number { format!("({label})") } else { label.to_owned() }
}

/// A name without brackets, blanks, full stops and the word "equation". Hyphens stay, because codes of warnings contain hyphens.
fn normalised_name(name: &str) -> String {
    let letters: String = name.to_lowercase().chars().filter(|&c| c.is_alphanumeric() || c == '-').collect();
    let number = letters.strip_prefix("equation").or_else(|| letters.strip_prefix("eq"));
    // "equal" begins like "eq. 10" and is none.
    match number.filter(|rest| rest.chars().any(|c| c.is_ascii_digit())) {
        Some(rest) => rest.to_owned(),
        None => letters,
    }
}

// Equations that the paper does not have.

/// Equations of the register that the paper does not have, such as the exact restitution.
const EQUATIONS_BEYOND_PAPER: &[Equation] = equations! {
    "exact restitution" ["exact", "exact law"] "Coefficient of restitution, exact":
        form("", "d − ln(1 + d) = −c d − ln(1 − c d), d = 3/2 α ẋ⁻", "restitution::exact", "1"),
        form("for α", "the same, solved for d", "restitution::exact_dissipation", "s/m");
        [D, C_EXACT, ALPHA, IMPACT] "beyond the paper: the integral of (12) over an impact without gravity";
    "drop speed" ["impact speed"] "Impact speed of the paper's drop":
        form("", "ẋ⁻ = √(2 g · R/4) = √(g R / 2)", "restitution::drop_speed", "m/s");
        [IMPACT, G, R] "the drops of Table 1: a fall from a quarter of the radius";
    "rest by (1)" ["rest by Hertz"] "Indentation at rest by the Hertz law":
        form("", "Σ 4/3 E*_i √R_i x^(3/2) = F", "equilibrium::hertz_indentation", "m");
        [E_I, R_I, X, F_LOAD] "beyond the paper: (1) summed over spheres whose bottoms are level";
    "rest by (C.9)" ["rest by the model's law"] "Indentation at rest by the file's law":
        form("", "Σ F_i(x, ẋ = 0) = F", "equilibrium::indentation", "m");
        [F_I, X, SPEED, F_LOAD]
        "beyond the paper: (C.9) at ẋ = 0 summed over spheres whose bottoms are level";
    "rest at own heights" ["standing"] "Indentation of the lowest sphere, each at its own height":
        form("by (1)", "Σ 4/3 E*_i √R_i max(0, x − h_i)^(3/2) = F", "equilibrium::hertz_indentation_of_lowest", "m"),
        form("by (C.9)", "Σ F_i(x − h_i, ẋ = 0) = F", "equilibrium::indentation_of_lowest", "m");
        [E_I, R_I, F_I, X, H_I, SPEED, F_LOAD]
        "beyond the paper: (1) and (C.9) summed over spheres whose bottoms are h_i above the lowest, as at the default pose";
    "continuation" ["ladder"] "Modulus for a dimensionless stiffness":
        form("", "E*_a / E*_b = (k̂_a / k̂_b)^(3/2)", "continuation::modulus_ratio", "1");
        [E_A, E_B, K_HAT_A, K_HAT_B] "(11) and (B.3) at one load; the steps of section 4.3";
    "mixed radii" ["mean square"] "One radius for spheres of different size":
        form("", "R² = Σ R_i² / n", "mixed_radii::mean_square", "m²");
        [R_EQUIVALENT, R_I, N] "beyond the paper: (3) summed over spheres of equal x̂ and E*";
    "friction" [] "How friction speeds follow body size":
        form("", "transition_velocity ∝ √(g R)", "Ratios::transition_velocity", "1"),
        form("", "viscous_friction ∝ 1/√(g R)", "Ratios::viscous_friction", "1");
        [V_T, U_V, G, R]
        "beyond the paper: speeds grow as √(g R). Friction coefficients do not depend on size, and stay. The friction of SmoothSphereHalfSpaceForce is similar only in part";
};

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{all, find, normalised_name};

    #[test]
    fn every_name_belongs_to_one_equation() {
        let mut seen = BTreeSet::new();
        for equation in all() {
            for name in std::iter::once(&equation.label).chain(equation.aliases) {
                assert!(seen.insert(normalised_name(name)), "{name} is taken");
                assert_eq!(find(name), Some(equation));
            }
        }
    }

    #[test]
    fn equations_are_found_by_all_forms_of_their_numbers() {
        for name in ["C.10", "(C.10)", "c10", "Eq. (C.10)", "equation C.10"] {
            assert_eq!(find(name).unwrap().label, "C.10", "{name}");
        }
        assert!(find("").is_none() && find("16").is_none() && find("eq").is_none());
    }

    #[test]
    fn every_symbol_of_an_equation_is_in_its_formulas() {
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
