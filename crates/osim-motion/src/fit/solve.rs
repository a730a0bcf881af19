//! Runs a whole fit: the best values, the ranges of values that fit nearly as well, and tests on data that were not fitted.

use rmpfit::MPFitter;

use super::problem::{
    FitProblem, FitWanted, FittedHeight, FittedParameter, HeldOut, Limits, MotionFit, Unknowns, errors,
};
use super::search::{FitBounds, FitError, search, search_limits, unchanged_unknowns};
use super::trial::{FitTrial, FootForces};

/// Fits the unknowns to all `trials` together.
pub fn fit_motion(trials: &[FitTrial], bounds: &FitBounds) -> Result<MotionFit, FitError> {
    let FitWanted { stiffness, dissipation, height } = bounds.wanted;
    if !(stiffness || dissipation || height.is_some()) {
        return Err(FitError::NothingToFit);
    }
    if trials.iter().all(|trial| trial.feet.iter().all(|foot| !foot.has_force(trial.weight_n))) {
        return Err(FitError::NoForce);
    }
    let unchanged = unchanged_unknowns(trials);
    let best = search(trials, bounds, &unchanged)?;
    let fitted = |place: usize, value: f64, map: fn(f64) -> f64, range: (f64, f64)| FittedParameter {
        value: map(value),
        standard_error: best.standard_error.get(place).copied().unwrap_or(f64::NAN),
        nearly_as_good: range,
        at_bound: best.at_bound.get(place).copied().unwrap_or(false),
    };
    let ranges = NearlyAsGood::new(trials, bounds.wanted, search_limits(trials, bounds)?, &best.unknowns);
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
    let fitted_heights = |height: FittedHeight| {
        let heights_m = best.unknowns.heights_m(height).into_iter().enumerate();
        heights_m.map(|(trial, value)| fitted(next(), value, same, ranges.height(height, trial))).collect()
    };
    let mut floor_up_m: Vec<FittedParameter> = height.map(fitted_heights).unwrap_or_default();
    let in_spheres = height == Some(FittedHeight::Spheres) && !floor_up_m.is_empty();
    let spheres_down_m = in_spheres.then(|| floor_up_m.remove(0));
    Ok(MotionFit {
        stiffness_height_correlation: (stiffness && height.is_some())
            .then(|| best.correlation(0, usize::from(dissipation.is_some()) + 1)),
        stiffness_factor,
        dissipation,
        floor_up_m,
        spheres_down_m,
        held_out: test_on_held_out(trials, |fitted, tested| {
            let best = search(fitted, bounds, &unchanged).ok()?;
            Some(errors(tested, &best.unknowns).vertical_rms_bw)
        }),
        trials_rms_bw: trials
            .iter()
            .enumerate()
            .map(|(number, trial)| {
                errors(std::slice::from_ref(trial), &best.unknowns.for_trial(number)).vertical_rms_bw
            })
            .collect(),
        before: errors(trials, &unchanged),
        after: errors(trials, &best.unknowns),
        beside: trials.iter().map(|trial| trial.beside).sum(),
        frames: trials.iter().flat_map(|trial| &trial.feet).map(FootForces::frames).sum(),
    })
}

/// Fits each foot and tests the fit on the others; with only one foot, fits each half of the data and tests the fit on the other
/// half. `fit_and_test` fits its first argument and returns the error on its second, in body weights.
pub(super) fn test_on_held_out(
    trials: &[FitTrial],
    fit_and_test: impl Fn(&[FitTrial], &[FitTrial]) -> Option<f64>,
) -> Vec<HeldOut> {
    let mut results = Vec::new();
    let mut add = |fitted: &str, tested: &str, parts: (Vec<FitTrial>, Vec<FitTrial>)| {
        let has_force = |trial: &FitTrial| trial.feet.iter().any(|foot| foot.has_force(trial.weight_n));
        // A foot in the air cannot be fitted, and every fit passes a test on it.
        if !(parts.0.iter().any(has_force) && parts.1.iter().any(has_force)) {
            return;
        }
        let Some(vertical_rms_bw) = fit_and_test(&parts.0, &parts.1) else { return };
        results.push(HeldOut { fitted: fitted.to_owned(), tested: tested.to_owned(), vertical_rms_bw });
    };
    let count = trials.iter().map(|trial| trial.feet.len()).min().unwrap_or(0);
    if count > 1 {
        for foot in 0..count {
            let name =
                |trial: &FitTrial| trial.feet.get(foot).map(|foot| foot.name.clone()).unwrap_or_default();
            let fitted = trials.first().map(name).unwrap_or_default();
            let only = |keep: &dyn Fn(usize) -> bool| -> Vec<FitTrial> {
                let with_feet = |trial: &FitTrial| {
                    let feet = trial.feet.iter().enumerate().filter(|(index, _)| keep(*index));
                    FitTrial { feet: feet.map(|(_, foot)| foot.clone()).collect(), ..trial.clone() }
                };
                trials.iter().map(with_feet).collect()
            };
            let parts = (only(&|index| index == foot), only(&|index| index != foot));
            let others = parts.1.first().into_iter().flat_map(|trial| &trial.feet);
            let tested: Vec<&str> = others.map(|foot| foot.name.as_str()).collect();
            add(&fitted, &tested.join(" and the "), parts.clone());
        }
        return results;
    }
    let half = |second: bool| -> Vec<FitTrial> {
        let half_of = |trial: &FitTrial| {
            let feet = trial.feet.iter().map(|foot| {
                let middle = foot.frames() / 2;
                if second { foot.frame_range(middle, foot.frames()) } else { foot.frame_range(0, middle) }
            });
            FitTrial { feet: feet.collect(), ..trial.clone() }
        };
        trials.iter().map(half_of).collect()
    };
    add("first half", "second half", (half(false), half(true)));
    add("second half", "first half", (half(true), half(false)));
    results
}

// Ranges of values with which the other parameters fit nearly as well.

/// The largest number of doublings of a step in the search for the end of a range, before the step is halved.
const MOST_DOUBLINGS: usize = 4;
const HALVINGS: usize = 6;
/// The first step of a height in the search for the end of a range, m.
const HEIGHT_STEP_M: f64 = 0.002;
/// A fit is nearly as good as the best one if its error is at most this many times larger, or at most `NEARLY_BEST_BW` larger.
const NEARLY_BEST_FACTOR: f64 = 1.05;
/// Largest difference from the best error of a fit that is nearly as good, in body weights; see `NEARLY_BEST_FACTOR`.
const NEARLY_BEST_BW: f64 = 0.005;

/// The largest number of frames per foot, roughly, for the search for ranges.
const MOST_FRAMES: usize = 400;

/// Finds the range of each parameter in which a fit of the other parameters is nearly as good as the best fit.
pub(super) struct NearlyAsGood<'b> {
    trials: Vec<FitTrial>,
    wanted: FitWanted,
    limits: Limits,
    best: &'b Unknowns,
    rms_bw: f64,
}

impl<'b> NearlyAsGood<'b> {
    pub(super) fn new(trials: &[FitTrial], wanted: FitWanted, limits: Limits, best: &'b Unknowns) -> Self {
        let trials: Vec<FitTrial> = trials.iter().map(|trial| trial.thinned(MOST_FRAMES)).collect();
        let rms_bw = FitProblem::new(&trials, wanted, best, &limits).rms_bw(best);
        Self { trials, wanted, limits, best, rms_bw }
    }

    pub(super) fn stiffness(&self) -> (f64, f64) {
        let wanted = FitWanted { stiffness: false, ..self.wanted };
        let tried = |log: f64| {
            self.refitted_rms_bw(wanted, None, &Unknowns { stiffness_log: log, ..self.best.clone() })
        };
        let low = range_end(self.best.stiffness_log, -1.0, self.rms_bw, &tried);
        let high = range_end(self.best.stiffness_log, 1.0, self.rms_bw, &tried);
        (low.exp(), high.exp())
    }

    /// The range of the dissipation around `value`, s/m.
    pub(super) fn dissipation(&self, value: f64) -> (f64, f64) {
        let wanted = FitWanted { dissipation: false, ..self.wanted };
        let (least, most) = self.limits.dissipation;
        let tried = |dissipation: f64| {
            let start = Unknowns { dissipation: Some(dissipation.clamp(least, most)), ..self.best.clone() };
            self.refitted_rms_bw(wanted, None, &start)
        };
        let low = range_end(value, -0.5, self.rms_bw, &tried).max(least);
        (low, range_end(value, 0.5, self.rms_bw, &tried).min(most))
    }

    pub(super) fn height(&self, height: FittedHeight, trial: usize) -> (f64, f64) {
        let heights_m = self.best.heights_m(height);
        let value = heights_m.get(trial).copied().unwrap_or_default();
        let Some(&(least_m, most_m)) = self.limits.heights_m.get(trial) else { return (value, value) };
        let tried = |up_m: f64| {
            let mut heights_m = heights_m.clone();
            *heights_m.get_mut(trial)? = up_m.clamp(least_m, most_m);
            let start = self.best.clone().with_heights(height, heights_m);
            self.refitted_rms_bw(self.wanted, Some(trial), &start)
        };
        let low_m = range_end(value, -HEIGHT_STEP_M, self.rms_bw, &tried).max(least_m);
        (low_m, range_end(value, HEIGHT_STEP_M, self.rms_bw, &tried).min(most_m))
    }

    /// The error after a fit of the `wanted` parameters from `start`; the others and the height of one trial are fixed.
    fn refitted_rms_bw(
        &self,
        wanted: FitWanted,
        kept_height: Option<usize>,
        start: &Unknowns,
    ) -> Option<f64> {
        let mut problem = FitProblem::new(&self.trials, wanted, start, &self.limits);
        if let Some(trial) = kept_height {
            problem.keep_height(trial);
        }
        if !problem.has_free_parameters() {
            return Some(problem.rms_bw(start));
        }
        let mut vector: Vec<f64> = problem.to_vector(start);
        for (value, (low, high)) in vector.iter_mut().zip(problem.limits()) {
            *value = value.clamp(low, high);
        }
        problem.mpfit(&mut vector).ok()?;
        Some(problem.rms_bw(&problem.unknowns_from(&vector)))
    }
}

/// The last value in the direction of `step` at which a fit of the other parameters is nearly as good as the best fit.
fn range_end(value: f64, step: f64, rms_bw: f64, tried: &impl Fn(f64) -> Option<f64>) -> f64 {
    let is_near = |at: f64| {
        tried(at).is_some_and(|rms| rms <= (rms_bw * NEARLY_BEST_FACTOR).max(rms_bw + NEARLY_BEST_BW))
    };
    let (mut inside, mut step) = (value, step);
    for _ in 0..MOST_DOUBLINGS {
        if !is_near(inside + step) {
            break;
        }
        inside += step;
        step *= 2.0;
    }
    for _ in 0..HALVINGS {
        step /= 2.0;
        if is_near(inside + step) {
            inside += step;
        }
    }
    inside
}
