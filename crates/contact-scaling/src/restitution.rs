//! The restitution of the Hunt–Crossley law: the approximation (13), and the exact result of the law.
//!
//! For an impact without gravity the law can be integrated: with d = 3/2 α ẋ⁻ the restitution c solves h(d) = h(−c d), where h(z)
//! = z − ln(1 + z). (13) is the start of its series: c = 1 − 2/3 d + …

use crate::error::{Result, require_non_negative, require_positive, require_range};

/// The domain of a restitution that may be 0, for error messages.
const EXPECTED_ZERO_TO_ONE: &str = "a number from 0 to 1";
/// The domain of a restitution that may not be 0, for error messages.
const EXPECTED_RESTITUTION: &str = "a number above 0, at most 1";

/// Restitution by the approximation, c_r = 1 − α ẋ⁻, without unit.
///
/// Dissipation α in s/m, speed before the impact ẋ⁻ in m/s, both 0 or above. It is accurate for c_r ≳ 0.8; [`exact`] is accurate
/// for all values.
///
/// Source: (13).
///
/// # Errors
/// [`DomainError`](crate::DomainError) if α ẋ⁻ > 1, because the approximation has no valid result there.
///
/// ```
/// # use contact_scaling::restitution;
/// assert_eq!(restitution::approximate(0.5, 0.4)?, 0.8);
/// assert!(restitution::approximate(2.0, 0.6).is_err());
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn approximate(dissipation_s_m: f64, impact_speed_m_s: f64) -> Result<f64> {
    let c = 1.0 - dissipation_times_speed(dissipation_s_m, impact_speed_m_s)?;
    require_range(c >= 0.0, "restitution by (13)", c, EXPECTED_ZERO_TO_ONE)
}

/// Dissipation by the approximation, α = (1 − c_r) / ẋ⁻, in s/m: the largest with which the restitution is at least c_r.
///
/// Restitution c_r without unit, 0 to 1; speed before the impact ẋ⁻ in m/s, above 0.
///
/// Source: (13), solved for α.
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::restitution;
/// assert!((restitution::dissipation(0.8, 0.4)? - 0.5).abs() < 1e-15); // section 4.2: about 0.5 s/m
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn dissipation(restitution: f64, impact_speed_m_s: f64) -> Result<f64> {
    let ok = (0.0..=1.0).contains(&restitution);
    let c = require_range(ok, "restitution", restitution, EXPECTED_ZERO_TO_ONE)?;
    Ok((1.0 - c) / require_positive("impact speed", impact_speed_m_s)?)
}

/// Impact speed of the paper's drop tests, ẋ⁻ = √(2 g · R/4) = √(g R / 2), in m/s.
///
/// The spheres fall from a height of a quarter of their radius. Gravity g in m/s², sphere radius R in m, both above 0.
///
/// Source: the drop tests of Table 1.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both are finite and above 0.
///
/// ```
/// # use contact_scaling::restitution;
/// assert!((restitution::drop_speed(9.81, 0.032)? - 0.4).abs() < 5e-3); // section 4.2: about 0.4 m/s
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn drop_speed(gravity_m_s2: f64, radius_m: f64) -> Result<f64> {
    Ok((require_positive("gravity", gravity_m_s2)? * require_positive("sphere radius", radius_m)? / 2.0)
        .sqrt())
}

/// Exact restitution c of the law: d − ln(1 + d) = −c d − ln(1 − c d) with d = 3/2 α ẋ⁻, without unit.
///
/// Dissipation α in s/m, speed before the impact ẋ⁻ in m/s, both 0 or above. For an impact without gravity or other forces; the
/// result is above 0 for every α.
///
/// Source: the integral of (12) over an impact; not in the paper.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless α and ẋ⁻ are finite and 0 or above.
///
/// ```
/// # use contact_scaling::restitution;
/// assert!((restitution::exact(2.0, 0.396)? - 0.5495).abs() < 5e-5); // (13) says 0.208
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn exact(dissipation_s_m: f64, impact_speed_m_s: f64) -> Result<f64> {
    Ok(restitution_from_d(1.5 * dissipation_times_speed(dissipation_s_m, impact_speed_m_s)?))
}

/// Dissipation with which the exact restitution of the law is c: [`exact`] solved for α, in s/m.
///
/// Restitution c without unit, above 0 and at most 1; speed before the impact ẋ⁻ in m/s, above 0. With no finite α is c = 0.
///
/// Source: the integral of (12) over an impact, solved for α; not in the paper.
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::restitution;
/// let alpha = restitution::exact_dissipation(0.55, 0.4)?;
/// assert!((restitution::exact(alpha, 0.4)? - 0.55).abs() < 1e-14);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn exact_dissipation(restitution: f64, impact_speed_m_s: f64) -> Result<f64> {
    let ok = restitution > 0.0 && restitution <= 1.0;
    let c = require_range(ok, "restitution", restitution, EXPECTED_RESTITUTION)?;
    Ok(d_from_restitution(c) / 1.5 / require_positive("impact speed", impact_speed_m_s)?)
}

/// The product α ẋ⁻ of a dissipation and an impact speed, without unit.
fn dissipation_times_speed(dissipation_s_m: f64, impact_speed_m_s: f64) -> Result<f64> {
    let product = require_non_negative("dissipation", dissipation_s_m)?
        * require_non_negative("impact speed", impact_speed_m_s)?;
    require_non_negative("dissipation times impact speed", product)
}

/// h(z) = z − ln(1 + z), without cancellation at small z.
///
/// With s = z/(2 + z), ln(1 + z) = 2 (s + s³/3 + s⁵/5 + …) and z − 2 s = z s.
fn z_minus_ln_1_plus_z(z: f64) -> f64 {
    if z.abs() > 0.5 {
        return z - libm::log1p(z);
    }
    let s = z / (2.0 + z);
    let square = s * s;
    // |s| ≤ 1/3: twenty terms reach 1e-19.
    let series = (0..20).rev().fold(0.0, |sum, i| sum * square + 1.0 / f64::from(2 * i + 3));
    s * (z - 2.0 * square * series)
}

/// The restitution c for d = 3/2 α ẋ⁻, by Newton steps on h(−y) = h(d), where y = c d.
fn restitution_from_d(d: f64) -> f64 {
    if d == 0.0 {
        return 1.0;
    }
    let target = z_minus_ln_1_plus_z(d);
    // h is convex and falls on (−1, 0): from a point left of the root every step stays left of it.
    // Both −d and expm1(−1 − h) are; the nearer one starts.
    let mut z = libm::expm1(-1.0 - target).max(-d);
    for _ in 0..60 {
        let step = (target - z_minus_ln_1_plus_z(z)) * (1.0 + z) / z;
        if !step.is_finite() || step <= f64::EPSILON * -z * 0.25 {
            break;
        }
        z += step;
    }
    -z / d
}

/// The number d = 3/2 α ẋ⁻ for the restitution c, by Newton steps on c(d), which falls and is convex: every step stays left of the root.
fn d_from_restitution(c: f64) -> f64 {
    let mut d = 1.5 * (1.0 - c);
    for _ in 0..100 {
        let restitution = restitution_from_d(d);
        let y = restitution * d;
        let slope = (d / (1.0 + d) * (1.0 - y) / y - restitution) / d;
        let step = (c - restitution) / slope;
        if !step.is_finite() || step <= f64::EPSILON * d {
            break;
        }
        d += step;
    }
    d
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn without_dissipation_restitution_is_one() {
        assert_eq!(approximate(0.0, 1.0), Ok(1.0));
        assert_eq!(exact(0.0, 1.0), Ok(1.0));
        assert_eq!(exact(1.0, 0.0), Ok(1.0));
        assert_eq!(exact_dissipation(1.0, 1.0), Ok(0.0));
    }

    #[test]
    fn values_outside_the_domain_are_errors_and_are_never_clamped() {
        let error = approximate(2.0, 0.6).unwrap_err();
        assert_eq!(error.quantity(), "restitution by (13)");
        assert!((error.value() + 0.2).abs() < 1e-15);
        for refused in [0.0, 1.1, f64::NAN] {
            assert!(exact_dissipation(refused, 1.0).is_err());
        }
        assert!(dissipation(-0.1, 1.0).is_err());
        assert!(dissipation(0.5, 0.0).is_err());
        assert!(exact(1e300, 1e300).is_err());
    }

    #[test]
    fn exact_and_approximate_restitution_agree_to_first_order() {
        // c = 1 − a + a² + O(a³) with a = α ẋ⁻; (13) stops after a.
        for a in [1e-3, 1e-4, 1e-5, 1e-6] {
            let difference = exact(a, 1.0).unwrap() - approximate(a, 1.0).unwrap();
            assert!((difference / (a * a) - 1.0).abs() < 2.0 * a + 1e-15 / (a * a), "{a} {difference}");
        }
    }

    #[test]
    fn restitution_of_extreme_dissipation_has_its_limit() {
        // c d → 1 as d → ∞.
        for d in [40.0, 1e3, 1e12, 1e300] {
            assert!((restitution_from_d(d) * d - 1.0).abs() < 1e-12, "{d}");
        }
    }

    proptest! {
        #[test]
        fn dissipation_and_restitution_are_inverses(c in 0.001..0.999, v in 0.01..10.0) {
            let alpha = exact_dissipation(c, v).unwrap();
            prop_assert!((exact(alpha, v).unwrap() / c - 1.0).abs() < 1e-12);
            let alpha = dissipation(c, v).unwrap();
            prop_assert!((approximate(alpha, v).unwrap() - c).abs() < 1e-14);
        }
    }
}
