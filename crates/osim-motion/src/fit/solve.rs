//! A fit from start to end.

use osim_model::SphereId;

use super::answers::Answers;
use super::data::{FitTrial, FootForces};
use super::held_out::held_out;
use super::problem::{FitWanted, Unknowns, errors};
use super::ranges::Ranges;
use super::refine::{Layout, Refined, Refining, Sureness};
use super::result::{FittedParameter, MotionFit};
use super::search::{FitBounds, FitError, limits, own, search};

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
    if trials.iter().all(|trial| trial.feet.iter().all(|foot| !foot.has_force(trial.weight_n))) {
        return Err(FitError::NoForce);
    }
    let mut feet = trials.iter().flat_map(|trial| &trial.feet);
    if bounds.cop_m.is_some() && !feet.any(|foot| foot.answers.as_ref().is_some_and(Answers::has_centres)) {
        return Err(FitError::NoCentre);
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
    let floor_up_m = match height {
        true => (0..trials.len())
            .map(|trial| {
                let value = best.unknowns.floor_up_m.get(trial).copied().unwrap_or_default();
                fitted(next(), value, same, ranges.height(trial))
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
        trials_rms_bw: trials
            .iter()
            .enumerate()
            .map(|(number, trial)| {
                errors(std::slice::from_ref(trial), &best.unknowns.of_trial(number)).vertical_rms_bw
            })
            .collect(),
        after,
        ..MotionFit::default()
    })
}

/// Where the search for all unknowns begins: at the best of the first three; and, since it may end in a hollow beside the deepest, at the
/// best height for the stiffness that is there. From that one, the others are looked for before the stiffness.
fn starts(trials: &[FitTrial], bounds: &FitBounds, own: &Unknowns) -> Result<Vec<Unknowns>, FitError> {
    let wanted = bounds.wanted;
    if !wanted.any_of_three() {
        return Ok(vec![own.clone()]);
    }
    let mut starts = vec![search(trials, bounds, own)?.unknowns];
    if wanted.height && (wanted.stiffness || wanted.dissipation) {
        let kept = FitWanted { stiffness: false, dissipation: false, ..wanted };
        let found = search(trials, &FitBounds { wanted: kept, ..*bounds }, own).ok();
        // Where the dissipation is fitted, each sphere has the same.
        let mut laws = trials.iter().flat_map(|trial| &trial.feet).flat_map(|foot| &foot.laws);
        let first = laws.next().map(|(law, _)| law.dissipation());
        let dissipation = first.filter(|_| wanted.dissipation);
        starts.extend(found.map(|best| Unknowns { dissipation, ..best.unknowns }));
    }
    Ok(starts)
}

/// The best of the searches from all starts, or from the start of this number alone; with its number.
fn deepest<'t>(
    trials: &'t [FitTrial],
    bounds: &FitBounds,
    layout: &'t Layout,
    own: &Unknowns,
    only: Option<usize>,
) -> Result<(usize, Refining<'t>, Refined), FitError> {
    let mut best: Option<(usize, Refining<'t>, Refined)> = None;
    for (number, start) in starts(trials, bounds, own)?.iter().enumerate() {
        if only.is_some_and(|only| only != number) {
            continue;
        }
        let refining = Refining::new(trials, bounds, layout, start);
        let found = refining.search(number > 0)?;
        if best.as_ref().is_none_or(|(_, _, best)| found.cost() < best.cost()) {
            best = Some((number, refining, found));
        }
    }
    best.ok_or(FitError::NotConverged)
}

/// All that can be fitted.
fn refined(
    trials: &[FitTrial],
    bounds: &FitBounds,
    own: &Unknowns,
    counterparts: &[(SphereId, SphereId)],
) -> Result<MotionFit, FitError> {
    let layout = Layout::of(trials, bounds, counterparts);
    let (number, refining, best) = deepest(trials, bounds, &layout, own, None)?;
    let after = refining.errors(&best.shared, None);
    let sureness = Sureness::of(&refining, &best, &layout);
    let fitted = |place: usize| sureness.parameter(place);
    let stiffness_factor = layout.stiffness.map(|place| sureness.factor(place));
    let floor = (0..trials.len()).filter_map(|trial| layout.floor_of(trial));
    let moves = layout.common.is_some() || layout.heights.is_some() || layout.places.is_some();
    Ok(MotionFit {
        stiffness_height_correlation: layout
            .stiffness
            .zip(layout.common.or(layout.floor))
            .map(|(one, other)| sureness.correlation(one, other)),
        stiffness_factor,
        dissipation: layout.dissipation.map(fitted),
        floor_up_m: floor.map(fitted).collect(),
        spheres_down_m: layout.common.map(fitted),
        moved: if moves { best.moved(&layout) } else { Vec::new() },
        slack: refining.used(&best),
        held_out: held_out(trials, |part, rest| {
            let (_, fitted, best) = deepest(part, bounds, &layout, own, Some(number)).ok()?;
            // The rest is seen without slack: with slack of its own it would fit anything.
            let seen = FitBounds { slack_m: None, ..*bounds };
            let tested = Refining::new(rest, &seen, &layout, fitted.start());
            Some(tested.errors(&best.shared, None).vertical_rms_bw)
        }),
        trials_rms_bw: (0..trials.len()).map(|trial| refining.error_of_trial(&best.shared, trial)).collect(),
        after,
        ..MotionFit::default()
    })
}
