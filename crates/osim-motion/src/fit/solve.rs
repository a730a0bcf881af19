//! A fit from start to end.

use super::data::{FitTrial, FootForces};
use super::held_out::held_out;
use super::problem::{FitWanted, errors};
use super::ranges::{dissipation_range, height_range, stiffness_range};
use super::result::{FittedParameter, MotionFit};
use super::search::{FitBounds, FitError, own, search};

/// Fits the unknowns to all `trials` together.
///
/// # Errors
/// [`FitError`].
pub fn fit_motion(trials: &[FitTrial], bounds: &FitBounds) -> Result<MotionFit, FitError> {
    let FitWanted { stiffness, dissipation, height } = bounds.wanted;
    if !(stiffness || dissipation || height) {
        return Err(FitError::Nothing);
    }
    let own = own(trials);
    let best = search(trials, bounds, &own)?;
    let before = errors(trials, &own);
    let after = errors(trials, &best.unknowns);
    let fitted = |place: usize, value: f64, map: fn(f64) -> f64, range: (f64, f64)| FittedParameter {
        value: map(value),
        standard_error: best.standard_error.get(place).copied().unwrap_or(f64::NAN),
        nearly_as_good: range,
        at_bound: best.at_bound.get(place).copied().unwrap_or(false),
    };
    let mut place = 0;
    let mut next = || {
        place += 1;
        place - 1
    };
    let stiffness_factor = stiffness.then(|| {
        let range = stiffness_range(trials, bounds, &best.unknowns, after.vertical_rms_bw);
        let mut one = fitted(next(), best.unknowns.stiffness_log, f64::exp, range);
        one.standard_error *= one.value;
        one
    });
    let same = |value: f64| value;
    let dissipation = best.unknowns.dissipation.filter(|_| dissipation).map(|value| {
        let range = dissipation_range(trials, bounds, &best.unknowns, value, after.vertical_rms_bw);
        fitted(next(), value, same, range)
    });
    let floor_up_m = match height {
        true => (0..trials.len())
            .map(|trial| {
                let value = best.unknowns.floor_up_m.get(trial).copied().unwrap_or_default();
                fitted(
                    next(),
                    value,
                    same,
                    height_range(trials, bounds, &best.unknowns, trial, after.vertical_rms_bw),
                )
            })
            .collect(),
        false => Vec::new(),
    };
    Ok(MotionFit {
        stiffness_height_correlation: (stiffness && height)
            .then(|| best.correlation(0, usize::from(dissipation.is_some()) + 1)),
        stiffness_factor,
        dissipation,
        floor_up_m,
        before,
        after,
        held_out: held_out(trials, bounds, &own),
        beside: trials.iter().map(|trial| trial.beside).sum(),
        frames: trials.iter().flat_map(|trial| &trial.feet).map(FootForces::frames).sum(),
    })
}
