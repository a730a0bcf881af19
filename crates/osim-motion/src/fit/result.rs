//! What a fit gives.

/// One fitted number.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FittedParameter {
    /// Its value.
    pub value: f64,
    /// Its standard error, with what neighbouring frames have in common taken into account; NaN where nothing is left over.
    pub standard_error: f64,
    /// The lowest and the highest value with which the rest can be fitted nearly as well (rms within 5 %, or 0.005 body weights).
    pub nearly_as_good: (f64, f64),
    /// Whether it is at a bound.
    pub at_bound: bool,
}

/// How far the forces of a fit are from the plates.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[non_exhaustive]
pub struct FitErrors {
    /// Root mean square per foot along the normal, body weights.
    pub vertical_rms_bw: f64,
    /// The largest x/R in frames in which the plates measured a force.
    pub largest_relative_indentation: f64,
}

/// A fit of a part, tried on the rest.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct HeldOut {
    /// What was fitted, in words.
    pub fitted: String,
    /// What was not.
    pub tested: String,
    /// Its errors, body weights.
    pub vertical_rms_bw: f64,
}

/// Contact parameters that make the forces of a model those of the plates.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct MotionFit {
    /// What all stiffnesses are multiplied by; `None` where they stay.
    pub stiffness_factor: Option<FittedParameter>,
    /// The dissipation, s/m; `None` where it stays.
    pub dissipation: Option<FittedParameter>,
    /// How far the floor moves up in each trial, m; empty where it stays.
    pub floor_up_m: Vec<FittedParameter>,
    /// How far all spheres go down in their bodies, where the height is in them and not in the floor, m.
    pub spheres_down_m: Option<FittedParameter>,
    /// Correlation of stiffness and height of the first trial, where both were fitted.
    pub stiffness_height_correlation: Option<f64>,
    /// Errors before.
    pub before: FitErrors,
    /// Errors after.
    pub after: FitErrors,
    /// The error of each trial, with a floor of its own where the height is fitted, body weights.
    pub trials_rms_bw: Vec<f64>,
    /// One part fitted, the other tested: foot by foot, or half by half.
    pub held_out: Vec<HeldOut>,
    /// Frames that were left out, because a foot seems to stand beside the plates.
    pub beside: usize,
    /// Frames of all feet that were fitted.
    pub frames: usize,
}

impl MotionFit {
    /// The worst of the errors on what was not fitted, body weights.
    #[must_use]
    pub fn held_out_rms_bw(&self) -> Option<f64> {
        self.held_out.iter().map(|one| one.vertical_rms_bw).reduce(f64::max)
    }
}
