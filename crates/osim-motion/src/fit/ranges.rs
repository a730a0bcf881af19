//! Values with which the rest can be fitted nearly as well.

use rmpfit::MPFitter;

use super::data::FitTrial;
use super::problem::{FitWanted, FittedHeight, Limits, Problem, Unknowns};

/// Steps that double until an edge is passed, and halves of the last one to find it.
const DOUBLES: usize = 4;
const HALVES: usize = 6;
/// The first step of a height, m.
const HEIGHT_STEP_M: f64 = 0.002;
/// A fit is nearly as good where its error is at most so many times larger,
const NEARLY: f64 = 1.05;
/// or larger by this, body weights.
const NEARLY_BW: f64 = 0.005;

/// So many frames of a foot are enough to say how far values can go.
const FRAMES: usize = 400;

/// Looks for values with which the rest can be fitted nearly as well as with the best ones.
pub(super) struct Ranges<'b> {
    trials: Vec<FitTrial>,
    wanted: FitWanted,
    limits: Limits,
    best: &'b Unknowns,
    rms_bw: f64,
}

impl<'b> Ranges<'b> {
    /// Of the `best` unknowns of `trials`, between `limits`.
    pub(super) fn new(trials: &[FitTrial], wanted: FitWanted, limits: Limits, best: &'b Unknowns) -> Self {
        let trials: Vec<FitTrial> = trials.iter().map(|trial| trial.thinned(FRAMES)).collect();
        let rms_bw = Problem::new(&trials, wanted, best, &limits).rms_bw(best);
        Self { trials, wanted, limits, best, rms_bw }
    }

    /// Factors of the stiffness.
    pub(super) fn stiffness(&self) -> (f64, f64) {
        let wanted = FitWanted { stiffness: false, ..self.wanted };
        let tried =
            |log: f64| self.refitted(wanted, None, &Unknowns { stiffness_log: log, ..self.best.clone() });
        let low = edge(self.best.stiffness_log, -1.0, self.rms_bw, &tried);
        let high = edge(self.best.stiffness_log, 1.0, self.rms_bw, &tried);
        (low.exp(), high.exp())
    }

    /// Dissipations around `value`, s/m.
    pub(super) fn dissipation(&self, value: f64) -> (f64, f64) {
        let wanted = FitWanted { dissipation: false, ..self.wanted };
        let (least, most) = self.limits.dissipation;
        let tried = |dissipation: f64| {
            let start = Unknowns { dissipation: Some(dissipation.clamp(least, most)), ..self.best.clone() };
            self.refitted(wanted, None, &start)
        };
        let low = edge(value, -0.5, self.rms_bw, &tried).max(least);
        (low, edge(value, 0.5, self.rms_bw, &tried).min(most))
    }

    /// Heights of one trial, m.
    pub(super) fn height(&self, height: FittedHeight, trial: usize) -> (f64, f64) {
        let heights_m = self.best.heights_m(height);
        let value = heights_m.get(trial).copied().unwrap_or_default();
        let Some(&(least_m, most_m)) = self.limits.heights_m.get(trial) else { return (value, value) };
        let tried = |up_m: f64| {
            let mut heights_m = heights_m.clone();
            *heights_m.get_mut(trial)? = up_m.clamp(least_m, most_m);
            let start = self.best.clone().with_heights(height, heights_m);
            self.refitted(self.wanted, Some(trial), &start)
        };
        let low_m = edge(value, -HEIGHT_STEP_M, self.rms_bw, &tried).max(least_m);
        (low_m, edge(value, HEIGHT_STEP_M, self.rms_bw, &tried).min(most_m))
    }

    /// The error with what is `wanted` fitted from `start`, the rest kept, and the height of one trial.
    fn refitted(&self, wanted: FitWanted, kept_height: Option<usize>, start: &Unknowns) -> Option<f64> {
        let mut problem = Problem::new(&self.trials, wanted, start, &self.limits);
        if let Some(trial) = kept_height {
            problem.keep_height(trial);
        }
        if !problem.is_free() {
            return Some(problem.rms_bw(start));
        }
        let mut vector: Vec<f64> = problem.to_vector(start);
        for (value, (low, high)) in vector.iter_mut().zip(problem.limits()) {
            *value = value.clamp(low, high);
        }
        problem.mpfit(&mut vector).ok()?;
        Some(problem.rms_bw(&problem.of_vector(&vector)))
    }
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
