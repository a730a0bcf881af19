//! Contact parameters from measured indentation and force.
//!
//! The model is (1) with (12) on n equal spheres: F = n 4/3 √R E* (x − x₀)^(3/2) (1 + 3/2 α ẋ), and F = 0 before
//! the onset x₀. Errors are taken to be in the force, independent and of equal size. Where the onset is known
//! the model is linear in E* and E* α and solved in closed form; where it is not, by Levenberg–Marquardt.
//!
//! ```
//! use contact_scaling::fit::{Branch, FitValues, Measurement, Onset, Rate, fit};
//! let indentation_m = [0.001, 0.002, 0.003, 0.004, 0.005];
//! let force_n = indentation_m.map(|x: f64| 6.0 * 4.0 / 3.0 * 0.032_f64.sqrt() * 4e5 * x.powf(1.5));
//! let measurement = Measurement { indentation_m: &indentation_m, force_n: &force_n, rate: Rate::Unknown };
//! let values =
//!     FitValues { radius_m: 0.032, sphere_count: 6.0, onset: Onset::At(0.0), branch: Branch::Both };
//! let result = fit(&measurement, &values)?;
//! assert!((result.composite_modulus.value / 4e5 - 1.0).abs() < 1e-12);
//! # Ok::<(), contact_scaling::fit::FitError>(())
//! ```

mod estimate;
mod linear;
mod model;
mod onset;
mod points;

use crate::error::{at_least_one, finite, positive};
use crate::{DomainError, EQUAL_SURFACES, limits, restitution};

pub use estimate::Estimate;
use model::{Model, Parameters};
use points::Point;

/// What was measured, one value per row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement<'a> {
    /// Indentation x, in m; the zero may be anywhere if the onset is fitted.
    pub indentation_m: &'a [f64],
    /// Force of all spheres together, in N; above 0 where they are pressed.
    pub force_n: &'a [f64],
    /// How fast the indentation changes, if that is known. Without it α is not fitted.
    pub rate: Rate<'a>,
}

/// How fast the indentation changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rate<'a> {
    /// Not known: the force is taken as the elastic one.
    Unknown,
    /// ẋ, in m/s, positive while going in.
    Speed(&'a [f64]),
    /// Time, in s, rising from row to row; ẋ is taken from it by differences over three rows.
    Time(&'a [f64]),
}

/// Where contact begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Onset {
    /// At this indentation, in m: usually 0.
    At(f64),
    /// Not known, to be fitted.
    Fitted,
}

/// The part of the measurement to fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// All of it.
    Both,
    /// Going in: ẋ ≥ 0, or the rows up to the deepest where no rate is known.
    Loading,
    /// Coming out: ẋ < 0, or the rows after the deepest where no rate is known.
    Unloading,
}

/// What the fit has to know, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitValues {
    /// Sphere radius R, in m.
    pub radius_m: f64,
    /// Spheres n that share the force.
    pub sphere_count: f64,
    /// Where contact begins.
    pub onset: Onset,
    /// The part of the measurement to fit.
    pub branch: Branch,
}

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
    /// The data do not tell the parameters apart: for α, speeds must vary.
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
    /// The search for the onset did not come to an end.
    #[error("the search for the contact onset did not converge, expected data with a clear onset")]
    NotConverged,
}

/// A fitted parameter, in the order of the covariance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// E*, in N/m².
    CompositeModulus,
    /// α, in s/m.
    Dissipation,
    /// x₀, in m.
    Onset,
}

/// What the data say.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// E*, in N/m².
    pub composite_modulus: Estimate,
    /// E₁* = 2^(3/2) E*, in N/m²: the `stiffness` to write.
    pub plane_strain_modulus: Estimate,
    /// α, in s/m; `None` where no rate is known. May come out below 0, which no file takes.
    pub dissipation: Option<Estimate>,
    /// x₀, in m; `None` where it was given.
    pub onset_m: Option<Estimate>,
    /// The parameters that rows and columns of the covariance stand for.
    pub parameters: Vec<Parameter>,
    /// Covariance of the parameters, in their units.
    pub covariance: Vec<Vec<f64>>,
    /// Rows that were fitted, from 0.
    pub rows: Vec<usize>,
    /// Measured less fitted force of these rows, in N.
    pub residuals_n: Vec<f64>,
    /// Rows less parameters.
    pub degrees_of_freedom: usize,
    /// Standard deviation of the residuals, in N.
    pub residual_deviation_n: f64,
    /// R²: the share of the force's variance that the model tells.
    pub r_squared: f64,
    /// The largest x̂ of these rows, from the onset.
    pub largest_relative_indentation: f64,
    /// Whether that is within the Hertz law.
    pub hertz_holds: bool,
    /// The largest |ẋ| in contact, in m/s; `None` where no rate is known.
    pub largest_speed_m_s: Option<f64>,
    /// Restitution by (13) at that speed; `None` also where (13) has none.
    pub restitution: Option<f64>,
    /// Whether that is within the Hunt–Crossley law; `None` where no rate is known.
    pub hunt_crossley_holds: Option<bool>,
}

/// Fits the contact parameters to a measurement.
///
/// # Errors
/// [`FitError`] where the measurement is not well-formed or does not determine the parameters.
pub fn fit(measurement: &Measurement<'_>, values: &FitValues) -> Result<Fit, FitError> {
    let radius = positive("sphere radius", values.radius_m)?;
    let count = at_least_one("sphere count", values.sphere_count)?;
    let points = points::collect(measurement, values.branch)?;
    let model = Model {
        gain: count * 4.0 / 3.0 * radius.sqrt(),
        with_dissipation: !matches!(measurement.rate, Rate::Unknown),
        with_onset: matches!(values.onset, Onset::Fitted),
    };
    let parameters = match values.onset {
        Onset::At(onset) => linear::solve(&model, &points, finite("contact onset", onset)?)?,
        Onset::Fitted => onset::solve(&model, &points)?,
    };
    if parameters.modulus <= 0.0 || !parameters.modulus.is_finite() {
        return Err(FitError::NoStiffness { value: parameters.modulus });
    }
    report(&model, &points, &parameters, radius)
}

fn report(model: &Model, points: &[Point], fitted: &Parameters, radius: f64) -> Result<Fit, FitError> {
    let residuals_n: Vec<f64> = points.iter().map(|p| p.force - model.force(fitted, p)).collect();
    let degrees_of_freedom = points.len() - model.names().len();
    let square: f64 = residuals_n.iter().map(|r| r * r).sum();
    let variance = square / degrees_of_freedom as f64;
    let covariance = estimate::covariance(model, points, fitted, variance)?;
    let t = estimate::student_95(degrees_of_freedom)?;
    let names = model.names();
    let of = |name: Parameter, value: f64| {
        let i = names.iter().position(|&known| known == name)?;
        Some(Estimate::new(value, covariance[i][i].sqrt(), t))
    };
    let composite = Estimate::new(fitted.modulus, covariance[0][0].sqrt(), t);
    let touching = || points.iter().filter(|p| p.indentation > fitted.onset);
    let deepest = touching().fold(0.0, |most: f64, p| most.max(p.indentation - fitted.onset)) / radius;
    let fastest = touching().fold(0.0, |most: f64, p| most.max(p.speed.abs()));
    let restitution = restitution::approximate(fitted.dissipation().max(0.0), fastest).ok();
    Ok(Fit {
        composite_modulus: composite,
        plane_strain_modulus: composite.times(EQUAL_SURFACES),
        dissipation: of(Parameter::Dissipation, fitted.dissipation()),
        onset_m: of(Parameter::Onset, fitted.onset),
        parameters: names,
        covariance,
        rows: points.iter().map(|p| p.row).collect(),
        residual_deviation_n: variance.sqrt(),
        r_squared: r_squared(points, square),
        residuals_n,
        degrees_of_freedom,
        largest_relative_indentation: deepest,
        hertz_holds: limits::hertz_holds(deepest),
        largest_speed_m_s: model.with_dissipation.then_some(fastest),
        restitution: restitution.filter(|_| model.with_dissipation),
        hunt_crossley_holds: model
            .with_dissipation
            .then(|| restitution.is_some_and(limits::hunt_crossley_holds)),
    })
}

/// R² = 1 − Σ residual² / Σ (force − mean)².
fn r_squared(points: &[Point], square: f64) -> f64 {
    let mean = points.iter().map(|p| p.force).sum::<f64>() / points.len() as f64;
    let total: f64 = points.iter().map(|p| (p.force - mean) * (p.force - mean)).sum();
    1.0 - square / total
}
