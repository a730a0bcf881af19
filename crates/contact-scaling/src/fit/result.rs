//! Results of a fit: parameters, their uncertainty, and the reasons to doubt them.

use statrs::distribution::{ContinuousCDF, StudentsT};

use super::least_squares::{FitModel, Parameters};
use super::measurement::{FitError, Parameter, Point, Result};

/// Result of a fit: parameters, their uncertainty, and the reasons to doubt them.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Fit {
    /// Fitted composite modulus E*, in N/m².
    pub composite_modulus: Estimate,
    /// Plane strain modulus E₁* = 2^(3/2) E*, in N/m²: the value for OpenSim's `stiffness`.
    pub plane_strain_modulus: Estimate,
    /// Dissipation α, in s/m; `None` if the rate is not known. It can be below 0, which no model file allows.
    pub dissipation: Option<Estimate>,
    /// Onset of contact x₀, in m; `None` if it was given.
    pub onset_m: Option<Estimate>,
    /// The parameters in the order of the rows and columns of the covariance.
    pub parameters: Vec<Parameter>,
    /// Covariance of the parameters, in their units.
    pub covariance: Vec<Vec<f64>>,
    /// Reasons not to use the result as it is; empty if there are none.
    pub doubts: Vec<Doubt>,
    /// Indices of the fitted rows, from 0.
    pub rows: Vec<usize>,
    /// Measured minus fitted force of the fitted rows, in N.
    pub residuals_n: Vec<f64>,
    /// Number of fitted rows minus number of fitted parameters.
    pub degrees_of_freedom: usize,
    /// Standard deviation of the residuals, in N.
    pub residual_deviation_n: f64,
    /// R², without unit: the share of the force's variance that the model explains.
    pub r_squared: f64,
    /// The largest x̂ of the fitted rows, from the onset, without unit.
    pub largest_relative_indentation: f64,
    /// Whether the largest indentation is within the limit of the Hertz law.
    pub within_hertz_limit: bool,
    /// The largest |ẋ| in contact, in m/s; `None` if the rate is not known.
    pub largest_speed_m_s: Option<f64>,
    /// Restitution by (13) at the largest |ẋ|, without unit; `None` if the rate is not known, or if (13) has no result.
    pub restitution: Option<f64>,
    /// Whether the largest |ẋ| is within the limit of the Hunt–Crossley law; `None` if the rate is not known.
    pub within_hunt_crossley_limit: Option<bool>,
}

/// R² below which the law explains less than half of the force's variance.
const LOW_R_SQUARED: f64 = 0.5;

/// Residuals smaller than this share of the largest force are rounding errors: the data were calculated, not measured.
const ROUNDING_OF_RESIDUALS: f64 = 1e-12;

/// A reason not to use a result as it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The law explains less than half of the force's variance.
    LowRSquared {
        /// Coefficient of determination R².
        r_squared: f64,
    },
    /// The 95 % interval of the parameter contains 0: the data cannot distinguish the parameter from 0.
    Undetermined {
        /// The parameter whose fitted value is doubtful.
        parameter: Parameter,
    },
    /// The fit has no residuals, as with calculated data: the uncertainty of the parameters is not known, and their intervals
    /// are NaN.
    NoResiduals,
}

impl Doubt {
    /// Stable short name of the doubt.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::LowRSquared { .. } => "low-r-squared",
            Self::Undetermined { .. } => "parameter-undetermined",
            Self::NoResiduals => "no-residuals",
        }
    }
}

/// Whether all residuals are only rounding errors.
pub(super) fn is_exact(residuals_n: &[f64], forces_n: impl Iterator<Item = f64>) -> bool {
    let most = forces_n.fold(0.0, |most: f64, force| most.max(force.abs()));
    residuals_n.iter().all(|residual| residual.abs() <= ROUNDING_OF_RESIDUALS * most)
}

/// The reasons to doubt fitted parameters; `exact` if the fit has no residuals.
pub(super) fn doubts(r_squared: f64, exact: bool, fitted: &[(Parameter, Option<&Estimate>)]) -> Vec<Doubt> {
    let low = (r_squared < LOW_R_SQUARED).then_some(Doubt::LowRSquared { r_squared });
    let holds_zero = |estimate: &Estimate| estimate.low <= 0.0 && estimate.high >= 0.0;
    let undetermined = fitted
        .iter()
        .filter(|(_, estimate)| estimate.is_some_and(holds_zero))
        .map(|&(parameter, _)| Doubt::Undetermined { parameter });
    low.into_iter().chain(undetermined).chain(exact.then_some(Doubt::NoResiduals)).collect()
}

/// A fitted value with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Estimate {
    /// The least-squares value of the parameter.
    pub value: f64,
    /// Standard error of the value; NaN, as the interval, if the fit has no residuals.
    pub standard_error: f64,
    /// Lower end of the 95 % interval, by Student's t.
    pub low: f64,
    /// Upper end of the 95 % interval, by Student's t.
    pub high: f64,
}

impl Estimate {
    /// A fitted value with its 95 % interval; `t` is the value of Student's distribution.
    pub(super) fn new(value: f64, standard_error: f64, t: f64) -> Self {
        let half = t * standard_error;
        Self { value, standard_error, low: value - half, high: value + half }
    }

    pub(super) fn times(&self, factor: f64) -> Self {
        Self {
            value: self.value * factor,
            standard_error: self.standard_error * factor,
            low: self.low * factor,
            high: self.high * factor,
        }
    }
}

/// The value t with 95 % of Student's distribution between −t and t.
pub(super) fn student_95(degrees_of_freedom: usize) -> Result<f64> {
    let student = StudentsT::new(0.0, 1.0, degrees_of_freedom as f64)
        .map_err(|_| FitError::TooFewPoints { found: degrees_of_freedom, needed: 1 })?;
    Ok(student.inverse_cdf(0.975))
}

/// Covariance s² (JᵀJ)⁻¹; J has the derivatives of the force by the parameters.
pub(super) fn covariance(
    model: &FitModel,
    points: &[Point],
    fitted: &Parameters,
    variance: f64,
) -> Result<Vec<Vec<f64>>> {
    let names = model.names();
    let rows: Vec<Vec<f64>> = points.iter().map(|p| model.force_gradient(fitted, p)).collect();
    let size = names.len();
    let mut information = vec![vec![0.0; size]; size];
    for row in &rows {
        for i in 0..size {
            for j in 0..size {
                information[i][j] += row[i] * row[j];
            }
        }
    }
    // Scaled to a correlation matrix, so that units do not decide what is small.
    let scale: Vec<f64> = (0..size).map(|i| information[i][i].sqrt()).collect();
    for i in 0..size {
        for j in 0..size {
            information[i][j] /= scale[i] * scale[j];
        }
    }
    let inverse =
        inverse_matrix(information).map_err(|i| FitError::Undetermined { parameter: names[i].in_words() })?;
    let entry = |i: usize, j: usize| variance * inverse[i][j] / (scale[i] * scale[j]);
    Ok((0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect())
}

/// Inverse of a small positive definite matrix, by Gauss–Jordan; the error is the index of a row that depends on other rows.
fn inverse_matrix(mut matrix: Vec<Vec<f64>>) -> Result<Vec<Vec<f64>>, usize> {
    let size = matrix.len();
    for (i, row) in matrix.iter_mut().enumerate() {
        row.extend((0..size).map(|j| if i == j { 1.0 } else { 0.0 }));
    }
    for i in 0..size {
        let pivot = matrix[i][i];
        if pivot.is_nan() || pivot <= 1e-12 {
            return Err(i);
        }
        matrix[i].iter_mut().for_each(|value| *value /= pivot);
        let row = matrix[i].clone();
        for (_, other) in matrix.iter_mut().enumerate().filter(|(j, _)| *j != i) {
            let factor = other[i];
            other.iter_mut().zip(&row).for_each(|(value, by)| *value -= factor * by);
        }
    }
    Ok(matrix.into_iter().map(|row| row[size..].to_vec()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_the_t_distribution_are_those_of_tables() {
        // mpmath 1.3.0, 30 digits: roots of the regularised incomplete beta function.
        let exact = [
            (1, 12.706_204_736_174_705),
            (2, 4.302_652_729_749_464),
            (5, 2.570_581_835_636_315_5),
            (30, 2.042_272_456_301_238),
            (197, 1.972_079_033_778_502_7),
        ];
        for (degrees, t) in exact {
            assert!((student_95(degrees).unwrap() / t - 1.0).abs() < 1e-9, "{degrees}");
        }
        assert!(student_95(0).is_err());
    }

    #[test]
    fn a_regular_matrix_has_an_inverse_and_a_singular_one_has_none() {
        let inverse_of = inverse_matrix(vec![vec![1.0, 0.5], vec![0.5, 1.0]]).unwrap();
        assert!((inverse_of[0][0] - 4.0 / 3.0).abs() < 1e-15);
        assert!((inverse_of[0][1] + 2.0 / 3.0).abs() < 1e-15);
        assert_eq!(inverse_matrix(vec![vec![1.0, 1.0], vec![1.0, 1.0]]), Err(1));
    }
}
