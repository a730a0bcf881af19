//! Why a measurement has no fit.

use crate::DomainError;

/// Why a measurement has no fit. Rows count from 0.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// A number is outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The columns do not have the same number of rows.
    #[error("{column} has {rows} rows, expected {expected} as indentation has")]
    Lengths {
        /// The column.
        column: &'static str,
        /// Its rows.
        rows: usize,
        /// The rows of the indentation.
        expected: usize,
    },
    /// A value is not a number, or infinite.
    #[error("{column} in row {row} is {value:?}, expected a finite number")]
    NotFinite {
        /// The column.
        column: &'static str,
        /// The row, from 0.
        row: usize,
        /// The value.
        value: f64,
    },
    /// Time does not rise from this row to the next.
    #[error("time does not rise after row {row}, expected rising times")]
    TimeOrder {
        /// The row, from 0.
        row: usize,
    },
    /// Too few rows are in contact.
    #[error("{found} rows are in contact, expected at least {needed}")]
    TooFewPoints {
        /// Rows in contact.
        found: usize,
        /// Rows the fit needs: one more than it has parameters.
        needed: usize,
    },
    /// The data do not determine all parameters: for α, speeds must vary.
    #[error("the data do not determine {parameter}, expected rows that differ in it")]
    Undetermined {
        /// The parameter.
        parameter: &'static str,
    },
    /// The force does not rise with the indentation.
    #[error(
        "the composite modulus comes out as {value:?} N/m2, expected a force that rises with the indentation"
    )]
    NoStiffness {
        /// The modulus that came out.
        value: f64,
    },
    /// Every row in contact has the same indentation.
    #[error(
        "all rows in contact have one indentation, {indentation_m:?} m, expected several: one point lies on every curve"
    )]
    OneIndentation {
        /// The indentation, in m.
        indentation_m: f64,
    },
    /// A constant force explains the data as well as the law does: R² is 0 or less, or the force never changes.
    #[error(
        "the law explains the force no better than a constant does{}, expected a force that follows the indentation",
        r_squared_in_words(*r_squared)
    )]
    NoLaw {
        /// R²; not finite where the force never changes.
        r_squared: f64,
    },
    /// The search for the onset did not come to an end.
    #[error("the search for the contact onset did not converge, expected data with a clear onset")]
    NotConverged,
}

/// A force that never changes has no R squared.
fn r_squared_in_words(r_squared: f64) -> String {
    if r_squared.is_finite() {
        format!(" (R squared is {r_squared:?})")
    } else {
        " (the force never changes)".to_owned()
    }
}
