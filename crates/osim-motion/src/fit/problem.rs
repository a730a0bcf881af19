//! The least squares problem of a fit, and the results of a fit.

use contact_scaling::Law;
use rmpfit::{MPConfig, MPFitter, MPPar, MPResult};

use super::trial::{DepthShift, FitTrial, FootForces};

/// A fitted number with its standard error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedParameter {
    pub value: f64,
    /// Standard error of the parameter, corrected for the correlation of neighbouring frames; NaN without remaining degrees of freedom.
    pub standard_error: f64,
    /// The lowest and highest value at which a fit of the other parameters is nearly as good (rms within 5 %, or 0.005 body
    /// weights).
    pub nearly_as_good: (f64, f64),
    pub at_bound: bool,
}

/// The differences between the fitted forces and the forces of the plates.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FitErrors {
    /// Root mean square of the difference along the normal, over all feet, in body weights.
    pub vertical_rms_bw: f64,
    /// The largest x/R of a sphere in frames in which the plates measured a force.
    pub largest_relative_indentation: f64,
}

/// A fit of one part of the data, tested on the other part.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldOut {
    /// The fitted part of the data, in words.
    pub fitted: String,
    pub tested: String,
    /// The root mean square error on the tested part, in body weights.
    pub vertical_rms_bw: f64,
}

/// The result of a fit: contact parameters with which the forces of a model are like those of the plates.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MotionFit {
    /// The factor of all stiffnesses; `None` if it was not fitted.
    pub stiffness_factor: Option<FittedParameter>,
    /// The dissipation, s/m; `None` if it was not fitted.
    pub dissipation: Option<FittedParameter>,
    /// The distance by which the floor moves up in each trial, m; empty if no floor height was fitted.
    pub floor_up_m: Vec<FittedParameter>,
    /// The distance by which all spheres move down in their bodies, m; `None` if it was not fitted.
    pub spheres_down_m: Option<FittedParameter>,
    /// Correlation of the stiffness and the height of the first trial, if both were fitted.
    pub stiffness_height_correlation: Option<f64>,
    pub before: FitErrors,
    pub after: FitErrors,
    /// The root mean square error of each trial, in body weights.
    pub trials_rms_bw: Vec<f64>,
    /// Fits of one part of the data, tested on the other part: one foot against the others, or one half against the other.
    pub held_out: Vec<HeldOut>,
    /// The number of frames that were left out because a foot probably stands beside the plates.
    pub beside: usize,
    /// The number of fitted frames, summed over all feet.
    pub frames: usize,
}

impl MotionFit {
    /// The largest error on data that were not fitted, in body weights.
    pub fn held_out_rms_bw(&self) -> Option<f64> {
        self.held_out.iter().map(|one| one.vertical_rms_bw).reduce(f64::max)
    }
}

/// The penalty per radius of depth beyond the bound, for one sphere, in body weights.
const TOO_DEEP_BW: f64 = 200.0;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unknowns {
    /// The natural logarithm of the factor for all stiffnesses.
    pub(super) stiffness_log: f64,
    /// α of all spheres, s/m; `None` if each sphere keeps its own.
    pub(super) dissipation: Option<f64>,
    /// The distance by which the floor moves up in each trial, m.
    pub(super) floor_up_m: Vec<f64>,
    /// The distance by which all spheres move down in their bodies, m.
    pub(super) spheres_down_m: f64,
}

impl Unknowns {
    /// The distances by which floor and spheres make the contacts of a trial deeper.
    pub(super) fn depth_shift(&self, trial: usize) -> DepthShift {
        let floor_up_m = self.floor_up_m.get(trial).copied().unwrap_or_default();
        DepthShift { floor_up_m, spheres_down_m: self.spheres_down_m }
    }

    /// The fitted heights, one for each trial, m. The first may be a height of the spheres; the floor of the first trial then
    /// stays.
    pub(super) fn heights_m(&self, height: FittedHeight) -> Vec<f64> {
        let mut heights_m = self.floor_up_m.clone();
        if let Some(first) = heights_m.first_mut().filter(|_| height == FittedHeight::Spheres) {
            *first = self.spheres_down_m;
        }
        heights_m
    }

    pub(super) fn with_heights(self, height: FittedHeight, mut heights_m: Vec<f64>) -> Self {
        match (height, heights_m.first_mut()) {
            (FittedHeight::Spheres, Some(first)) => {
                let spheres_down_m = std::mem::take(first);
                Self { spheres_down_m, floor_up_m: heights_m, ..self }
            }
            _ => Self { floor_up_m: heights_m, ..self },
        }
    }

    /// The unknowns of the trial at index `trial`.
    pub(super) fn for_trial(&self, trial: usize) -> Self {
        let floor_up_m = self.floor_up_m.get(trial).copied().into_iter().collect();
        Self { floor_up_m, ..self.clone() }
    }
}

/// The object that is moved to fit a height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FittedHeight {
    /// The floor moves, in each trial by its own distance.
    Floor,
    /// All spheres move in their bodies. The floor of the first trial stays; the floor of each other trial moves by its own
    /// distance.
    Spheres,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FitWanted {
    pub stiffness: bool,
    pub dissipation: bool,
    /// The object that is moved to fit a height; `None` if no height is fitted.
    pub height: Option<FittedHeight>,
}

/// Calls `take` with the normal force of one foot in each frame, divided by body weight.
pub(super) fn forces_bw(
    foot: &FootForces,
    laws: &[Law],
    factor: f64,
    shift: DepthShift,
    weight_n: f64,
    mut take: impl FnMut(usize, f64),
) {
    let scale = factor / weight_n;
    for frame in 0..foot.frames() {
        let contacts = foot.shifted_contacts(frame, shift).zip(laws);
        let sum: f64 = contacts.map(|((x, rate), law)| law.force(x, rate)).sum();
        take(frame, scale * sum);
    }
}

/// The contact laws of a foot; all with `dissipation` if it is given.
pub(super) fn with_dissipation(foot: &FootForces, dissipation: Option<f64>) -> Vec<Law> {
    let other = |law: &Law| law.with_dissipation(dissipation?).ok();
    foot.laws.iter().map(|(law, _)| other(law).unwrap_or(*law)).collect()
}

/// The differences between the forces for these unknowns and the forces of the plates.
pub(super) fn errors(trials: &[FitTrial], unknowns: &Unknowns) -> FitErrors {
    let (mut square, mut count, mut deepest) = (0.0, 0_usize, f64::NEG_INFINITY);
    for (number, trial) in trials.iter().enumerate() {
        let shift = unknowns.depth_shift(number);
        for foot in &trial.feet {
            let laws = with_dissipation(foot, unknowns.dissipation);
            let factor = unknowns.stiffness_log.exp();
            forces_bw(foot, &laws, factor, shift, trial.weight_n, |frame, force_bw| {
                let measured_n = foot.measured_n.get(frame).copied().unwrap_or_default();
                square += (force_bw - measured_n / trial.weight_n).powi(2);
                count += 1;
                deepest = foot.loaded_depths(frame, shift, trial.weight_n).fold(deepest, f64::max);
            });
        }
    }
    FitErrors {
        vertical_rms_bw: (square / count.max(1) as f64).sqrt(),
        largest_relative_indentation: deepest,
    }
}

pub(super) struct FitProblem<'t> {
    pub(super) trials: &'t [FitTrial],
    pub(super) wanted: FitWanted,
    /// The values of parameters that are not fitted.
    pub(super) start: Unknowns,
    /// The number of frames, summed over all feet.
    frames: usize,
    /// The x/R above which a sphere gets a penalty: see [`Limits::sphere_depth`].
    sphere_depth: Option<f64>,
    config: MPConfig,
    settings: Vec<MPPar>,
}

impl<'t> FitProblem<'t> {
    pub(super) fn new(trials: &'t [FitTrial], wanted: FitWanted, start: &Unknowns, limits: &Limits) -> Self {
        let feet = trials.iter().flat_map(|trial| &trial.feet);
        let mut problem = Self {
            trials,
            wanted,
            start: start.clone(),
            frames: feet.map(FootForces::frames).sum(),
            sphere_depth: limits.sphere_depth,
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
        if wanted.height.is_some() {
            problem.settings.extend(limits.heights_m.iter().map(|&(low, high)| limited(low, high, 1e-8)));
        }
        problem
    }

    pub(super) fn to_vector(&self, unknowns: &Unknowns) -> Vec<f64> {
        let mut vector = Vec::new();
        vector.extend(self.wanted.stiffness.then_some(unknowns.stiffness_log));
        vector.extend(unknowns.dissipation.filter(|_| self.wanted.dissipation));
        vector.extend(self.wanted.height.into_iter().flat_map(|height| unknowns.heights_m(height)));
        vector
    }

    pub(super) fn unknowns_from(&self, vector: &[f64]) -> Unknowns {
        let mut values = vector.iter().copied();
        let mut next =
            |is_fitted: bool, kept: f64| if is_fitted { values.next().unwrap_or(kept) } else { kept };
        let fitted = Unknowns {
            stiffness_log: next(self.wanted.stiffness, self.start.stiffness_log),
            dissipation: self.start.dissipation.map(|kept| next(self.wanted.dissipation, kept)),
            ..self.start.clone()
        };
        match self.wanted.height {
            Some(height) => fitted.with_heights(height, values.collect()),
            None => fitted,
        }
    }

    /// Writes the differences between model and plates, divided by body weight, into `deviates`: foot by foot and frame by
    /// frame. Then follow, in the same order, the penalties for spheres that are too deep, if their depth has a bound.
    pub(super) fn deviates(&self, unknowns: &Unknowns, deviates: &mut [f64]) {
        let mut places = deviates.iter_mut();
        let mut put = |value: f64| places.by_ref().take(1).for_each(|place| *place = value);
        for (number, trial) in self.trials.iter().enumerate() {
            for foot in &trial.feet {
                let laws = with_dissipation(foot, unknowns.dissipation);
                let (factor, shift) = (unknowns.stiffness_log.exp(), unknowns.depth_shift(number));
                forces_bw(foot, &laws, factor, shift, trial.weight_n, |frame, force_bw| {
                    let measured = foot.measured_n.get(frame).copied().unwrap_or_default() / trial.weight_n;
                    put(force_bw - measured);
                });
            }
        }
        let Some(most) = self.sphere_depth else { return };
        for (number, trial) in self.trials.iter().enumerate() {
            for (foot, frame) in
                trial.feet.iter().flat_map(|foot| (0..foot.frames()).map(move |frame| (foot, frame)))
            {
                let depths = foot.loaded_depths(frame, unknowns.depth_shift(number), trial.weight_n);
                let square: f64 = depths.map(|depth| (depth - most).max(0.0).powi(2)).sum();
                put(TOO_DEEP_BW * square.sqrt());
            }
        }
    }

    /// Root of the sum of squares of all deviates (differences and penalties) divided by the number of frames, in body weights.
    pub(super) fn rms_bw(&self, unknowns: &Unknowns) -> f64 {
        let mut deviates = vec![0.0; self.number_of_points()];
        self.deviates(unknowns, &mut deviates);
        let square: f64 = deviates.iter().map(|one| one * one).sum();
        (square / self.frames.max(1) as f64).sqrt()
    }

    /// Fixes the height of one trial.
    pub(super) fn keep_height(&mut self, trial: usize) {
        let before = self.settings.len().saturating_sub(self.trials.len());
        if let Some(setting) = self.settings.get_mut(before + trial).filter(|_| self.wanted.height.is_some())
        {
            setting.fixed = true;
        }
    }

    /// Whether any parameter is left to fit.
    pub(super) fn has_free_parameters(&self) -> bool {
        self.settings.iter().any(|one| !one.fixed)
    }

    pub(super) fn frames(&self) -> usize {
        self.frames
    }

    /// The lowest and highest value of each unknown, in the order of [`Self::to_vector`].
    pub(super) fn limits(&self) -> Vec<(f64, f64)> {
        self.settings.iter().map(|one| (one.limit_low, one.limit_up)).collect()
    }
}

/// The lowest and highest values of the unknowns in a search.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Limits {
    pub(super) stiffness_log: (f64, f64),
    pub(super) dissipation: (f64, f64),
    /// The range of heights of each trial, m: see [`Unknowns::heights_m`].
    pub(super) heights_m: Vec<(f64, f64)>,
    /// The x/R above which spheres that move down in their bodies get a penalty; `None` if the ranges of heights limit the
    /// depth, or if it has no limit.
    pub(super) sphere_depth: Option<f64>,
}

impl MPFitter for FitProblem<'_> {
    fn eval(&mut self, vector: &[f64], deviates: &mut [f64]) -> MPResult<()> {
        self.deviates(&self.unknowns_from(vector), deviates);
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        if self.sphere_depth.is_some() { 2 * self.frames } else { self.frames }
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.settings
    }
}
