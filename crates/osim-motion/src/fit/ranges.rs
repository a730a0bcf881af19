//! Values with which the rest can be fitted nearly as well.

use rmpfit::MPFitter;

use super::data::FitTrial;
use super::problem::{FitWanted, Problem, Unknowns, errors};
use super::search::{FitBounds, MOST_DISSIPATION, limits};

/// Steps that double until an edge is passed, and halves of the last one to find it.
const DOUBLES: usize = 4;
const HALVES: usize = 6;
/// The first step of a height, m.
const HEIGHT_STEP_M: f64 = 0.002;
/// A fit is nearly as good where its error is at most so many times larger,
pub(super) const NEARLY: f64 = 1.05;
/// or larger by this, body weights.
pub(super) const NEARLY_BW: f64 = 0.005;

/// Stiffnesses with which height and dissipation can be fitted nearly as well.
pub(super) fn stiffness_range(
    trials: &[FitTrial],
    bounds: &FitBounds,
    best: &Unknowns,
    rms_bw: f64,
) -> (f64, f64) {
    let wanted = FitWanted { stiffness: false, ..bounds.wanted };
    let tried = |log: f64| {
        let start = Unknowns { stiffness_log: log, ..best.clone() };
        refitted(trials, bounds, wanted, None, &start)
    };
    let low = edge(best.stiffness_log, -1.0, rms_bw, &tried);
    let high = edge(best.stiffness_log, 1.0, rms_bw, &tried);
    (low.exp(), high.exp())
}

/// Dissipations with which the rest can be fitted nearly as well as with `value`.
pub(super) fn dissipation_range(
    trials: &[FitTrial],
    bounds: &FitBounds,
    best: &Unknowns,
    value: f64,
    rms_bw: f64,
) -> (f64, f64) {
    let wanted = FitWanted { dissipation: false, ..bounds.wanted };
    let tried = |dissipation: f64| {
        let start = Unknowns { dissipation: Some(dissipation.clamp(0.0, MOST_DISSIPATION)), ..best.clone() };
        refitted(trials, bounds, wanted, None, &start)
    };
    let low = edge(value, -0.5, rms_bw, &tried).max(0.0);
    (low, edge(value, 0.5, rms_bw, &tried).min(MOST_DISSIPATION))
}

/// Heights of the floor of one trial with which the rest can be fitted nearly as well; within the bounds of the search.
pub(super) fn height_range(
    trials: &[FitTrial],
    bounds: &FitBounds,
    best: &Unknowns,
    trial: usize,
    rms_bw: f64,
) -> (f64, f64) {
    let value = best.floor_up_m.get(trial).copied().unwrap_or_default();
    let Some((least_m, most_m)) =
        limits(trials, bounds).ok().and_then(|all| all.floor_up_m.get(trial).copied())
    else {
        return (value, value);
    };
    let tried = |up_m: f64| {
        let mut start = best.clone();
        *start.floor_up_m.get_mut(trial)? = up_m.clamp(least_m, most_m);
        refitted(trials, bounds, bounds.wanted, Some(trial), &start)
    };
    let low_m = edge(value, -HEIGHT_STEP_M, rms_bw, &tried).max(least_m);
    (low_m, edge(value, HEIGHT_STEP_M, rms_bw, &tried).min(most_m))
}

/// How far a value can go until the rest no longer fits: steps that double, then halves.
fn edge(value: f64, step: f64, rms_bw: f64, tried: &impl Fn(f64) -> Option<f64>) -> f64 {
    let is_near = |at: f64| tried(at).is_some_and(|rms| rms <= (rms_bw * NEARLY).max(rms_bw + NEARLY_BW));
    let (mut inside, mut step) = (value, step);
    for _ in 0..DOUBLES {
        if !is_near(inside + step) {
            break;
        }
        inside += step;
        step *= 2.0;
    }
    for _ in 0..HALVES {
        step /= 2.0;
        if is_near(inside + step) {
            inside += step;
        }
    }
    inside
}

/// The error with what is `wanted` fitted from `start`, the rest kept, and the height of one trial.
fn refitted(
    trials: &[FitTrial],
    bounds: &FitBounds,
    wanted: FitWanted,
    kept_height: Option<usize>,
    start: &Unknowns,
) -> Option<f64> {
    let limits = limits(trials, bounds).ok()?;
    let mut problem = Problem::new(trials, wanted, start, &limits);
    if let Some(trial) = kept_height {
        problem.keep_height(trial);
    }
    if !problem.is_free() {
        return Some(errors(trials, start).vertical_rms_bw);
    }
    let mut vector: Vec<f64> = problem.to_vector(start);
    for (value, (low, high)) in vector.iter_mut().zip(problem.limits()) {
        *value = value.clamp(low, high);
    }
    problem.mpfit(&mut vector).ok()?;
    Some(errors(trials, &problem.of_vector(&vector)).vertical_rms_bw)
}
