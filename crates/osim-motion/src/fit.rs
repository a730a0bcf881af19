//! Fits contact parameters and the height of the floor, so that the forces of a model are like those that plates measured.
//!
//! The unknowns are a factor for all stiffnesses, the dissipation, and for each trial the distance by which the floor moves up. The fit
//! makes the differences between model and plates small: in the force along the normal of each foot, divided by body weight. The search
//! tries some heights, each with its best stiffness, and then runs Levenberg–Marquardt from the best of them.

use contact_scaling::Law;
use rmpfit::{MPConfig, MPFitter, MPPar, MPResult, MPSuccess};

use crate::{ContactStates, Foot, MeasuredForces, ON_BW, Wrench};

/// The data of one trial for a fit: the contacts of each foot in the frames in which the plates measured the force under it.
#[derive(Debug, Clone, PartialEq)]
pub struct FitTrial {
    pub feet: Vec<FootForces>,
    pub weight_n: f64,
    /// The number of frames that were left out because a foot probably stands beside the plates.
    pub beside: usize,
    /// Names of feet that are left out because the plates measured no force under them.
    pub without_force: Vec<String>,
}

/// The contacts of one foot, and the force that plates measured under it.
#[derive(Debug, Clone, PartialEq)]
pub struct FootForces {
    pub name: String,
    /// The contact law and the radius (m) of each sphere of the foot.
    pub laws: Vec<(Law, f64)>,
    /// The measured force along the normal in each frame, N.
    pub measured_n: Vec<f64>,
    /// Indentation (m) and its rate (m/s) of each sphere, frame by frame.
    pub contacts: Vec<(f64, f64)>,
}

impl FitTrial {
    /// The data of a trial in the frames in which the force under a foot is known.
    pub fn of(states: &ContactStates, feet: &[Foot], measured: &MeasuredForces, weight_n: f64) -> Self {
        let one = |(foot, plates): (&Foot, &Vec<Option<Wrench>>)| FootForces::of(states, foot, plates);
        let feet = feet.iter().zip(&measured.feet).map(one);
        let has_force = |foot: &FootForces| foot.measured_n.iter().any(|&force_n| force_n > ON_BW * weight_n);
        // A foot without a measured force cannot be fitted.
        let (feet, others): (Vec<_>, Vec<_>) = feet.partition(has_force);
        let without_force = others.into_iter().map(|foot| foot.name).collect();
        Self { feet, weight_n, beside: measured.beside.iter().sum(), without_force }
    }
}

impl FootForces {
    /// The forces of `foot` in the frames in which its measured force is known.
    fn of(states: &ContactStates, foot: &Foot, plates: &[Option<Wrench>]) -> Self {
        let laws = foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair));
        let laws = laws.map(|pair| (pair.law, pair.radius_m)).collect();
        let (mut measured_n, mut contacts) = (Vec::new(), Vec::new());
        for (frame, plate) in plates.iter().enumerate() {
            let own = || foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair));
            let Some((plate, first)) = plate.as_ref().zip(own().next()) else { continue };
            measured_n.push(plate.force_n.dot(first.normal));
            contacts.extend(own().map(|state| (state.indentation_m, state.rate_m_s)));
        }
        Self { name: foot.name.clone(), laws, measured_n, contacts }
    }

    /// Each frame with its measured force, N, and its contacts.
    fn frames(&self) -> impl Iterator<Item = (f64, &[(f64, f64)])> {
        self.measured_n.iter().copied().zip(self.contacts.chunks(self.laws.len().max(1)))
    }
}

/// What is fitted, and its bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitBounds {
    pub stiffness: bool,
    pub dissipation: bool,
    /// The height of the floor, in each trial by its own distance.
    pub height: bool,
    /// The largest allowed x/R in frames with a force; `None` for no bound.
    pub most_relative_indentation: Option<f64>,
}

#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    #[error("the plates measured no force under a foot during the recording: there is nothing to fit to")]
    NoForce,
    #[error("no height of the floor within the bounds gives the feet a force like the plates'")]
    NoContact,
    #[error("the search did not converge")]
    NotConverged,
}

/// A fitted number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedParameter {
    pub value: f64,
    /// Two standard errors below and above the value; neighbouring frames, which are alike, count as fewer.
    pub range: (f64, f64),
}

/// The differences between the fitted forces and the forces of the plates.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FitErrors {
    /// Root mean square of the difference along the normal, over all feet, in body weights.
    pub vertical_rms_bw: f64,
    /// The largest x/R of a sphere in frames in which the plates measured a force.
    pub largest_relative_indentation: f64,
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
    /// Correlation of the stiffness and the height of the first trial, if both were fitted.
    pub stiffness_height_correlation: Option<f64>,
    pub before: FitErrors,
    pub after: FitErrors,
    /// The root mean square error of each trial, in body weights.
    pub trials_rms_bw: Vec<f64>,
    /// The number of frames that were left out because a foot probably stands beside the plates.
    pub beside: usize,
}

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

/// The places of the unknowns: the logarithm of the stiffness factor, the dissipation, and then a height for each trial.
const STIFFNESS: usize = 0;
const DISSIPATION: usize = 1;
const HEIGHTS: usize = 2;

struct FitProblem<'t> {
    trials: &'t [FitTrial],
    /// Whether all spheres have the fitted dissipation instead of their own.
    one_dissipation: bool,
    config: MPConfig,
    /// For each unknown its limits, and whether it is fixed.
    settings: Vec<MPPar>,
}

impl<'t> FitProblem<'t> {
    fn new(trials: &'t [FitTrial], bounds: &FitBounds) -> Result<Self, FitError> {
        let &FitBounds { stiffness, dissipation, height, .. } = bounds;
        let setting = |is_wanted: bool, (low, high): (f64, f64), step: f64| MPPar {
            fixed: !is_wanted,
            limited_low: true,
            limited_up: true,
            limit_low: low,
            limit_up: high,
            step,
            ..MPPar::new()
        };
        let largest = LARGEST_STIFFNESS_FACTOR.ln();
        let mut settings = vec![
            setting(stiffness, (-largest, largest), 1e-6),
            setting(dissipation, (0.0, MOST_DISSIPATION_S_M), 1e-6),
        ];
        for trial in trials {
            // A fixed floor stays where it is, whatever would be allowed.
            let limits = if height { height_limits(trial, bounds)? } else { (-1.0, 1.0) };
            settings.push(setting(height, limits, 1e-8));
        }
        let config = MPConfig { ftol: 1e-12, xtol: 1e-10, gtol: 1e-12, max_iter: 100, ..MPConfig::new() };
        Ok(Self { trials, one_dissipation: dissipation, config, settings })
    }

    /// Calls `take` with trial, foot, contact force and measured force (body weights) of each frame, for these unknowns.
    fn forces(&self, vector: &[f64], mut take: impl FnMut(usize, f64, f64)) {
        for (number, trial) in self.trials.iter().enumerate() {
            let (factor, up_m) = (vector[STIFFNESS].exp(), vector[HEIGHTS + number]);
            for foot in &trial.feet {
                let other = |law: &Law| {
                    law.with_dissipation(vector[DISSIPATION]).ok().filter(|_| self.one_dissipation)
                };
                let laws: Vec<Law> = foot.laws.iter().map(|(law, _)| other(law).unwrap_or(*law)).collect();
                for (measured_n, contacts) in foot.frames() {
                    let each = contacts.iter().zip(&laws);
                    let sum: f64 = each.map(|((x, rate), law)| law.force(x + up_m, *rate)).sum();
                    take(number, factor * sum / trial.weight_n, measured_n / trial.weight_n);
                }
            }
        }
    }

    /// The errors for these unknowns, and the error of each trial.
    fn errors(&self, vector: &[f64]) -> (FitErrors, Vec<f64>) {
        let mut sums = vec![(0.0, 0.0); self.trials.len()];
        self.forces(vector, |trial, force, measured| {
            sums[trial].0 += (force - measured).powi(2);
            sums[trial].1 += 1.0;
        });
        let rms = |square: f64, count: f64| (square / count.max(1.0)).sqrt();
        let mut deepest = f64::NEG_INFINITY;
        for (trial, up_m) in self.trials.iter().zip(&vector[HEIGHTS..]) {
            for_loaded(trial, |x, radius_m| deepest = deepest.max((x + up_m) / radius_m));
        }
        let (square, count) = sums.iter().fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
        let errors = FitErrors { vertical_rms_bw: rms(square, count), largest_relative_indentation: deepest };
        (errors, sums.into_iter().map(|(square, count)| rms(square, count)).collect())
    }

    /// The best of some heights and dissipations, each with its best stiffness.
    fn first_guess(&self) -> Result<Vec<f64>, FitError> {
        let (stiffness, dissipation, heights) =
            (&self.settings[STIFFNESS], &self.settings[DISSIPATION], &self.settings[HEIGHTS..]);
        let tries_heights = heights.iter().any(|one| !one.fixed);
        let mut best: Option<(f64, Vec<f64>)> = None;
        for alpha in if dissipation.fixed { vec![0.0] } else { DISSIPATIONS.to_vec() } {
            for step in 0..if tries_heights { FIRST_HEIGHTS } else { 1 } {
                let part = (step as f64 + 0.5) / FIRST_HEIGHTS as f64;
                let height = |one: &MPPar| {
                    if one.fixed { 0.0 } else { one.limit_low + part * (one.limit_up - one.limit_low) }
                };
                let mut vector: Vec<f64> =
                    [0.0, alpha].into_iter().chain(heights.iter().map(height)).collect();
                let (mut model_squared, mut product, mut plates_squared) = (0.0, 0.0, 0.0);
                self.forces(&vector, |_, force, measured| {
                    model_squared += force * force;
                    product += force * measured;
                    plates_squared += measured * measured;
                });
                if !(model_squared > 0.0 && product > 0.0) {
                    continue;
                }
                if !stiffness.fixed {
                    let best = f64::ln(product / model_squared);
                    vector[STIFFNESS] = best.clamp(stiffness.limit_low, stiffness.limit_up);
                }
                let factor = vector[STIFFNESS].exp();
                let square = factor * factor * model_squared - 2.0 * factor * product + plates_squared;
                if best.as_ref().is_none_or(|(least, _)| square < *least) {
                    best = Some((square, vector));
                }
            }
        }
        best.map(|(_, vector)| vector).ok_or(FitError::NoContact)
    }
}

/// Calls `take` with indentation and radius (m) of each sphere in the frames in which the plates measured a force.
fn for_loaded(trial: &FitTrial, mut take: impl FnMut(f64, f64)) {
    for foot in &trial.feet {
        for (_, contacts) in foot.frames().filter(|(measured_n, _)| *measured_n > ON_BW * trial.weight_n) {
            contacts.iter().zip(&foot.laws).for_each(|(&(x, _), &(_, radius_m))| take(x, radius_m));
        }
    }
}

/// The limits of a floor's height: at least one sphere touches it, and no sphere is deeper than allowed.
fn height_limits(trial: &FitTrial, bounds: &FitBounds) -> Result<(f64, f64), FitError> {
    let (mut least_m, mut most_m) = (f64::INFINITY, f64::INFINITY);
    for_loaded(trial, |x, radius_m| {
        // This sphere just touches if the floor goes up by -x.
        least_m = least_m.min(-x);
        if let Some(most) = bounds.most_relative_indentation {
            most_m = most_m.min(most * radius_m - x);
        }
    });
    if least_m.is_infinite() {
        return Err(FitError::NoForce);
    }
    let most_m = if most_m.is_finite() { most_m } else { least_m + MOST_RISE_WITHOUT_BOUND_M };
    Ok((least_m.min(most_m - 1e-6), most_m))
}

/// The effective number of independent differences: fewer than frames, because differences of neighbouring frames are correlated.
fn independent_count(deviates: &[f64]) -> f64 {
    let square: f64 = deviates.iter().map(|one| one * one).sum();
    let shifted: f64 = deviates.windows(2).filter_map(|pair| Some(pair.first()? * pair.get(1)?)).sum();
    let alike = if square > 0.0 { (shifted / square).clamp(0.0, 0.999) } else { 0.0 };
    deviates.len() as f64 * (1.0 - alike) / (1.0 + alike)
}

/// Fits the unknowns to all `trials` together.
///
/// # Errors
/// Nothing to fit, or no fit.
pub fn fit_motion(trials: &[FitTrial], bounds: &FitBounds) -> Result<MotionFit, FitError> {
    let &FitBounds { stiffness, dissipation, height, .. } = bounds;
    if trials.iter().all(|trial| trial.feet.is_empty()) {
        return Err(FitError::NoForce);
    }
    let mut problem = FitProblem::new(trials, bounds)?;
    let mut vector = problem.first_guess()?;
    // The solver refuses a start beyond a limit.
    for (value, one) in vector.iter_mut().zip(&problem.settings) {
        *value = value.max(one.limit_low).min(one.limit_up);
    }
    let status = problem.mpfit(&mut vector).map_err(|_| FitError::NotConverged)?;
    if matches!(status.success, MPSuccess::NotDone) {
        return Err(FitError::NotConverged);
    }
    let mut deviates = vec![0.0; problem.number_of_points()];
    drop(problem.eval(&vector, &mut deviates));
    let square: f64 = deviates.iter().map(|one| one * one).sum();
    let fitted = problem.settings.iter().filter(|one| !one.fixed).count();
    // The covariance of mpfit assumes deviates with a variance of 1.
    let scale = square / (independent_count(&deviates) - fitted as f64).max(1.0);
    let covariance = |i: usize, j: usize| status.covar.get(i * vector.len() + j).copied().unwrap_or(f64::NAN);
    let parameter = |place: usize, map: fn(f64) -> f64| {
        let (value, one) = (vector[place], &problem.settings[place]);
        let error = 2.0 * (scale * covariance(place, place)).sqrt();
        FittedParameter {
            value: map(value),
            range: (map((value - error).max(one.limit_low)), map((value + error).min(one.limit_up))),
        }
    };
    let same = |value: f64| value;
    let correlation = covariance(STIFFNESS, HEIGHTS)
        / (covariance(STIFFNESS, STIFFNESS) * covariance(HEIGHTS, HEIGHTS)).sqrt();
    let (after, trials_rms_bw) = problem.errors(&vector);
    let unchanged = FitProblem { one_dissipation: false, ..FitProblem::new(trials, bounds)? };
    Ok(MotionFit {
        stiffness_factor: stiffness.then(|| parameter(STIFFNESS, f64::exp)),
        dissipation: dissipation.then(|| parameter(DISSIPATION, same)),
        floor_up_m: (HEIGHTS..vector.len()).filter(|_| height).map(|place| parameter(place, same)).collect(),
        stiffness_height_correlation: (stiffness && height).then_some(correlation),
        before: unchanged.errors(&vec![0.0; vector.len()]).0,
        after,
        trials_rms_bw,
        beside: trials.iter().map(|trial| trial.beside).sum(),
    })
}

impl MPFitter for FitProblem<'_> {
    fn eval(&mut self, vector: &[f64], deviates: &mut [f64]) -> MPResult<()> {
        let mut places = deviates.iter_mut();
        self.forces(vector, |_, force, measured| {
            places.by_ref().take(1).for_each(|place| *place = force - measured);
        });
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.trials.iter().flat_map(|trial| &trial.feet).map(|foot| foot.measured_n.len()).sum()
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.settings
    }
}
