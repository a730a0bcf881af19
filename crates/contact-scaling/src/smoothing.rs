//! The smoothing parameters cf, bd and bv: OpenSim's defaults, and values for wanted widths and indentations by (C.2), (C.5) to
//! (C.8), (C.10).
//!
//! A threshold t is a value of the contact state s_c, without unit: a width is the distance from s_c = t to s_c = 1 − t.

use crate::error::{Result, require_non_negative, require_positive, require_range};

/// The smoothing parameters of `SmoothSphereHalfSpaceForce`, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothingValues {
    /// cf, in m² in spite of its name (C.1): OpenSim's `constant_contact_force`. 0 is allowed.
    pub constant_contact_force: f64,
    /// bd, in 1/m: OpenSim's `hertz_smoothing`.
    pub hertz_smoothing: f64,
    /// bv, in s/m: OpenSim's `hunt_crossley_smoothing`.
    pub hunt_crossley_smoothing: f64,
}

impl SmoothingValues {
    /// OpenSim's default values, for a file without these elements: cf = 1e-5 m², bd = 300 1/m, bv = 50 s/m.
    pub const OPENSIM_DEFAULT: Self =
        Self { constant_contact_force: 1e-5, hertz_smoothing: 300.0, hunt_crossley_smoothing: 50.0 };
}

/// The domain of a threshold t on a smoothed step, for error messages.
const EXPECTED_BELOW_HALF: &str = "a number between 0 and 0.5";

/// atanh(1 − 2 t); an error with the `expected` range unless `ok`.
fn half_width_from_threshold(threshold: f64, ok: bool, expected: &'static str) -> Result<f64> {
    Ok(libm::atanh(1.0 - 2.0 * require_range(ok, "threshold", threshold, expected)?))
}

/// 2 atanh(1 − 2 t) for 0 < t < ½.
fn full_width_from_threshold(threshold: f64) -> Result<f64> {
    Ok(2.0 * half_width_from_threshold(threshold, threshold > 0.0 && threshold < 0.5, EXPECTED_BELOW_HALF)?)
}

/// Constant contact "force" for a constant relative indentation, cf = (R x̂_c)², in m².
///
/// x̂_c without unit, 0 or above (suggested: 0.1, or 0.05 if x̂ ≤ 0.16 is wanted); sphere radius R in m.
///
/// Source: (C.2).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless x̂_c ≥ 0 and R > 0, both finite.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert!((smoothing::constant_contact_force(0.0988, 0.032)? - 1e-5).abs() < 1e-8); // Falisse et al. 2022
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn constant_contact_force(constant_indentation: f64, radius_m: f64) -> Result<f64> {
    let x = require_non_negative("constant relative indentation", constant_indentation)?
        * require_positive("sphere radius", radius_m)?;
    Ok(x * x)
}

/// Constant relative indentation of a smoothed contact, x̂_c = √cf / R, without unit.
///
/// cf in m², 0 or above; sphere radius R in m.
///
/// Source: (C.2), solved for x̂_c.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless cf ≥ 0 and R > 0, both finite.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert!((smoothing::constant_indentation(1e-5, 0.032)? - 0.0988).abs() < 5e-5); // Falisse et al. 2022
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn constant_indentation(constant_contact_force_m2: f64, radius_m: f64) -> Result<f64> {
    let cf = require_non_negative("constant contact force", constant_contact_force_m2)?;
    Ok(cf.sqrt() / require_positive("sphere radius", radius_m)?)
}

/// Hertz smoothing from its dimensionless form, bd = b_x̂ / R, in 1/m.
///
/// b_x̂ without unit, above 0 (suggested: 10); sphere radius R in m.
///
/// Source: (C.5).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both are finite and above 0.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert_eq!(smoothing::hertz_smoothing(10.0, 0.02)?, 500.0);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hertz_smoothing(dimensionless: f64, radius_m: f64) -> Result<f64> {
    Ok(require_positive("dimensionless hertz smoothing", dimensionless)?
        / require_positive("sphere radius", radius_m)?)
}

/// Relative indentation at which the contact state is 1 − t: x̂_t = atanh(1 − 2 t) / (bd R), without unit.
///
/// Threshold t without unit, 0 < t < 1 (below 0 for t > ½); bd in 1/m; sphere radius R in m.
///
/// Source: (C.6).
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert!((smoothing::threshold_indentation(0.05, 300.0, 0.032)? - 0.153).abs() < 5e-4);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn threshold_indentation(threshold: f64, hertz_smoothing_per_m: f64, radius_m: f64) -> Result<f64> {
    let ok = threshold > 0.0 && threshold < 1.0;
    let half = half_width_from_threshold(threshold, ok, "a number between 0 and 1")?;
    let bd = require_positive("hertz smoothing", hertz_smoothing_per_m)?;
    Ok(half / (bd * require_positive("sphere radius", radius_m)?))
}

/// Width of the contact transition in relative indentation, Δx̂ = 2 atanh(1 − 2 t) / (bd R), without unit.
///
/// From s_c = t to s_c = 1 − t; t without unit, 0 < t < ½; bd in 1/m; sphere radius R in m.
///
/// Source: (C.7).
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert!((smoothing::transition_width(0.05, 500.0, 0.02)? - 0.29).abs() < 5e-3); // −0.15 to 0.15
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn transition_width(threshold: f64, hertz_smoothing_per_m: f64, radius_m: f64) -> Result<f64> {
    let bd = require_positive("hertz smoothing", hertz_smoothing_per_m)?;
    Ok(full_width_from_threshold(threshold)? / (bd * require_positive("sphere radius", radius_m)?))
}

/// Hertz smoothing for a wanted width of the contact transition, bd = 2 atanh(1 − 2 t) / (Δx̂ R), in 1/m.
///
/// From s_c = t to s_c = 1 − t over Δx̂; t and Δx̂ without unit, 0 < t < ½, Δx̂ > 0; sphere radius R in m.
///
/// Source: (C.8).
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert!((smoothing::hertz_smoothing_for_width(0.05, 0.3, 0.032)? - 306.7).abs() < 0.1);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hertz_smoothing_for_width(threshold: f64, width: f64, radius_m: f64) -> Result<f64> {
    let width = require_positive("transition width", width)?;
    Ok(full_width_from_threshold(threshold)? / (width * require_positive("sphere radius", radius_m)?))
}

/// Hunt–Crossley smoothing from its reduced form, bv = b_ẋ / √R, in s/m.
///
/// b_ẋ in s/√m, above 0 (suggested: 9); sphere radius R in m.
///
/// Source: (C.10), its first form.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both are finite and above 0.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert_eq!(smoothing::hunt_crossley_smoothing(9.0, 0.09)?, 30.0);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hunt_crossley_smoothing(reduced_s_per_root_m: f64, radius_m: f64) -> Result<f64> {
    let reduced = require_positive("reduced hunt crossley smoothing", reduced_s_per_root_m)?;
    Ok(reduced / require_positive("sphere radius", radius_m)?.sqrt())
}

/// Hunt–Crossley smoothing for a wanted width of the speed state, bv = 2 atanh(1 − 2 t) / Δv, in s/m.
///
/// Over the width Δv, the speed state goes from t to 1 − t; t without unit, 0 < t < ½; Δv in m/s, above 0.
///
/// Source: (C.10) with Δẋ = Δv / √R.
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert!((smoothing::hunt_crossley_smoothing_for_speed_width(0.05, 0.0589)? - 50.0).abs() < 0.05);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hunt_crossley_smoothing_for_speed_width(threshold: f64, width_m_s: f64) -> Result<f64> {
    Ok(full_width_from_threshold(threshold)? / require_positive("speed width", width_m_s)?)
}

/// Hunt–Crossley smoothing in the form that the paper prints, bv = 2 atanh(1 − 2 t) / (Δẋ √R), in s/m.
///
/// Δẋ is not a speed but a speed divided by √R, in √m/s; t without unit, 0 < t < ½; sphere radius R in m.
///
/// Source: (C.10), its second form.
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::smoothing::{hunt_crossley_smoothing_for_speed_width, self};
/// let printed = smoothing::hunt_crossley_smoothing_for_reduced_width(0.05, 0.2, 0.09)?;
/// assert!((printed / hunt_crossley_smoothing_for_speed_width(0.05, 0.2 * 0.3)? - 1.0).abs() < 1e-15);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn hunt_crossley_smoothing_for_reduced_width(
    threshold: f64,
    width_root_m_per_s: f64,
    radius_m: f64,
) -> Result<f64> {
    let width = require_positive("reduced speed width", width_root_m_per_s)?;
    Ok(full_width_from_threshold(threshold)? / (width * require_positive("sphere radius", radius_m)?.sqrt()))
}

/// Speed state of a smoothed contact at speed 0, ½ + ½ tanh(2 bv/(3α)), without unit, from ½ to 1.
///
/// Dissipation α in s/m, 0 or above; bv in s/m. At speed 0, the force of a smoothed contact is (C.3) times this factor; the
/// factor is 1 for α = 0.
///
/// Source: (C.9), its second factor at ẋ = 0.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless α ≥ 0 and bv > 0, both finite.
///
/// ```
/// # use contact_scaling::smoothing;
/// assert_eq!(smoothing::speed_state_at_rest(0.0, 50.0)?, 1.0);
/// assert!((smoothing::speed_state_at_rest(20.0, 50.0)? - 0.966).abs() < 5e-4); // 3.4 % of the force is missing
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn speed_state_at_rest(dissipation_s_m: f64, smoothing_s_m: f64) -> Result<f64> {
    let alpha = require_non_negative("dissipation", dissipation_s_m)?;
    Ok(speed_state(alpha, require_positive("hunt crossley smoothing", smoothing_s_m)?, 0.0))
}

/// The share of the force that smoothing leaves at a speed, from 0 to 1: the second factor of (C.9), for valid numbers.
pub(crate) fn speed_state(alpha: f64, bv: f64, speed_m_s: f64) -> f64 {
    0.5 + 0.5 * libm::tanh(bv * (speed_m_s + 2.0 / (3.0 * alpha)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Hertz, SmoothSphere, SmoothingValues};
    use proptest::prelude::*;

    #[test]
    fn thresholds_of_smoothing_have_open_bounds() {
        for refused in [0.0, 0.5, 1.0, f64::NAN] {
            assert_eq!(transition_width(refused, 300.0, 0.03).unwrap_err().quantity(), "threshold");
            assert!(hertz_smoothing_for_width(refused, 0.3, 0.03).is_err());
            assert!(hunt_crossley_smoothing_for_speed_width(refused, 0.1).is_err());
        }
        assert!(threshold_indentation(0.95, 300.0, 0.03).unwrap() < 0.0);
        assert!(threshold_indentation(1.0, 300.0, 0.03).is_err());
    }

    proptest! {
        #[test]
        fn smoothing_widths_and_parameters_are_inverses(t in 0.001..0.499, r in 1e-3..0.5, x in 0.01..1.0, b in 1.0..50.0) {
            let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-13;
            let cf = constant_contact_force(x, r).unwrap();
            prop_assert!(close(constant_indentation(cf, r).unwrap(), x));
            let bd = hertz_smoothing_for_width(t, x, r).unwrap();
            prop_assert!(close(transition_width(t, bd, r).unwrap(), x));
            prop_assert!(close(2.0 * threshold_indentation(t, bd, r).unwrap(), x));
            prop_assert!(close(hertz_smoothing(b, r).unwrap() * r, b));
            prop_assert!(close(hunt_crossley_smoothing(b, r).unwrap() * r.sqrt(), b));
        }

        #[test]
        fn the_contact_state_at_the_threshold_indentation_is_1_minus_t(t in 0.01..0.99, r in 1e-3..0.5, bd in 50.0..5000.0) {
            let smoothing = SmoothingValues { hertz_smoothing: bd, ..SmoothingValues::OPENSIM_DEFAULT };
            let law = SmoothSphere::new(Hertz::sphere(1e6, r).unwrap(), 1.0, smoothing).unwrap();
            let x = threshold_indentation(t, bd, r).unwrap() * r;
            prop_assert!((law.contact_state(x) - (1.0 - t)).abs() < 1e-14);
        }
    }
}
