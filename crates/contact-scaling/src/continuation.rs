//! Series from compliant to stiff contacts, for the search of gaits by optimisation: the paper's advice in section 4.3.
//!
//! With stiff contacts an optimisation fails more often, and compliant contacts are not realistic. So the gait is first searched
//! with compliant contacts. Then E* is raised and α lowered step by step; each solution is the initial guess for the next
//! optimisation.

use crate::error::{Result, require_positive, require_range};

/// The contact for one optimisation of a series, as factors of the final contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// Dimensionless stiffness k̂ under the load, without unit (B.3).
    pub dimensionless_stiffness: f64,
    /// E* of this step divided by E* of the last step, without unit.
    pub modulus_factor: f64,
    /// α of this step divided by α of the last step, without unit.
    pub dissipation_factor: f64,
}

/// The largest number of steps in a series. Each step is an optimisation, so nobody needs more; and the memory of any computer
/// holds this number.
pub const MOST_STEPS: u32 = 100_000;

/// The smallest k̂ of a step: x̂ is 2, so that a sphere lies wholly in the floor.
const SOFTEST: f64 = 0.75;

/// Ratio of the composite moduli that belong to two dimensionless stiffnesses at one load,
/// E*_a / E*_b = (k̂_a / k̂_b)^(3/2), without unit.
///
/// k̂ without unit. At one load (11) gives E* ∝ x̂^(−3/2), and (B.3) under the Hertz law k̂ = 3/(2 x̂).
///
/// Source: (11), (B.3).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both are finite and above 0.
///
/// ```
/// # use contact_scaling::continuation::modulus_ratio;
/// // From k̂ = 1.2, the softest contacts of the paper's Fig. 1(C), to 1.5/0.16: E* rises about 22 times.
/// assert!((1.0 / modulus_ratio(1.2, 9.375)? - 21.8366).abs() < 5e-4);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn modulus_ratio(stiffness_a: f64, stiffness_b: f64) -> Result<f64> {
    let a = require_positive("dimensionless stiffness", stiffness_a)?;
    let ratio = a / require_positive("dimensionless stiffness", stiffness_b)?;
    Ok(ratio * ratio.sqrt())
}

/// A series of `count` steps from k̂ = `first` to k̂ = `last`, at equal distances of log k̂. In the same way, α falls from
/// `dissipation_ratio` times its final value to its final value.
///
/// The modulus factor of a step is the [`modulus_ratio`] of its k̂ and `last`. k̂ and the factors are without unit. The factors
/// of the last step are exactly 1. The series is the advice of the paper's section 4.3; the equal distances are a choice of this
/// crate.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless 0.75 ≤ `first` < `last`, `dissipation_ratio` ≥ 1, all finite, and 2 ≤ `count` ≤ [`MOST_STEPS`].
///
/// ```
/// use contact_scaling::continuation::steps;
/// let steps = steps(1.2, 9.375, 8.0, 3)?; // to 1.5/0.16, with α from 8 times its last value
/// assert!((steps[0].modulus_factor - 0.0457947).abs() < 5e-8); // 0.128^1.5
/// assert!((steps[1].dissipation_factor - 8f64.sqrt()).abs() < 1e-14);
/// assert_eq!(steps[2].modulus_factor, 1.0);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn steps(first: f64, last: f64, dissipation_ratio: f64, count: u32) -> Result<Vec<Step>> {
    let last = require_positive("dimensionless stiffness of the last step", last)?;
    let (name, wanted) =
        ("dimensionless stiffness of the first step", "0.75 or more, and less than the last");
    require_range((SOFTEST..last).contains(&first), name, first, wanted)?;
    let ratio = require_positive("ratio of the dissipations", dissipation_ratio)?;
    require_range(ratio >= 1.0, "ratio of the dissipations", ratio, "1 or more")?;
    require_range((2..=MOST_STEPS).contains(&count), "number of steps", f64::from(count), "2 to 100000")?;
    let step = |index: u32| -> Result<Step> {
        if index + 1 == count {
            return Ok(Step { dimensionless_stiffness: last, modulus_factor: 1.0, dissipation_factor: 1.0 });
        }
        // The part of the way that is still to go: 1 at the first step.
        let remaining = f64::from(count - 1 - index) / f64::from(count - 1);
        let relative = libm::pow(first / last, remaining);
        Ok(Step {
            dimensionless_stiffness: last * relative,
            modulus_factor: modulus_ratio(relative, 1.0)?,
            dissipation_factor: libm::pow(ratio, remaining),
        })
    };
    (0..count).map(step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_equally_far_apart_and_end_exactly() {
        // mpmath 1.3.0, 50 digits: (1.2/9.375)^(j/4) and ^(3j/8) for j = 4, 3, 2, 1.
        let expected = [
            (1.2, 0.045_794_672_179_195_69),
            (2.006_220_914_929_266, 0.098_994_534_054_216_32),
            (3.354_101_966_249_684_5, 0.213_996_897_592_455_05),
            (5.607_557_929_579_577, 0.462_597_987_017_296_75),
        ];
        let steps = steps(1.2, 9.375, 2.0, 5).unwrap();
        for (step, (stiffness, modulus)) in steps.iter().zip(expected) {
            assert!((step.dimensionless_stiffness / stiffness - 1.0).abs() < 1e-15, "{step:?}");
            assert!((step.modulus_factor / modulus - 1.0).abs() < 1e-15, "{step:?}");
        }
        let end = Step { dimensionless_stiffness: 9.375, modulus_factor: 1.0, dissipation_factor: 1.0 };
        assert_eq!(steps[4], end);
        assert_eq!(steps[0].dissipation_factor, 2.0);
    }

    #[test]
    fn series_that_do_not_rise_or_are_too_long_are_refused() {
        for (first, last, ratio, count) in [
            (1.2, 1.2, 1.0, 3),
            (1.2, 0.5, 1.0, 3),
            (0.7, 9.0, 1.0, 3),
            (0.0, 9.0, 1.0, 3),
            (1.2, 9.0, 0.5, 3),
            (1.2, 9.0, 1.0, 1),
        ] {
            assert!(steps(first, last, ratio, count).is_err());
        }
        assert!(steps(1.2, f64::INFINITY, 1.0, 2).is_err());
    }
}
