//! Contact parameters from measured indentation and force.
//!
//! The model is (1) with (12) for n equal spheres: F = n 4/3 √R E* (x − x₀)^(3/2) (1 + 3/2 α ẋ), and F = 0 before the onset x₀.
//! Errors are assumed in the force only, independent and of equal size. With a known onset, the model is linear in E* and E* α,
//! and the solution has a closed form; with an unknown onset, it is found by Levenberg–Marquardt.
//!
//! ```
//! use contact_scaling::fit::{FittedBranch, FitValues, Measurement, Onset, Rate, fit};
//! let indentation_m = [0.001, 0.002, 0.003, 0.004, 0.005];
//! let force_n = indentation_m.map(|x: f64| 6.0 * 4.0 / 3.0 * 0.032_f64.sqrt() * 4e5 * x.powf(1.5));
//! let measurement = Measurement { indentation_m: &indentation_m, force_n: &force_n, rate: Rate::Unknown };
//! let values =
//!     FitValues { radius_m: 0.032, sphere_count: 6.0, onset: Onset::At(0.0), branch: FittedBranch::Both };
//! let result = fit(&measurement, &values)?;
//! assert!((result.composite_modulus.value / 4e5 - 1.0).abs() < 1e-12);
//! # Ok::<(), contact_scaling::fit::FitError>(())
//! ```

mod least_squares;
mod measurement;
mod result;

use crate::error::{require_at_least_one, require_finite, require_positive};
use crate::{SURFACE_OVER_COMPOSITE_MODULUS, limits, restitution};
use least_squares::{FitModel, Parameters};
use measurement::Point;
pub use measurement::{FitError, FitValues, FittedBranch, Measurement, Onset, Parameter, Rate};
pub use result::{Doubt, Estimate, Fit};

/// Indentations count as equal if they differ by less than this share of the largest distance from the onset.
const EQUAL_INDENTATION_TOLERANCE: f64 = 1e-9;

/// Fits the contact parameters to a measurement.
///
/// # Errors
/// [`FitError`] if the measurement is not valid, or does not determine the parameters.
pub fn fit(measurement: &Measurement<'_>, values: &FitValues) -> Result<Fit, FitError> {
    let radius = require_positive("sphere radius", values.radius_m)?;
    let count = require_at_least_one("sphere count", values.sphere_count)?;
    let points = measurement::points_of_branch(measurement, values.branch)?;
    let model = FitModel {
        gain: count * 4.0 / 3.0 * radius.sqrt(),
        with_dissipation: !matches!(measurement.rate, Rate::Unknown),
        with_onset: matches!(values.onset, Onset::Fitted),
    };
    let parameters = match values.onset {
        Onset::At(onset) => {
            least_squares::solve_with_known_onset(&model, &points, require_finite("contact onset", onset)?)?
        }
        Onset::Fitted => least_squares::solve_with_onset(&model, &points)?,
    };
    if parameters.modulus <= 0.0 || !parameters.modulus.is_finite() {
        return Err(FitError::NoStiffness { value: parameters.modulus });
    }
    // Every law goes through one point: a measurement at a single indentation says nothing.
    let touching = points.iter().map(|p| p.indentation).filter(|&x| x > parameters.onset);
    let (least, most) = least_squares::value_range(touching);
    if most - least <= EQUAL_INDENTATION_TOLERANCE * (most - parameters.onset) {
        return Err(FitError::OneIndentation { indentation_m: most });
    }
    fit_result(&model, &points, &parameters, radius)
}

fn fit_result(model: &FitModel, points: &[Point], fitted: &Parameters, radius: f64) -> Result<Fit, FitError> {
    let residuals_n: Vec<f64> = points.iter().map(|p| p.force - model.force(fitted, p)).collect();
    let degrees_of_freedom = points.len() - model.names().len();
    let square: f64 = residuals_n.iter().map(|r| r * r).sum();
    let mean = points.iter().map(|p| p.force).sum::<f64>() / points.len() as f64;
    let total: f64 = points.iter().map(|p| (p.force - mean) * (p.force - mean)).sum();
    let r_squared = 1.0 - square / total;
    if !(r_squared.is_finite() && r_squared > 0.0) {
        return Err(FitError::NoLaw { r_squared });
    }
    let variance = square / degrees_of_freedom as f64;
    let covariance = result::covariance(model, points, fitted, variance)?;
    let t = result::student_95(degrees_of_freedom)?;
    let names = model.names();
    let exact = result::is_exact(&residuals_n, points.iter().map(|p| p.force));
    let estimate = |i: usize, value: f64| {
        let standard_error = if exact { f64::NAN } else { covariance[i][i].sqrt() };
        Estimate::new(value, standard_error, t)
    };
    let of = |name: Parameter, value: f64| {
        names.iter().position(|&known| known == name).map(|i| estimate(i, value))
    };
    let composite = estimate(0, fitted.modulus);
    let dissipation = of(Parameter::Dissipation, fitted.dissipation());
    let doubts = result::doubts(
        r_squared,
        exact,
        &[(Parameter::CompositeModulus, Some(&composite)), (Parameter::Dissipation, dissipation.as_ref())],
    );
    let touching = || points.iter().filter(|p| p.indentation > fitted.onset);
    let deepest_m = touching().fold(0.0, |most: f64, p| most.max(p.indentation - fitted.onset));
    let deepest = require_finite("indentation over radius", deepest_m / radius)?;
    let fastest = require_finite("speed", touching().fold(0.0, |most: f64, p| most.max(p.speed.abs())))?;
    let restitution = restitution::approximate(fitted.dissipation().max(0.0), fastest).ok();
    Ok(Fit {
        composite_modulus: composite,
        plane_strain_modulus: composite.times(SURFACE_OVER_COMPOSITE_MODULUS),
        dissipation,
        doubts,
        onset_m: of(Parameter::Onset, fitted.onset),
        parameters: names,
        covariance,
        rows: points.iter().map(|p| p.row).collect(),
        residual_deviation_n: variance.sqrt(),
        r_squared,
        residuals_n,
        degrees_of_freedom,
        largest_relative_indentation: deepest,
        within_hertz_limit: limits::INDENTATION.admits(deepest),
        largest_speed_m_s: model.with_dissipation.then_some(fastest),
        restitution: restitution.filter(|_| model.with_dissipation),
        within_hunt_crossley_limit: model
            .with_dissipation
            .then(|| restitution.is_some_and(|c_r| limits::RESTITUTION.admits(c_r))),
    })
}
