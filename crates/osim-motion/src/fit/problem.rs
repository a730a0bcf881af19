//! The least squares problem of a fit.

use contact_scaling::Law;
use rmpfit::{MPConfig, MPFitter, MPPar, MPResult};

use super::data::{FitTrial, FootForces};
use super::result::FitErrors;
use crate::stance::ON_BW;

/// The unknowns of a fit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unknowns {
    /// The logarithm of the factor of all stiffnesses.
    pub(super) stiffness_log: f64,
    /// α of all spheres, s/m; `None` where each keeps its own.
    pub(super) dissipation: Option<f64>,
    /// How far the floor moves up in each trial, m.
    pub(super) floor_up_m: Vec<f64>,
}

impl Unknowns {
    /// Those of one trial alone.
    pub(super) fn of_trial(&self, trial: usize) -> Self {
        let floor_up_m = self.floor_up_m.get(trial).copied().into_iter().collect();
        Self { floor_up_m, ..self.clone() }
    }
}

/// Which of them are fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FitWanted {
    /// The stiffness.
    pub stiffness: bool,
    /// The dissipation.
    pub dissipation: bool,
    /// The height of the floor.
    pub height: bool,
    /// The height of each sphere on its body, against the others.
    pub heights: bool,
    /// The place of each sphere along the foot.
    pub places: bool,
}

impl FitWanted {
    /// Whether any of the first three is fitted.
    pub(super) fn any_of_three(self) -> bool {
        self.stiffness || self.dissipation || self.height
    }
}

/// Force of one foot in each frame along the normal, over body weight, with these unknowns.
pub(super) fn forces_bw(
    foot: &FootForces,
    laws: &[Law],
    factor: f64,
    floor_up_m: f64,
    weight_n: f64,
    mut take: impl FnMut(usize, f64),
) {
    let scale = factor / weight_n;
    for frame in 0..foot.frames() {
        let contacts = foot.frame(frame).iter().zip(laws);
        let sum: f64 = contacts.map(|(&(x, rate), law)| law.force(x + floor_up_m, rate)).sum();
        take(frame, scale * sum);
    }
}

/// The laws of a foot, with another dissipation where there is one.
pub(super) fn with_dissipation(foot: &FootForces, dissipation: Option<f64>) -> Vec<Law> {
    let other = |law: &Law| law.with_dissipation(dissipation?).ok();
    foot.laws.iter().map(|(law, _)| other(law).unwrap_or(*law)).collect()
}

/// How far the forces with these unknowns are from the plates.
pub(super) fn errors(trials: &[FitTrial], unknowns: &Unknowns) -> FitErrors {
    let (mut square, mut count, mut deepest) = (0.0, 0_usize, f64::NEG_INFINITY);
    for (trial, &floor_up_m) in trials.iter().zip(&unknowns.floor_up_m) {
        for foot in &trial.feet {
            let laws = with_dissipation(foot, unknowns.dissipation);
            forces_bw(
                foot,
                &laws,
                unknowns.stiffness_log.exp(),
                floor_up_m,
                trial.weight_n,
                |frame, force_bw| {
                    let measured_n = foot.measured_n.get(frame).copied().unwrap_or_default();
                    square += (force_bw - measured_n / trial.weight_n).powi(2);
                    count += 1;
                    if measured_n > ON_BW * trial.weight_n {
                        for (&(x, _), &(_, radius_m)) in foot.frame(frame).iter().zip(&foot.laws) {
                            deepest = f64::max(deepest, (x + floor_up_m) / radius_m);
                        }
                    }
                },
            );
        }
    }
    FitErrors {
        vertical_rms_bw: (square / count.max(1) as f64).sqrt(),
        largest_relative_indentation: deepest,
    }
}

/// The problem as rmpfit takes it.
pub(super) struct Problem<'t> {
    pub(super) trials: &'t [FitTrial],
    pub(super) wanted: FitWanted,
    /// What is not fitted stays at this.
    pub(super) start: Unknowns,
    points: usize,
    config: MPConfig,
    settings: Vec<MPPar>,
}

impl<'t> Problem<'t> {
    pub(super) fn new(trials: &'t [FitTrial], wanted: FitWanted, start: &Unknowns, limits: &Limits) -> Self {
        let feet = trials.iter().flat_map(|trial| &trial.feet);
        let mut problem = Self {
            trials,
            wanted,
            start: start.clone(),
            points: feet.map(FootForces::frames).sum(),
            config: MPConfig { ftol: 1e-12, xtol: 1e-10, gtol: 1e-12, max_iter: 100, ..MPConfig::new() },
            settings: Vec::new(),
        };
        let limited = |low: f64, high: f64, step: f64| MPPar {
            limited_low: true,
            limited_up: true,
            limit_low: low,
            limit_up: high,
            step,
            ..MPPar::new()
        };
        if wanted.stiffness {
            problem.settings.push(limited(limits.stiffness_log.0, limits.stiffness_log.1, 1e-6));
        }
        if wanted.dissipation {
            problem.settings.push(limited(limits.dissipation.0, limits.dissipation.1, 1e-6));
        }
        if wanted.height {
            problem.settings.extend(limits.floor_up_m.iter().map(|&(low, high)| limited(low, high, 1e-8)));
        }
        problem
    }

    pub(super) fn to_vector(&self, unknowns: &Unknowns) -> Vec<f64> {
        let mut vector = Vec::new();
        vector.extend(self.wanted.stiffness.then_some(unknowns.stiffness_log));
        vector.extend(unknowns.dissipation.filter(|_| self.wanted.dissipation));
        if self.wanted.height {
            vector.extend(&unknowns.floor_up_m);
        }
        vector
    }

    pub(super) fn of_vector(&self, vector: &[f64]) -> Unknowns {
        let mut values = vector.iter().copied();
        let mut next =
            |is_fitted: bool, kept: f64| if is_fitted { values.next().unwrap_or(kept) } else { kept };
        Unknowns {
            stiffness_log: next(self.wanted.stiffness, self.start.stiffness_log),
            dissipation: self.start.dissipation.map(|kept| next(self.wanted.dissipation, kept)),
            floor_up_m: self.start.floor_up_m.iter().map(|&kept| next(self.wanted.height, kept)).collect(),
        }
    }

    /// Differences between model and plates over body weight, foot by foot and frame by frame.
    pub(super) fn deviates(&self, unknowns: &Unknowns, deviates: &mut [f64]) {
        let mut places = deviates.iter_mut();
        for (trial, &floor_up_m) in self.trials.iter().zip(&unknowns.floor_up_m) {
            for foot in &trial.feet {
                let laws = with_dissipation(foot, unknowns.dissipation);
                let factor = unknowns.stiffness_log.exp();
                forces_bw(foot, &laws, factor, floor_up_m, trial.weight_n, |frame, force_bw| {
                    let measured = foot.measured_n.get(frame).copied().unwrap_or_default() / trial.weight_n;
                    if let Some(place) = places.next() {
                        *place = force_bw - measured;
                    }
                });
            }
        }
    }

    /// The height of one trial stays.
    pub(super) fn keep_height(&mut self, trial: usize) {
        let before = self.settings.len().saturating_sub(self.trials.len());
        if let Some(setting) = self.settings.get_mut(before + trial).filter(|_| self.wanted.height) {
            setting.fixed = true;
        }
    }

    /// Whether anything is left to be fitted.
    pub(super) fn is_free(&self) -> bool {
        self.settings.iter().any(|one| !one.fixed)
    }

    pub(super) fn points(&self) -> usize {
        self.points
    }

    /// Between which values each unknown of a vector is.
    pub(super) fn limits(&self) -> Vec<(f64, f64)> {
        self.settings.iter().map(|one| (one.limit_low, one.limit_up)).collect()
    }
}

/// Between which values the unknowns are.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Limits {
    pub(super) stiffness_log: (f64, f64),
    pub(super) dissipation: (f64, f64),
    pub(super) floor_up_m: Vec<(f64, f64)>,
}

impl MPFitter for Problem<'_> {
    fn eval(&mut self, vector: &[f64], deviates: &mut [f64]) -> MPResult<()> {
        self.deviates(&self.of_vector(vector), deviates);
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.points
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.settings
    }
}
