//! The result of a fit of contacts to recordings: fitted parameters with their ranges, and errors before and after.

/// Why contacts cannot be fitted to recordings.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    #[error("the plates measured no force under a foot during the recording: there is nothing to fit to")]
    NoForce,
    #[error("no height of the floor within the bounds gives the feet a force like the plates'")]
    NoContact,
    #[error("the search did not converge")]
    NotConverged,
    /// What was left out last, after which nothing is left to fit.
    #[error("the recordings determine nothing of what was to be fitted")]
    Undetermined(Vec<FittedParameter>),
}

/// A parameter of contacts that was fitted to recordings, with the range in which a fit is nearly as good.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedParameter {
    /// The name for scripts, with the unit: `stiffness_factor`, `dissipation_s_m`, `spheres_down_m`, `floor_up_m`, and for the second
    /// trial `floor_2_up_m`.
    pub name: String,
    pub value: f64,
    /// The lowest and highest value at which a fit of the other parameters is nearly as good (rms within 5 %, or 0.005 body
    /// weights).
    pub nearly_as_good: (f64, f64),
    pub at_bound: bool,
    /// Whether a model gets the value: the recordings determine it, and it is not the floor of a further trial.
    pub is_written: bool,
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
#[derive(Debug, Clone, PartialEq)]
pub struct MotionFit {
    /// The factor of all stiffnesses; `None` if it was not fitted, or is not determined.
    pub stiffness_factor: Option<FittedParameter>,
    /// The dissipation, s/m; `None` if it was not fitted, or is not determined.
    pub dissipation: Option<FittedParameter>,
    /// The distance by which all spheres move down in their bodies, m; `None` if it was not fitted.
    pub spheres_down_m: Option<FittedParameter>,
    /// The distance by which the floor moves up in each trial, m, without the first if spheres move; empty if no height was fitted.
    pub floor_up_m: Vec<FittedParameter>,
    /// What was fitted first, but not written and not fitted again, because the recordings do not determine it.
    pub undetermined: Vec<FittedParameter>,
    /// The names of each two fitted parameters with their correlation, which is not a number if one is at its bound.
    pub correlations: Vec<([String; 2], f64)>,
    pub before: FitErrors,
    pub after: FitErrors,
    /// The root mean square error of each trial, in body weights.
    pub trials_rms_bw: Vec<f64>,
    /// Fits of one part of the data, tested on the other part: one foot against the others, or one half against the other.
    pub held_out: Vec<HeldOut>,
    /// The number of frames that were left out because a foot probably stands beside the plates.
    pub beside: usize,
}
