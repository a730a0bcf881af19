//! The steps from compliant contacts to those that are wanted (section 4.3 of the paper).

use contact_scaling::continuation;

use super::failure::Failure;

/// A column for each figure of the steps.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Ladder {
    /// k̂ at the load of the last step, without unit (B.3).
    pub dimensionless_stiffness: Vec<f64>,
    /// What E* of the last step is multiplied by.
    pub modulus_factor: Vec<f64>,
    /// What α of the last step is multiplied by.
    pub dissipation_factor: Vec<f64>,
}

/// `count` steps from k̂ = `first` to k̂ = `last`, with α from `dissipation_ratio` times its last value to that value.
///
/// # Errors
/// As [`continuation::steps`].
pub(crate) fn continuation_steps(
    first: f64,
    last: f64,
    dissipation_ratio: f64,
    count: u32,
) -> Result<Ladder, Failure> {
    let mut ladder = Ladder::default();
    for step in continuation::steps(first, last, dissipation_ratio, count)? {
        ladder.dimensionless_stiffness.push(step.dimensionless_stiffness);
        ladder.modulus_factor.push(step.modulus_factor);
        ladder.dissipation_factor.push(step.dissipation_factor);
    }
    Ok(ladder)
}
