//! A fit from start to end.

use super::data::{FitTrial, FootForces};
use super::held_out::held_out;
use super::problem::{FitWanted, FittedHeight, errors};
use super::ranges::Ranges;
use super::result::{FittedParameter, MotionFit};
use super::search::{FitBounds, FitError, limits, own, search};

/// Fits the unknowns to all `trials` together.
///
/// # Errors
/// [`FitError`].
pub fn fit_motion(trials: &[FitTrial], bounds: &FitBounds) -> Result<MotionFit, FitError> {
    let FitWanted { stiffness, dissipation, height } = bounds.wanted;
    if !(stiffness || dissipation || height.is_some()) {
        return Err(FitError::Nothing);
    }
    if trials.iter().all(|trial| trial.feet.iter().all(|foot| !foot.has_force(trial.weight_n))) {
        return Err(FitError::NoForce);
    }
    let own = own(trials);
    let best = search(trials, bounds, &own)?;
    let fitted = |place: usize, value: f64, map: fn(f64) -> f64, range: (f64, f64)| FittedParameter {
        value: map(value),
        standard_error: best.standard_error.get(place).copied().unwrap_or(f64::NAN),
        nearly_as_good: range,
        at_bound: best.at_bound.get(place).copied().unwrap_or(false),
    };
    let ranges = Ranges::new(trials, bounds.wanted, limits(trials, bounds)?, &best.unknowns);
    let mut place = 0;
    let mut next = || {
        place += 1;
        place - 1
    };
    let stiffness_factor = stiffness.then(|| {
        let mut one = fitted(next(), best.unknowns.stiffness_log, f64::exp, ranges.stiffness());
        one.standard_error *= one.value;
        one
    });
    let same = |value: f64| value;
    let dissipation = best
        .unknowns
        .dissipation
        .filter(|_| dissipation)
        .map(|value| fitted(next(), value, same, ranges.dissipation(value)));
    let of_height = |height: FittedHeight| {
        let heights_m = best.unknowns.heights_m(height).into_iter().enumerate();
        heights_m.map(|(trial, value)| fitted(next(), value, same, ranges.height(height, trial))).collect()
    };
    let mut floor_up_m: Vec<FittedParameter> = height.map(of_height).unwrap_or_default();
    let in_spheres = height == Some(FittedHeight::Spheres) && !floor_up_m.is_empty();
    let spheres_down_m = in_spheres.then(|| floor_up_m.remove(0));
    Ok(MotionFit {
        stiffness_height_correlation: (stiffness && height.is_some())
            .then(|| best.correlation(0, usize::from(dissipation.is_some()) + 1)),
        stiffness_factor,
        dissipation,
        floor_up_m,
        spheres_down_m,
        held_out: held_out(trials, |fitted, tested| {
            let best = search(fitted, bounds, &own).ok()?;
            Some(errors(tested, &best.unknowns).vertical_rms_bw)
        }),
        trials_rms_bw: trials
            .iter()
            .enumerate()
            .map(|(number, trial)| {
                errors(std::slice::from_ref(trial), &best.unknowns.of_trial(number)).vertical_rms_bw
            })
            .collect(),
        before: errors(trials, &own),
        after: errors(trials, &best.unknowns),
        beside: trials.iter().map(|trial| trial.beside).sum(),
        frames: trials.iter().flat_map(|trial| &trial.feet).map(FootForces::frames).sum(),
    })
}
