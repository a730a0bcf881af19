//! Searches the best fit: first tries some heights, each with its best stiffness, then runs Levenberg–Marquardt on all unknowns.

use rmpfit::{MPFitter, MPStatus, MPSuccess};

use super::problem::{FitProblem, FitWanted, FittedHeight, Limits, Unknowns, forces_bw, with_dissipation};
use super::trial::FitTrial;
use crate::feet::ON_BW;

/// The number of heights that the search tries first.
const FIRST_HEIGHTS: usize = 48;
/// Dissipations that the search tries with each height, s/m.
const DISSIPATIONS: [f64; 3] = [0.2, 1.0, 3.0];
/// The largest stiffness factor of the search; the smallest is its inverse.
const LARGEST_STIFFNESS_FACTOR: f64 = 1e4;
/// The largest dissipation of the search, s/m.
const MOST_DISSIPATION_S_M: f64 = 10.0;
/// The largest height of the floor above the first touch of a sphere, if x/R has no bound, m.
const MOST_RISE_WITHOUT_BOUND_M: f64 = 0.25;
/// The largest distance by which spheres move up or down in their bodies, and by which floors of other trials differ from the
/// first, m.
const MOST_SHIFT_OF_SPHERES_M: f64 = 0.25;

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitBounds {
    pub wanted: FitWanted,
    /// The largest allowed x/R in frames with a force; `None` for no bound.
    pub most_relative_indentation: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    #[error("the plates measured no force under a foot during the recording: there is nothing to fit to")]
    NoForce,
    #[error("nothing is fitted: name at least one of stiffness, dissipation and height")]
    NothingToFit,
    #[error("no height of the floor within the bounds gives the feet a force like the plates'")]
    NoContact,
    #[error("the search did not converge")]
    NotConverged,
}

/// The unknowns of the unchanged model.
pub(super) fn unchanged_unknowns(trials: &[FitTrial]) -> Unknowns {
    let floor_up_m = vec![0.0; trials.len()];
    Unknowns { stiffness_log: 0.0, dissipation: None, floor_up_m, spheres_down_m: 0.0 }
}

pub(super) struct BestFit {
    pub(super) unknowns: Unknowns,
    pub(super) standard_error: Vec<f64>,
    pub(super) at_bound: Vec<bool>,
    covariance: Vec<f64>,
}

impl BestFit {
    pub(super) fn correlation(&self, one: usize, other: usize) -> f64 {
        let count = self.standard_error.len();
        let at = |i: usize, j: usize| self.covariance.get(i * count + j).copied().unwrap_or(f64::NAN);
        at(one, other) / (at(one, one) * at(other, other)).sqrt()
    }
}

/// Finds the stiffness, dissipation and heights with which the contact forces of all recordings together are closest to those of the plates.
pub(super) fn search(
    trials: &[FitTrial],
    bounds: &FitBounds,
    unchanged: &Unknowns,
) -> Result<BestFit, FitError> {
    let limits = search_limits(trials, bounds)?;
    let start = best_of_tried_heights(trials, bounds, unchanged, &floor_limits(trials, bounds)?)?;
    let start = if bounds.wanted.height == Some(FittedHeight::Spheres) {
        move_height_to_spheres(start)
    } else {
        start
    };
    let mut problem = FitProblem::new(trials, bounds.wanted, &start, &limits);
    let mut vector = problem.to_vector(&start);
    // The solver refuses a start beyond a limit.
    for (value, (low, high)) in vector.iter_mut().zip(problem.limits()) {
        *value = value.max(low).min(high);
    }
    let status = problem.mpfit(&mut vector).map_err(|_| FitError::NotConverged)?;
    if matches!(status.success, MPSuccess::NotDone) {
        return Err(FitError::NotConverged);
    }
    let unknowns = problem.unknowns_from(&vector);
    Ok(with_standard_errors(&problem, unknowns, &vector, &status))
}

/// Replaces the height of the first floor by a height of the spheres, and the heights of the other floors by their differences
/// from the first.
fn move_height_to_spheres(mut floors: Unknowns) -> Unknowns {
    floors.spheres_down_m = floors.floor_up_m.first().copied().unwrap_or_default();
    floors.floor_up_m.iter_mut().for_each(|up_m| *up_m -= floors.spheres_down_m);
    floors
}

/// The effective number of independent differences: fewer than frames, because differences of neighbouring frames are correlated.
fn independent_count(deviates: &[f64]) -> f64 {
    let square: f64 = deviates.iter().map(|one| one * one).sum();
    let shifted: f64 = deviates.windows(2).filter_map(|pair| Some(pair.first()? * pair.get(1)?)).sum();
    let alike = if square > 0.0 { (shifted / square).clamp(0.0, 0.999) } else { 0.0 };
    deviates.len() as f64 * (1.0 - alike) / (1.0 + alike)
}

fn with_standard_errors(
    problem: &FitProblem<'_>,
    unknowns: Unknowns,
    vector: &[f64],
    status: &MPStatus,
) -> BestFit {
    let mut deviates = vec![0.0; problem.frames()];
    problem.deviates(&unknowns, &mut deviates);
    let square: f64 = deviates.iter().map(|one| one * one).sum();
    let free = (independent_count(&deviates) - vector.len() as f64).max(1.0);
    // The covariance of mpfit assumes deviates with a variance of 1.
    let scale = square / free;
    let size = vector.len();
    let variance = |place: usize| status.covar.get(place * size + place).copied().unwrap_or(f64::NAN);
    let limits = problem.limits();
    let at_bound = vector.iter().zip(&limits).map(|(value, (low, high))| {
        let near = 1e-6 * (high - low);
        value - low <= near || high - value <= near
    });
    BestFit {
        standard_error: (0..size).map(|place| (scale * variance(place)).sqrt()).collect(),
        at_bound: at_bound.collect(),
        covariance: status.covar.clone(),
        unknowns,
    }
}

/// Limits of the unknowns in the search. If spheres move, a penalty limits their depth, because the depth depends on the
/// direction of their bodies.
pub(super) fn search_limits(trials: &[FitTrial], bounds: &FitBounds) -> Result<Limits, FitError> {
    let limits = floor_limits(trials, bounds)?;
    if bounds.wanted.height != Some(FittedHeight::Spheres) {
        return Ok(limits);
    }
    let heights_m = vec![(-MOST_SHIFT_OF_SPHERES_M, MOST_SHIFT_OF_SPHERES_M); trials.len()];
    Ok(Limits { heights_m, sphere_depth: bounds.most_relative_indentation, ..limits })
}

/// Limits of the heights if floors move: at least one sphere touches the floor, and no sphere is deeper than allowed.
fn floor_limits(trials: &[FitTrial], bounds: &FitBounds) -> Result<Limits, FitError> {
    let largest = LARGEST_STIFFNESS_FACTOR.ln();
    let mut heights_m = Vec::new();
    for trial in trials {
        let (mut least_m, mut most_m) = (f64::INFINITY, f64::INFINITY);
        let mut has_force = false;
        for foot in &trial.feet {
            for frame in 0..foot.frames() {
                if foot.measured_n.get(frame).is_none_or(|&force_n| force_n <= ON_BW * trial.weight_n) {
                    continue;
                }
                has_force = true;
                for (&(x, _), &(_, radius_m)) in foot.frame(frame).iter().zip(&foot.laws) {
                    // This sphere just touches if the floor goes up by -x.
                    least_m = least_m.min(-x);
                    if let Some(most) = bounds.most_relative_indentation {
                        most_m = most_m.min(most * radius_m - x);
                    }
                }
            }
        }
        if !has_force {
            return Err(FitError::NoForce);
        }
        let most_m = if most_m.is_finite() { most_m } else { least_m + MOST_RISE_WITHOUT_BOUND_M };
        heights_m.push((least_m.min(most_m - 1e-6), most_m));
    }
    Ok(Limits {
        stiffness_log: (-largest, largest),
        dissipation: (0.0, MOST_DISSIPATION_S_M),
        heights_m,
        sphere_depth: None,
    })
}

/// Tries some heights and dissipations, each with its best stiffness if the stiffness is fitted, and returns the best unknowns.
fn best_of_tried_heights(
    trials: &[FitTrial],
    bounds: &FitBounds,
    unchanged: &Unknowns,
    limits: &Limits,
) -> Result<Unknowns, FitError> {
    let dissipations =
        if bounds.wanted.dissipation { DISSIPATIONS.map(Some).to_vec() } else { vec![unchanged.dissipation] };
    let mut best: Option<(f64, Unknowns)> = None;
    for dissipation in dissipations {
        for step in 0..if bounds.wanted.height.is_some() { FIRST_HEIGHTS } else { 1 } {
            let part = (step as f64 + 0.5) / FIRST_HEIGHTS as f64;
            let floor_up_m = match bounds.wanted.height.is_some() {
                true => limits.heights_m.iter().map(|(low, high)| low + part * (high - low)).collect(),
                false => unchanged.floor_up_m.clone(),
            };
            let mut tried = Unknowns { dissipation, floor_up_m, ..unchanged.clone() };
            let Some(square) = set_best_stiffness(trials, &mut tried, bounds.wanted.stiffness, limits) else {
                continue;
            };
            if best.as_ref().is_none_or(|(least, _)| square < *least) {
                best = Some((square, tried));
            }
        }
    }
    best.map(|(_, unknowns)| unknowns).ok_or(FitError::NoContact)
}

/// Sets the best stiffness in `tried` if the stiffness is fitted, and returns the sum of squares; `None` if no sphere touches the
/// floor.
fn set_best_stiffness(
    trials: &[FitTrial],
    tried: &mut Unknowns,
    wanted: bool,
    limits: &Limits,
) -> Option<f64> {
    let (mut model_squared, mut product, mut plates_squared) = (0.0, 0.0, 0.0);
    for (number, trial) in trials.iter().enumerate() {
        let shift = tried.depth_shift(number);
        for foot in &trial.feet {
            let laws = with_dissipation(foot, tried.dissipation);
            forces_bw(foot, &laws, 1.0, shift, trial.weight_n, |frame, force_bw| {
                let measured = foot.measured_n.get(frame).copied().unwrap_or_default() / trial.weight_n;
                model_squared += force_bw * force_bw;
                product += force_bw * measured;
                plates_squared += measured * measured;
            });
        }
    }
    if !(model_squared > 0.0 && product > 0.0) {
        return None;
    }
    if wanted {
        let (low, high) = limits.stiffness_log;
        tried.stiffness_log = (product / model_squared).ln().clamp(low, high);
    }
    let factor = tried.stiffness_log.exp();
    Some(factor * factor * model_squared - 2.0 * factor * product + plates_squared)
}
