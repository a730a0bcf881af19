//! The fit itself.

use super::error::FitError;
use super::estimate::Estimate;
use super::measurement::{FitValues, Measurement, Onset, Rate};
use super::model::{Model, Parameters};
use super::parameter::Parameter;
use super::points::Point;
use super::result::Fit;
use super::{estimate, linear, onset, points};
use crate::error::{at_least_one, finite, positive};
use crate::{EQUAL_SURFACES, limits, restitution};

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
        within_hertz_limit: limits::INDENTATION.admits(deepest),
        largest_speed_m_s: model.with_dissipation.then_some(fastest),
        restitution: restitution.filter(|_| model.with_dissipation),
        within_hunt_crossley_limit: model
            .with_dissipation
            .then(|| restitution.is_some_and(|c_r| limits::RESTITUTION.admits(c_r))),
    })
}

/// R² = 1 − Σ residual² / Σ (force − mean)².
fn r_squared(points: &[Point], square: f64) -> f64 {
    let mean = points.iter().map(|p| p.force).sum::<f64>() / points.len() as f64;
    let total: f64 = points.iter().map(|p| (p.force - mean) * (p.force - mean)).sum();
    1.0 - square / total
}
