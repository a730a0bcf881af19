//! Measurements, the options of a fit, and the points that a fit uses.

use crate::DomainError;

/// Measured indentations, speeds and forces, one value per row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement<'a> {
    /// Indentation x, in m; its zero is arbitrary if the onset is fitted.
    pub indentation_m: &'a [f64],
    /// Force of all spheres together, in N; positive when they are compressed.
    pub force_n: &'a [f64],
    /// The rate of the indentation, if known. Without a rate, α is not fitted.
    pub rate: Rate<'a>,
}

/// The rate of the indentation, or the times from which it follows.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Rate<'a> {
    /// The rate is not known: the whole force counts as elastic.
    Unknown,
    /// ẋ, in m/s; positive while the indentation grows.
    Speed(&'a [f64]),
    /// Time, in s, which must rise from row to row; ẋ is computed from it by differences over three rows.
    Time(&'a [f64]),
}

/// The indentation at which contact begins: given, or fitted. The enum is exhaustive, so that a match covers all cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Onset {
    /// Contact begins at this indentation, in m: usually 0.
    At(f64),
    /// The onset is not known and is fitted.
    Fitted,
}

/// The part of the measurement to fit: loading, unloading, or both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FittedBranch {
    /// Both branches of the measurement, loading and unloading.
    Both,
    /// Loading: rows with ẋ ≥ 0; without a rate, rows up to the largest indentation.
    Loading,
    /// Unloading: rows with ẋ < 0; without a rate, rows after the largest indentation.
    Unloading,
}

/// The numbers and options of a fit, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitValues {
    /// Sphere radius R, in m.
    pub radius_m: f64,
    /// Number n of spheres that share the force.
    pub sphere_count: f64,
    /// The onset of contact: given, or fitted.
    pub onset: Onset,
    /// The part of the measurement to fit.
    pub branch: FittedBranch,
}

/// A fitted parameter; the covariance has the parameters in this order.
///
/// The enum is exhaustive, because code that writes the covariance needs a name for each row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// Composite modulus E*, in N/m².
    CompositeModulus,
    /// Dissipation α, in s/m.
    Dissipation,
    /// Onset of contact x₀, in m.
    Onset,
}

impl Parameter {
    /// Name of the parameter in a sentence.
    pub const fn in_words(self) -> &'static str {
        match self {
            Self::CompositeModulus => "composite modulus",
            Self::Dissipation => "dissipation",
            Self::Onset => "contact onset",
        }
    }
}

/// The result of a step of a fit.
pub(super) type Result<T, E = FitError> = std::result::Result<T, E>;

/// The reason why a measurement has no fit. Rows are numbered from 0.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// A number is outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The columns do not have the same number of rows.
    #[error("{column} has {rows} rows, expected {expected} as indentation has")]
    Lengths {
        /// Name of the column.
        column: &'static str,
        /// Number of rows of the column.
        rows: usize,
        /// Number of rows of the column with the indentation.
        expected: usize,
    },
    /// A value is not a finite number.
    #[error("{column} in row {row} is {value:?}, expected a finite number")]
    NotFinite {
        /// Name of the column.
        column: &'static str,
        /// The row, from 0.
        row: usize,
        /// The value that is infinite or not a number.
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
        /// The number of rows in contact.
        found: usize,
        /// Smallest number of rows for the fit: the number of parameters plus one.
        needed: usize,
    },
    /// The data do not determine all parameters. For α, the speed must differ between rows.
    #[error("the data do not determine {parameter}, expected rows that differ in it")]
    Undetermined {
        /// Name of the parameter that the measurement does not determine.
        parameter: &'static str,
    },
    /// The force does not rise with the indentation.
    #[error(
        "the composite modulus comes out as {value:?} N/m2, expected a force that rises with the indentation"
    )]
    NoStiffness {
        /// The computed composite modulus, in N/m².
        value: f64,
    },
    /// Every row in contact has the same indentation.
    #[error(
        "all rows in contact have one indentation, {indentation_m:?} m, expected several: one point lies on every curve"
    )]
    OneIndentation {
        /// The one indentation of all rows, in m.
        indentation_m: f64,
    },
    /// The law explains the data no better than a constant force: R² is 0 or less, or the measured force is constant.
    #[error(
        "the law explains the force no better than a constant does{}, expected a force that follows the indentation",
        r_squared_in_words(*r_squared)
    )]
    NoLaw {
        /// R², without unit; not finite if the measured force is constant.
        r_squared: f64,
    },
    /// The search for the onset did not converge.
    #[error("the search for the contact onset did not converge, expected data with a clear onset")]
    NotConverged,
}

/// R² in words for the message; a constant force has no R².
fn r_squared_in_words(r_squared: f64) -> String {
    if r_squared.is_finite() {
        format!(" (R squared is {r_squared:?})")
    } else {
        " (the force never changes)".to_owned()
    }
}

// The rows of a measurement, checked, with a speed each.

/// A row of the measurement: indentation, its rate and force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    pub(super) row: usize,
    pub(super) indentation: f64,
    pub(super) force: f64,
    /// Rate of the indentation, in m/s; 0 if the rate is not known.
    pub(super) speed: f64,
}

/// The rows of the branch to fit, as points.
pub(super) fn points_of_branch(measurement: &Measurement<'_>, branch: FittedBranch) -> Result<Vec<Point>> {
    let Measurement { indentation_m, force_n, rate } = measurement;
    refuse_bad_column("indentation", indentation_m, indentation_m.len())?;
    refuse_bad_column("force", force_n, indentation_m.len())?;
    let speeds = match rate {
        Rate::Unknown => None,
        Rate::Speed(speeds) => {
            refuse_bad_column("speed", speeds, indentation_m.len())?;
            Some(speeds.to_vec())
        }
        Rate::Time(times) => {
            refuse_bad_column("time", times, indentation_m.len())?;
            Some(speeds_from_times(indentation_m, times)?)
        }
    };
    let deepest = deepest_row(indentation_m);
    let is_in_branch = |row: usize| match (branch, &speeds) {
        (FittedBranch::Both, _) => true,
        (FittedBranch::Loading, Some(speeds)) => speeds[row] >= 0.0,
        (FittedBranch::Unloading, Some(speeds)) => speeds[row] < 0.0,
        (FittedBranch::Loading, None) => row <= deepest,
        (FittedBranch::Unloading, None) => row > deepest,
    };
    let point = |row: usize| Point {
        row,
        indentation: indentation_m[row],
        force: force_n[row],
        speed: speeds.as_ref().map_or(0.0, |speeds| speeds[row]),
    };
    Ok((0..indentation_m.len()).filter(|&row| is_in_branch(row)).map(point).collect())
}

fn refuse_bad_column(column: &'static str, values: &[f64], expected: usize) -> Result<()> {
    if values.len() != expected {
        return Err(FitError::Lengths { column, rows: values.len(), expected });
    }
    match values.iter().position(|value| !value.is_finite()) {
        Some(row) => Err(FitError::NotFinite { column, row, value: values[row] }),
        None => Ok(()),
    }
}

fn deepest_row(indentation: &[f64]) -> usize {
    let deeper = |best: usize, row: usize| if indentation[row] > indentation[best] { row } else { best };
    (0..indentation.len()).fold(0, deeper)
}

/// ẋ at each row, in m/s: the slope of the parabola through the row and its two neighbours.
fn speeds_from_times(indentation: &[f64], times: &[f64]) -> Result<Vec<f64>> {
    if let Some(row) = times.windows(2).position(|pair| pair[1] <= pair[0]) {
        return Err(FitError::TimeOrder { row });
    }
    let last = indentation.len().checked_sub(1).filter(|&last| last >= 2);
    let last = last.ok_or(FitError::TooFewPoints { found: indentation.len(), needed: 3 })?;
    let slope = |row: usize| {
        let middle = row.clamp(1, last - 1);
        let (a, b) = (times[middle] - times[middle - 1], times[middle + 1] - times[middle]);
        let first = (indentation[middle] - indentation[middle - 1]) / a;
        let second = (indentation[middle + 1] - indentation[middle]) / b;
        let bend = (second - first) / (a + b);
        first + bend * (2.0 * times[row] - times[middle - 1] - times[middle])
    };
    Ok((0..=last).map(slope).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_of_a_parabola_are_exact() {
        let times = [0.0, 0.1, 0.25, 0.3, 0.7];
        let x: Vec<f64> = times.iter().map(|t| 0.3 + 2.0 * t - 1.5 * t * t).collect();
        for (speed, t) in speeds_from_times(&x, &times).unwrap().iter().zip(times) {
            assert!((speed - (2.0 - 3.0 * t)).abs() < 1e-13);
        }
    }

    #[test]
    fn bad_columns_are_named_with_their_row() {
        let x = [0.0, 1.0, 2.0];
        let measure = |force_n, rate| {
            points_of_branch(&Measurement { indentation_m: &x, force_n, rate }, FittedBranch::Both)
                .unwrap_err()
                .to_string()
        };
        assert_eq!(measure(&[1.0], Rate::Unknown), "force has 1 rows, expected 3 as indentation has");
        let nan = [1.0, f64::NAN, 1.0];
        assert_eq!(measure(&nan, Rate::Unknown), "force in row 1 is NaN, expected a finite number");
        let times = [0.0, 1.0, 1.0];
        assert_eq!(measure(&x, Rate::Time(&times)), "time does not rise after row 1, expected rising times");
    }

    #[test]
    fn branches_are_distinguished_by_speed_or_by_depth() {
        let x = [0.0, 1.0, 2.0, 1.0, 0.5];
        let rows = |rate, branch| {
            let points =
                points_of_branch(&Measurement { indentation_m: &x, force_n: &x, rate }, branch).unwrap();
            points.iter().map(|p| p.row).collect::<Vec<_>>()
        };
        assert_eq!(rows(Rate::Unknown, FittedBranch::Loading), [0, 1, 2]);
        assert_eq!(rows(Rate::Unknown, FittedBranch::Unloading), [3, 4]);
        let speeds = [1.0, 0.0, -0.1, -1.0, -1.0];
        assert_eq!(rows(Rate::Speed(&speeds), FittedBranch::Loading), [0, 1]);
        assert_eq!(rows(Rate::Speed(&speeds), FittedBranch::Unloading), [2, 3, 4]);
    }
}
