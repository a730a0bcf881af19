//! Fits contact parameters and the height of the floor, so that the forces of a model are like those that plates measured.
//!
//! The unknowns are a factor for all stiffnesses, the dissipation, and for each trial the distance by which the floor moves up.
//! Instead of the floor of the first trial, all spheres may move down in their bodies. The fit makes the differences between model
//! and plates small: in the force along the normal of each foot, divided by body weight. The search tries some heights, each with its
//! best stiffness, and then runs Levenberg–Marquardt from the best of them.

use contact_scaling::Law;
use rmpfit::{MPConfig, MPFitter, MPPar, MPResult, MPSuccess};

pub use crate::fit_data::{FitError, FitErrors, FitTrial, FittedParameter, FootForces, HeldOut, MotionFit};

/// Which parameters of contacts are fitted to recordings, and their bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitBounds {
    pub stiffness: bool,
    pub dissipation: bool,
    /// The height of the floor, in each trial by its own distance.
    pub height: bool,
    /// Whether all spheres move in their bodies in place of the floor of the first trial; the height must be fitted.
    pub spheres_move: bool,
    /// The largest allowed x/R in frames with a force; `None` for no bound.
    pub most_relative_indentation: Option<f64>,
}

/// The number of heights of the floor that the search for a fit tries first.
const COUNT_OF_TRIED_HEIGHTS: usize = 48;
/// The dissipations that the search for a fit tries with each height of the floor, s/m.
const TRIED_DISSIPATIONS_S_M: [f64; 3] = [0.2, 1.0, 3.0];
/// The largest factor of the stiffness in the search for a fit; the smallest factor is its inverse.
const LARGEST_STIFFNESS_FACTOR: f64 = 1e4;
/// The largest dissipation in the search for a fit, s/m.
const MOST_DISSIPATION_S_M: f64 = 10.0;
/// The largest height of the floor above the first touch of a sphere, if x/R has no bound, m.
const MOST_RISE_WITHOUT_BOUND_M: f64 = 0.25;
/// The largest distance by which spheres move up or down in their bodies, and by which floors of other trials then differ from the
/// first, m.
const MOST_SHIFT_OF_SPHERES_M: f64 = 0.25;
/// The penalty per radius of depth beyond the bound, for one sphere, in body weights.
const PENALTY_BW_PER_RADIUS: f64 = 200.0;
/// The recordings do not determine the stiffness if the largest factor that fits nearly as well is more than this many times the
/// smallest.
const WIDE_STIFFNESS_RATIO: f64 = 3.0;
/// The recordings do not determine the dissipation if the dissipations that fit nearly as well differ by more than this, s/m.
const WIDE_DISSIPATION_S_M: f64 = 1.0;
/// A fit is nearly as good as the best one if its error is at most this many times larger, or at most `NEARLY_BEST_BW` larger.
const NEARLY_BEST_FACTOR: f64 = 1.05;
/// A fit is nearly as good as the best one if its error is larger by at most this, body weights.
const NEARLY_BEST_BW: f64 = 0.005;
/// The largest number of times that the step is doubled in the search for the end of a range of good fits.
const MOST_DOUBLINGS: usize = 4;
/// The number of times that the step is halved in the search for the end of a range of good fits.
const MOST_HALVINGS: usize = 6;
/// The first step of a height in the search for the end of a range of good fits, m.
const HEIGHT_STEP_M: f64 = 0.002;
/// The largest number of frames per foot, roughly, in the search for ranges of good fits.
const MOST_FRAMES_PER_FOOT: usize = 400;

/// Index of the logarithm of the stiffness factor among the unknowns of a fit.
const INDEX_OF_STIFFNESS: usize = 0;
/// Index of the dissipation among the unknowns of a fit; its value is not a number where each sphere keeps its own.
const INDEX_OF_DISSIPATION: usize = 1;
/// Index of the distance by which spheres move down among the unknowns of a fit.
const INDEX_OF_SPHERES_DOWN: usize = 2;
/// Index of the height of the floor in the first trial among the unknowns of a fit; the other trials follow.
const FIRST_INDEX_OF_FLOORS: usize = 3;

/// Calls `take` with contact force and measured force (body weights), foot by foot and frame by frame, for these unknowns.
fn visit_forces(trials: &[FitTrial], vector: &[f64], mut take: impl FnMut(f64, f64)) {
    let factor = vector[INDEX_OF_STIFFNESS].exp();
    for (trial, &up_m) in trials.iter().zip(&vector[FIRST_INDEX_OF_FLOORS..]) {
        for foot in &trial.feet {
            let law =
                |(law, _): &(Law, f64)| law.with_dissipation(vector[INDEX_OF_DISSIPATION]).unwrap_or(*law);
            let laws: Vec<Law> = foot.laws.iter().map(law).collect();
            for (measured_n, contacts) in foot.frames([up_m, vector[INDEX_OF_SPHERES_DOWN]]) {
                let sum: f64 = contacts.zip(&laws).map(|((x, rate), law)| law.force(x, rate)).sum();
                take(factor * sum / trial.weight_n, measured_n / trial.weight_n);
            }
        }
    }
}

/// x/R of the spheres, foot by foot and frame by frame; of none in frames in which the plates measured no force.
fn loaded_depths(trials: &[FitTrial], vector: &[f64]) -> impl Iterator<Item = impl Iterator<Item = f64>> {
    let moved = trials.iter().zip(&vector[FIRST_INDEX_OF_FLOORS..]);
    let feet = moved.flat_map(|(trial, up_m)| trial.feet.iter().map(move |foot| (foot, trial, *up_m)));
    let frames = feet.flat_map(move |(foot, trial, up_m)| {
        foot.loaded_spheres([up_m, vector[INDEX_OF_SPHERES_DOWN]], trial.weight_n)
    });
    frames.map(|spheres| spheres.map(|(x, radius_m)| x / radius_m))
}

/// The differences between model and plates for these unknowns.
fn errors_of_fit(trials: &[FitTrial], vector: &[f64]) -> FitErrors {
    let (mut square, mut count) = (0.0, 0.0_f64);
    visit_forces(trials, vector, |force, measured| {
        square += (force - measured).powi(2);
        count += 1.0;
    });
    FitErrors {
        vertical_rms_bw: (square / count.max(1.0)).sqrt(),
        largest_relative_indentation: loaded_depths(trials, vector)
            .flatten()
            .fold(f64::NEG_INFINITY, f64::max),
    }
}

/// The least-squares problem of fitting contacts to trials.
struct FitProblem<'t> {
    trials: &'t [FitTrial],
    bounds: FitBounds,
    /// The lowest and highest floor of each trial, m, if spheres stay.
    floors_m: Vec<(f64, f64)>,
    config: MPConfig,
    /// For each unknown its limits, and whether it is fixed.
    settings: Vec<MPPar>,
}

impl<'t> FitProblem<'t> {
    /// The problem of fitting `trials` within `bounds`.
    fn new(trials: &'t [FitTrial], bounds: &FitBounds) -> Result<Self, FitError> {
        let &FitBounds { stiffness, dissipation, height, spheres_move, .. } = bounds;
        let setting = |is_wanted: bool, (low, high): (f64, f64), step: f64| MPPar {
            fixed: !is_wanted,
            limited_low: is_wanted,
            limited_up: is_wanted,
            limit_low: low,
            limit_up: high,
            step,
            ..MPPar::new()
        };
        let limits = trials.iter().map(|trial| height_limits(trial, bounds));
        let floors_m = limits.collect::<Result<Vec<(f64, f64)>, FitError>>()?;
        let largest = LARGEST_STIFFNESS_FACTOR.ln();
        let shift = (-MOST_SHIFT_OF_SPHERES_M, MOST_SHIFT_OF_SPHERES_M);
        let mut settings = vec![
            setting(stiffness, (-largest, largest), 1e-6),
            setting(dissipation, (0.0, MOST_DISSIPATION_S_M), 1e-6),
            setting(spheres_move, shift, 1e-8),
        ];
        // If spheres move, the floor of the first trial stays.
        settings.extend(floors_m.iter().enumerate().map(|(trial, &limits)| match spheres_move {
            true => setting(trial > 0, shift, 1e-8),
            false => setting(height, limits, 1e-8),
        }));
        let config = MPConfig { ftol: 1e-12, xtol: 1e-10, gtol: 1e-12, max_iter: 100, ..MPConfig::new() };
        Ok(Self { trials, bounds: *bounds, floors_m, config, settings })
    }

    /// The problem with its best unknowns and their covariance.
    fn solve(trials: &'t [FitTrial], bounds: &FitBounds) -> Result<(Self, Vec<f64>, Vec<f64>), FitError> {
        let mut problem = Self::new(trials, bounds)?;
        let mut vector = problem.first_guess()?;
        let covariance = problem.reduce_differences(&mut vector).ok_or(FitError::NotConverged)?;
        Ok((problem, vector, covariance))
    }

    /// The first guess of a fit: the best of some heights of the floor and dissipations, each with its best stiffness.
    fn first_guess(&self) -> Result<Vec<f64>, FitError> {
        let FitBounds { stiffness, dissipation, height, spheres_move, .. } = self.bounds;
        let mut best: Option<(f64, Vec<f64>)> = None;
        for alpha in if dissipation { TRIED_DISSIPATIONS_S_M.to_vec() } else { vec![f64::NAN] } {
            for step in 0..if height { COUNT_OF_TRIED_HEIGHTS } else { 1 } {
                let part = (step as f64 + 0.5) / COUNT_OF_TRIED_HEIGHTS as f64;
                let up_m = |(low, high): &(f64, f64)| if height { low + part * (high - low) } else { 0.0 };
                let mut vector = vec![0.0, alpha, 0.0];
                vector.extend(self.floors_m.iter().map(up_m));
                let (mut model_squared, mut product, mut plates_squared) = (0.0, 0.0, 0.0);
                visit_forces(self.trials, &vector, |force, measured| {
                    model_squared += force * force;
                    product += force * measured;
                    plates_squared += measured * measured;
                });
                if !(model_squared > 0.0 && product > 0.0) {
                    continue;
                }
                if stiffness {
                    let largest = LARGEST_STIFFNESS_FACTOR.ln();
                    vector[INDEX_OF_STIFFNESS] = f64::ln(product / model_squared).clamp(-largest, largest);
                }
                let factor = vector[INDEX_OF_STIFFNESS].exp();
                let square = factor * factor * model_squared - 2.0 * factor * product + plates_squared;
                if best.as_ref().is_none_or(|(least, _)| square < *least) {
                    best = Some((square, vector));
                }
            }
        }
        let (_, mut vector) = best.ok_or(FitError::NoContact)?;
        if spheres_move {
            vector[INDEX_OF_SPHERES_DOWN] = vector[FIRST_INDEX_OF_FLOORS];
            let first_m = vector[FIRST_INDEX_OF_FLOORS];
            vector[FIRST_INDEX_OF_FLOORS..].iter_mut().for_each(|up_m| *up_m -= first_m);
        }
        Ok(vector)
    }

    /// Makes the differences small and returns the covariance of the unknowns; `None` if the search does not converge.
    fn reduce_differences(&mut self, vector: &mut [f64]) -> Option<Vec<f64>> {
        // The solver refuses a start beyond a limit.
        for (value, one) in vector.iter_mut().zip(&self.settings).filter(|(_, one)| !one.fixed) {
            *value = value.max(one.limit_low).min(one.limit_up);
        }
        if self.settings.iter().all(|one| one.fixed) {
            return Some(Vec::new());
        }
        let status = self.mpfit(vector).ok()?;
        (!matches!(status.success, MPSuccess::NotDone)).then_some(status.covar)
    }

    /// The differences between model and plates, divided by body weight. If spheres move and have a bound, the penalties for those that
    /// are too deep follow: how deep they go depends on the direction of their bodies.
    fn deviates(&self, vector: &[f64]) -> Vec<f64> {
        let mut deviates = Vec::new();
        visit_forces(self.trials, vector, |force, measured| deviates.push(force - measured));
        if let Some(most) = self.most_depth() {
            let excess = |depth: f64| (depth - most).max(0.0).powi(2);
            let penalties = loaded_depths(self.trials, vector)
                .map(|depths| PENALTY_BW_PER_RADIUS * depths.map(excess).sum::<f64>().sqrt());
            deviates.extend(penalties);
        }
        deviates
    }

    /// The bound of x/R, if spheres move, so that it has to be kept by a penalty.
    fn most_depth(&self) -> Option<f64> {
        self.bounds.most_relative_indentation.filter(|_| self.bounds.spheres_move)
    }

    /// The number of frames of all feet together.
    fn frames(&self) -> usize {
        self.trials.iter().flat_map(|trial| &trial.feet).map(|foot| foot.measured_n.len()).sum()
    }

    /// Root mean square of the differences between model and plates for these unknowns, body weights.
    fn rms_bw(&self, vector: &[f64]) -> f64 {
        let square: f64 = self.deviates(vector).iter().map(|one| one * one).sum();
        (square / self.frames().max(1) as f64).sqrt()
    }

    /// The range of one unknown of a fit in which the others can be fitted nearly as well as in the best fit.
    fn nearly_as_good(&mut self, best: &[f64], place: usize, step: f64) -> (f64, f64) {
        let rms_bw = self.rms_bw(best);
        let most_bw = (rms_bw * NEARLY_BEST_FACTOR).max(rms_bw + NEARLY_BEST_BW);
        let (low, high) = match &self.settings[place] {
            _ if place == INDEX_OF_STIFFNESS => (f64::NEG_INFINITY, f64::INFINITY),
            one => (one.limit_low, one.limit_up),
        };
        self.fix_unknown(place, true);
        let ends = [-step, step].map(|mut step| {
            let mut is_near = |at: f64| {
                let mut vector = best.to_vec();
                vector[place] = at.clamp(low, high);
                self.reduce_differences(&mut vector).is_some() && self.rms_bw(&vector) <= most_bw
            };
            let mut inside = best[place];
            for _ in 0..MOST_DOUBLINGS {
                if !is_near(inside + step) {
                    break;
                }
                inside += step;
                step *= 2.0;
            }
            for _ in 0..MOST_HALVINGS {
                step /= 2.0;
                if is_near(inside + step) {
                    inside += step;
                }
            }
            inside.clamp(low, high)
        });
        self.fix_unknown(place, false);
        ends.into()
    }

    /// Fixes an unknown of the fit at its value, or lets it vary again.
    fn fix_unknown(&mut self, place: usize, is_fixed: bool) {
        let one = &mut self.settings[place];
        (one.fixed, one.limited_low, one.limited_up) = (is_fixed, !is_fixed, !is_fixed);
    }
}

/// The limits of a floor's height: at least one sphere touches it, and no sphere is deeper than allowed.
fn height_limits(trial: &FitTrial, bounds: &FitBounds) -> Result<(f64, f64), FitError> {
    let (mut least_m, mut most_m) = (f64::INFINITY, f64::INFINITY);
    for (x, radius_m) in
        trial.feet.iter().flat_map(|foot| foot.loaded_spheres([0.0; 2], trial.weight_n)).flatten()
    {
        // This sphere just touches if the floor goes up by -x.
        least_m = least_m.min(-x);
        if let Some(most) = bounds.most_relative_indentation {
            most_m = most_m.min(most * radius_m - x);
        }
    }
    if least_m.is_infinite() {
        return Err(FitError::NoForce);
    }
    let most_m = if most_m.is_finite() { most_m } else { least_m + MOST_RISE_WITHOUT_BOUND_M };
    Ok((least_m.min(most_m - 1e-6), most_m))
}

/// Fits the unknowns to all `trials` together, and then again without the stiffness or dissipation that they do not determine.
///
/// # Errors
/// Nothing to fit, or no fit.
pub fn fit_motion(trials: &[FitTrial], bounds: &FitBounds) -> Result<MotionFit, FitError> {
    let mut fit = fit_all_unknowns(trials, bounds)?;
    let undetermined = [&mut fit.stiffness_factor, &mut fit.dissipation];
    let undetermined = undetermined.into_iter().filter_map(|one| one.take_if(|one| !one.is_written));
    let undetermined: Vec<FittedParameter> = undetermined.collect();
    if undetermined.is_empty() {
        return Ok(MotionFit { held_out: test_on_held_out(trials, bounds), ..fit });
    }
    let (stiffness, dissipation) = (fit.stiffness_factor.is_some(), fit.dissipation.is_some());
    if !(stiffness || dissipation || bounds.height) {
        return Err(FitError::Undetermined(undetermined));
    }
    let mut again = fit_motion(trials, &FitBounds { stiffness, dissipation, ..*bounds })?;
    let of_left_out =
        |(pair, _): &([String; 2], f64)| undetermined.iter().any(|one| pair.contains(&one.name));
    again.correlations.extend(fit.correlations.into_iter().filter(of_left_out));
    again.undetermined.extend(undetermined);
    Ok(again)
}

/// The name of the unknown at a place, with its unit.
fn name_of_unknown(place: usize) -> String {
    match place {
        INDEX_OF_STIFFNESS => "stiffness_factor".to_owned(),
        INDEX_OF_DISSIPATION => "dissipation_s_m".to_owned(),
        INDEX_OF_SPHERES_DOWN => "spheres_down_m".to_owned(),
        FIRST_INDEX_OF_FLOORS => "floor_up_m".to_owned(),
        _ => format!("floor_{}_up_m", place + 1 - FIRST_INDEX_OF_FLOORS),
    }
}

/// Fits all unknowns of these bounds, and tests nothing on data that were held out.
fn fit_all_unknowns(trials: &[FitTrial], bounds: &FitBounds) -> Result<MotionFit, FitError> {
    let (problem, best, covariance) = FitProblem::solve(trials, bounds)?;
    let thin = |foot: &FootForces| {
        let frames = foot.measured_n.len();
        foot.in_frames((0..frames).step_by(frames.div_ceil(MOST_FRAMES_PER_FOOT).max(1)))
    };
    let thin_trial = |trial: &FitTrial| trial.with_feet(trial.feet.iter().map(thin).collect());
    let thinned: Vec<FitTrial> = trials.iter().map(thin_trial).collect();
    let mut thinned = FitProblem { trials: &thinned, ..FitProblem::new(trials, bounds)? };
    let mut parameter = |place: usize, step: f64, map: fn(f64) -> f64| {
        let (value, one) = (best[place], &problem.settings[place]);
        let near = 1e-6 * (one.limit_up - one.limit_low);
        (!one.fixed).then(|| {
            let (low, high) = thinned.nearly_as_good(&best, place, step);
            let at_bound = value - one.limit_low <= near || one.limit_up - value <= near;
            let (value, low, high) = (map(value), map(low), map(high));
            let is_written = match place {
                INDEX_OF_STIFFNESS => !at_bound && high <= WIDE_STIFFNESS_RATIO * low,
                INDEX_OF_DISSIPATION => !at_bound && high - low <= WIDE_DISSIPATION_S_M,
                _ => place <= FIRST_INDEX_OF_FLOORS,
            };
            let name = name_of_unknown(place);
            FittedParameter { name, value, nearly_as_good: (low, high), at_bound, is_written }
        })
    };
    let same = |value: f64| value;
    let fitted: Vec<usize> = (0..best.len()).filter(|&place| !problem.settings[place].fixed).collect();
    let correlation = |(i, j): (usize, usize)| {
        let covariance = |i: usize, j: usize| covariance[i * best.len() + j];
        let value = covariance(i, j) / (covariance(i, i) * covariance(j, j)).sqrt();
        ([i, j].map(name_of_unknown), value)
    };
    let pairs = fitted.iter().enumerate();
    let pairs = pairs.flat_map(|(rank, &i)| fitted[rank + 1..].iter().map(move |&j| (i, j)));
    let rms_of_trial = |(number, trial): (usize, &FitTrial)| {
        let vector = [&best[..FIRST_INDEX_OF_FLOORS], &best[FIRST_INDEX_OF_FLOORS + number..]].concat();
        errors_of_fit(std::slice::from_ref(trial), &vector).vertical_rms_bw
    };
    let mut unchanged = vec![0.0; best.len()];
    unchanged[INDEX_OF_DISSIPATION] = f64::NAN;
    Ok(MotionFit {
        stiffness_factor: parameter(INDEX_OF_STIFFNESS, 1.0, f64::exp),
        dissipation: parameter(INDEX_OF_DISSIPATION, 0.5, same),
        spheres_down_m: parameter(INDEX_OF_SPHERES_DOWN, HEIGHT_STEP_M, same),
        floor_up_m: (FIRST_INDEX_OF_FLOORS..best.len())
            .filter_map(|place| parameter(place, HEIGHT_STEP_M, same))
            .collect(),
        undetermined: Vec::new(),
        correlations: pairs.map(correlation).collect(),
        before: errors_of_fit(trials, &unchanged),
        after: errors_of_fit(trials, &best),
        trials_rms_bw: trials.iter().enumerate().map(rms_of_trial).collect(),
        held_out: Vec::new(),
        beside: trials.iter().map(|trial| trial.beside).sum(),
    })
}

/// Fits each foot and tests the fit on the others; with only one foot, fits each half of the data and tests the fit on the other
/// half.
fn test_on_held_out(trials: &[FitTrial], bounds: &FitBounds) -> Vec<HeldOut> {
    let feet = trials.iter().map(|trial| trial.feet.len()).min().unwrap_or(0);
    let names = |part: &[FitTrial], half: &str| match part {
        [first, ..] if feet > 1 => {
            first.feet.iter().map(|foot| foot.name.as_str()).collect::<Vec<&str>>().join(" and the ")
        }
        _ => format!("{half} half"),
    };
    let part = |number: usize, is_fitted: bool| -> Vec<FitTrial> {
        let one = |(index, foot): (usize, &FootForces)| {
            let (frames, middle) = (foot.measured_n.len(), foot.measured_n.len() / 2);
            match feet > 1 {
                true => ((index == number) == is_fitted).then(|| foot.clone()),
                false if (number == 0) == is_fitted => Some(foot.in_frames(0..middle)),
                false => Some(foot.in_frames(middle..frames)),
            }
        };
        let each = trials.iter();
        each.map(|trial| trial.with_feet(trial.feet.iter().enumerate().filter_map(one).collect())).collect()
    };
    let halves = ["first", "second"];
    let test = |number: usize| {
        let (fitted, tested) = (part(number, true), part(number, false));
        // Every fit passes a test on a foot in the air.
        let has_force = |trial: &FitTrial| trial.feet.iter().any(|foot| foot.has_force(trial.weight_n));
        let (_, best, _) =
            FitProblem::solve(&fitted, bounds).ok().filter(|_| tested.iter().any(has_force))?;
        Some(HeldOut {
            fitted: names(&fitted, halves[number % 2]),
            tested: names(&tested, halves[1 - number % 2]),
            vertical_rms_bw: errors_of_fit(&tested, &best).vertical_rms_bw,
        })
    };
    (0..feet.max(2)).filter_map(test).collect()
}

impl MPFitter for FitProblem<'_> {
    fn eval(&mut self, vector: &[f64], deviates: &mut [f64]) -> MPResult<()> {
        deviates.copy_from_slice(&self.deviates(vector));
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.frames() * if self.most_depth().is_some() { 2 } else { 1 }
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.settings
    }
}

#[cfg(test)]
mod tests {
    use contact_scaling::{Contact, ContactValues};

    use super::*;

    /// One sphere in two frames, whose force is that of depths of 4 and 9 mm. By F = f k d^(3/2) the derivatives by ln f are as 8 to 27,
    /// those by the height as 2 to 3, so the correlation is -(8·2 + 27·3)/√((8² + 27²)(2² + 3²)) = -97/√(793·13). As strong as it is,
    /// both parameters are determined within some per cent.
    #[test]
    fn a_correlation_is_that_of_the_derivatives() {
        let values = ContactValues { plane_strain_modulus: 1e6, dissipation: 0.0, smoothing: None };
        let law = Law::of(&Contact::new(values).unwrap(), 0.03).unwrap();
        let foot = FootForces {
            name: "foot".to_owned(),
            spheres: Vec::new(),
            laws: vec![(law, 0.03)],
            measured_n: [0.004, 0.009].map(|depth_m| 2.0 * law.rest_force(depth_m)).to_vec(),
            contacts: [0.002, 0.007].map(|depth_m| [(depth_m, 0.0), (0.0, 0.0)]).to_vec(),
        };
        let weight_n = foot.measured_n[1];
        let (without_force, down) = (Vec::new(), Vec::new());
        let trial = FitTrial { feet: vec![foot], weight_n, beside: 0, without_force, down };
        let bounds = FitBounds {
            stiffness: true,
            dissipation: false,
            height: true,
            spheres_move: false,
            most_relative_indentation: Some(1.0),
        };
        let fit = fit_motion(&[trial], &bounds).unwrap();
        let factor = fit.stiffness_factor.unwrap();
        assert!((factor.value - 2.0).abs() < 1e-6 && factor.nearly_as_good.0 > 1.9, "{factor:?}");
        assert!((fit.floor_up_m[0].value - 0.002).abs() < 1e-8, "{:?}", fit.floor_up_m);
        let (names, correlation) = &fit.correlations[0];
        assert_eq!(*names, ["stiffness_factor", "floor_up_m"]);
        assert!((correlation + 97.0 / (793.0 * 13.0_f64).sqrt()).abs() < 1e-5, "{correlation}");
    }
}
