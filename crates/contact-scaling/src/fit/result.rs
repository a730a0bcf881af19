//! What the data say.

use super::doubt::Doubt;
use super::estimate::Estimate;
use super::parameter::Parameter;

/// What the data say.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Fit {
    /// E*, in N/m².
    pub composite_modulus: Estimate,
    /// E₁* = 2^(3/2) E*, in N/m²: the `stiffness` to write.
    pub plane_strain_modulus: Estimate,
    /// α, in s/m; `None` where no rate is known. May come out below 0, which no file takes.
    pub dissipation: Option<Estimate>,
    /// x₀, in m; `None` where it was given.
    pub onset_m: Option<Estimate>,
    /// The parameters that rows and columns of the covariance belong to.
    pub parameters: Vec<Parameter>,
    /// Covariance of the parameters, in their units.
    pub covariance: Vec<Vec<f64>>,
    /// Why the result must not be taken as it is; empty where nothing speaks against it.
    pub doubts: Vec<Doubt>,
    /// Rows that were fitted, from 0.
    pub rows: Vec<usize>,
    /// Measured less fitted force of these rows, in N.
    pub residuals_n: Vec<f64>,
    /// Rows less parameters.
    pub degrees_of_freedom: usize,
    /// Standard deviation of the residuals, in N.
    pub residual_deviation_n: f64,
    /// R²: the share of the force's variance that the model explains.
    pub r_squared: f64,
    /// The largest x̂ of these rows, from the onset.
    pub largest_relative_indentation: f64,
    /// Whether that is within the Hertz law.
    pub within_hertz_limit: bool,
    /// The largest |ẋ| in contact, in m/s; `None` where no rate is known.
    pub largest_speed_m_s: Option<f64>,
    /// Restitution by (13) at that speed; `None` also where (13) has none.
    pub restitution: Option<f64>,
    /// Whether that is within the Hunt–Crossley law; `None` where no rate is known.
    pub within_hunt_crossley_limit: Option<bool>,
}
