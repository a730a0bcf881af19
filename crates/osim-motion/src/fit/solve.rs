//! A fit from start to end.

use osim_model::SphereId;

use super::data::{FitTrial, FootForces};
use super::held_out::held_out;
use super::problem::{FitWanted, Unknowns, errors};
use super::ranges::{dissipation_range, height_range, stiffness_range};
use super::refine::{Layout, Refining, Sureness};
use super::result::{FittedParameter, MotionFit};
use super::search::{FitBounds, FitError, own, search};

/// Fits the unknowns to all `trials` together. Spheres that are `counterparts`, right and left, move alike in their bodies.
///
/// # Errors
/// [`FitError`].
pub fn fit_motion(
    trials: &[FitTrial],
    bounds: &FitBounds,
    counterparts: &[(SphereId, SphereId)],
) -> Result<MotionFit, FitError> {
    let FitWanted { heights, places, .. } = bounds.wanted;
    if !(bounds.wanted.any_of_three() || heights || places) {
        return Err(FitError::Nothing);
    }
    let own = own(trials);
    let parameters = match bounds.needs_answers() {
        true => refined(trials, bounds, &own, counterparts)?,
        false => three(trials, bounds, &own)?,
    };
    Ok(MotionFit {
        before: errors(trials, &own),
        beside: trials.iter().map(|trial| trial.beside).sum(),
        frames: trials.iter().flat_map(|trial| &trial.feet).map(FootForces::frames).sum(),
        ..parameters
    })
}

/// Stiffness, dissipation and the height of the floor.
fn three(trials: &[FitTrial], bounds: &FitBounds, own: &Unknowns) -> Result<MotionFit, FitError> {
    let FitWanted { stiffness, dissipation, height, .. } = bounds.wanted;
    let best = search(trials, bounds, own)?;
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
        held_out: held_out(trials, |fitted, tested| {
            let best = search(fitted, bounds, own).ok()?;
            Some(errors(tested, &best.unknowns).vertical_rms_bw)
        }),
        after,
        ..MotionFit::default()
    })
}

/// The search for the first three, and from there for all.
fn first_three(trials: &[FitTrial], bounds: &FitBounds, own: &Unknowns) -> Result<Unknowns, FitError> {
    match bounds.wanted.any_of_three() {
        true => Ok(search(trials, bounds, own)?.unknowns),
        false => Ok(own.clone()),
    }
}

/// All that can be fitted.
fn refined(
    trials: &[FitTrial],
    bounds: &FitBounds,
    own: &Unknowns,
    counterparts: &[(SphereId, SphereId)],
) -> Result<MotionFit, FitError> {
    let layout = Layout::of(trials, bounds, counterparts);
    let start = first_three(trials, bounds, own)?;
    let refining = Refining::new(trials, bounds, &layout, &start);
    let best = refining.search()?;
    let after = refining.errors(&best.shared, None);
    let sureness = Sureness::of(&refining, &best, &layout);
    let fitted = |place: usize| sureness.parameter(place);
    let stiffness_factor = layout.stiffness.map(|place| sureness.factor(place));
    let floor = layout.floor.into_iter().flat_map(|first| first..first + trials.len());
    let moves = layout.common.is_some() || layout.heights.is_some() || layout.places.is_some();
    Ok(MotionFit {
        stiffness_height_correlation: layout
            .stiffness
            .zip(layout.floor.or(layout.common))
            .map(|(one, other)| sureness.correlation(one, other)),
        stiffness_factor,
        dissipation: layout.dissipation.map(fitted),
        floor_up_m: floor.map(fitted).collect(),
        spheres_down_m: layout.common.map(fitted),
        moved: if moves { best.moved(&layout) } else { Vec::new() },
        slack: refining.used(&best),
        held_out: held_out(trials, |part, rest| {
            let start = first_three(part, bounds, own).ok()?;
            let best = Refining::new(part, bounds, &layout, &start).search().ok()?;
            // The rest is seen without slack: with slack of its own it would fit anything.
            let tested = Refining::new(rest, &FitBounds { slack_m: None, ..*bounds }, &layout, &start);
            Some(tested.errors(&best.shared, None).vertical_rms_bw)
        }),
        after,
        ..MotionFit::default()
    })
}
