//! Parameters for a wanted indentation or stiffness: (11), and (11) with (B.2). For spheres, so the shape factor η is 1.
//!
//! All moduli in this module are composite moduli E*. OpenSim's `stiffness` is 2^(3/2) times E*:
//! [`crate::modulus::of_equal_surfaces`].

use crate::SharedLoad;
use crate::error::{Result, require_positive, require_range};
use crate::hertz::depth;

/// `relative_indentation`, if 0 < x̂ ≤ 1.
fn checked_indentation(relative_indentation: f64) -> Result<f64> {
    let ok = relative_indentation > 0.0 && relative_indentation <= 1.0;
    require_range(ok, "relative indentation", relative_indentation, "a number above 0, at most 1")
}

/// Composite modulus with which spheres have the relative indentation x̂ under a load, E* = 3 F / (4 R² x̂^(3/2) n), in N/m².
///
/// Sphere radius R in m; x̂ without unit, 0 < x̂ ≤ 1; load F in N on n spheres.
///
/// Source: (11), which is (3) solved for E*.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless R is finite and above 0 and x̂ in its range.
///
/// ```
/// # use contact_scaling::{SharedLoad, design};
/// let human = SharedLoad::new(62.0 * 9.81, 6.0)?;
/// assert!((design::composite_modulus(0.032, 0.3533, &human)? / 0.354e6 - 1.0).abs() < 2e-3); // Table 1
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn composite_modulus(radius_m: f64, relative_indentation: f64, load: &SharedLoad) -> Result<f64> {
    let radius = require_positive("sphere radius", radius_m)?;
    let x = checked_indentation(relative_indentation)?;
    Ok(0.75 * load.per_sphere_n() / (radius * radius * (x * x.sqrt())))
}

/// Relative indentation of spheres under a load, x̂ = (3 F / (4 E* R² n))^(2/3), without unit.
///
/// Composite modulus E* in N/m²; sphere radius R in m; load F in N on n spheres. The result can be above 1: the spheres are then
/// too soft for the load.
///
/// Source: (11), solved for x̂.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless E* and R are finite and above 0.
///
/// ```
/// # use contact_scaling::{SharedLoad, design};
/// let human = SharedLoad::new(62.0 * 9.81, 6.0)?;
/// assert!((design::relative_indentation(353_553.39, 0.032, &human)? - 0.3533).abs() < 5e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn relative_indentation(composite_modulus_n_m2: f64, radius_m: f64, load: &SharedLoad) -> Result<f64> {
    let modulus = require_positive("composite modulus", composite_modulus_n_m2)?;
    let radius = require_positive("sphere radius", radius_m)?;
    Ok(relative_depth(load.per_sphere_n(), modulus, radius))
}

/// [`relative_indentation`] without checks: x̂ under the load `load` (N) on one sphere.
pub(crate) fn relative_depth(load: f64, modulus: f64, radius: f64) -> f64 {
    depth(0.75 * load, modulus * (radius * radius))
}

/// Sphere radius with which a sphere has the stiffness k at x̂ under a load, R = 3 F / (2 k x̂ n), in m.
///
/// Stiffness k of one sphere in N/m; x̂ without unit, 0 < x̂ ≤ 1; load F in N on n spheres.
///
/// Source: (11) with (B.2).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless k is finite and above 0 and x̂ in its range.
///
/// ```
/// # use contact_scaling::{SharedLoad, design};
/// let human = SharedLoad::new(62.0 * 9.81, 6.0)?;
/// assert!((design::radius_for_stiffness(13_449.5, 0.3533, &human)? - 0.032).abs() < 1e-5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn radius_for_stiffness(stiffness_n_m: f64, relative_indentation: f64, load: &SharedLoad) -> Result<f64> {
    let k = require_positive("contact stiffness", stiffness_n_m)?;
    Ok(1.5 * load.per_sphere_n() / (k * checked_indentation(relative_indentation)?))
}

/// Composite modulus that gives a stiffness at x̂, E* = k / (2 R √x̂), in N/m².
///
/// Stiffness k of one sphere in N/m; sphere radius R in m; x̂ without unit, 0 < x̂ ≤ 1.
///
/// Source: (B.2), solved for E*.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless k and R are finite and above 0 and x̂ in its range.
///
/// ```
/// # use contact_scaling::design;
/// assert_eq!(design::composite_modulus_for_stiffness(3000.0, 0.03, 0.25)?, 1e5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn composite_modulus_for_stiffness(
    stiffness_n_m: f64,
    radius_m: f64,
    relative_indentation: f64,
) -> Result<f64> {
    let k = require_positive("contact stiffness", stiffness_n_m)?;
    let radius = require_positive("sphere radius", radius_m)?;
    Ok(k / (2.0 * radius * checked_indentation(relative_indentation)?.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Hertz;
    use proptest::prelude::*;

    #[test]
    fn relative_indentation_lies_above_0_and_not_above_1() {
        let load = SharedLoad::new(100.0, 1.0).unwrap();
        for refused in [0.0, -0.1, 1.000_001, f64::NAN] {
            assert!(composite_modulus(0.1, refused, &load).is_err());
            assert!(radius_for_stiffness(1e3, refused, &load).is_err());
            assert!(composite_modulus_for_stiffness(1e3, 0.1, refused).is_err());
        }
        assert!(composite_modulus(0.1, 1.0, &load).is_ok());
    }

    proptest! {
        #[test]
        fn the_law_has_the_wanted_indentation_and_stiffness(
            f in 1.0..1e4, n in 1.0..20.0, x_hat in 0.01..1.0, k in 1e2..1e6,
        ) {
            let load = SharedLoad::new(f, n).unwrap();
            let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-13;
            let radius = radius_for_stiffness(k, x_hat, &load).unwrap();
            let modulus = composite_modulus_for_stiffness(k, radius, x_hat).unwrap();
            prop_assert!(close(modulus, composite_modulus(radius, x_hat, &load).unwrap()));
            prop_assert!(close(x_hat, relative_indentation(modulus, radius, &load).unwrap()));
            let law = Hertz::sphere(modulus, radius).unwrap();
            prop_assert!(close(law.force_at_relative_indentation(x_hat), load.per_sphere_n()));
            prop_assert!(close(law.stiffness_at_relative_indentation(x_hat), k));
        }
    }
}
