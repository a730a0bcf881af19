//! Plane strain moduli: from Young's modulus, for two surfaces together, and for each of two equal surfaces.
//!
//! OpenSim's `stiffness` is E₁* of one surface. The Hertz law uses the composite modulus E* of both surfaces.

use crate::SURFACE_OVER_COMPOSITE_MODULUS;
use crate::error::{Result, require_non_negative, require_positive, require_range};

/// The rule for the composite modulus of two surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum MixingRule {
    /// (A.2), Johnson (1985): 1/E* is the sum of 1/E₁* and 1/E₂*.
    Johnson,
    /// (A.3), Sherman et al. (2011): the rule of Simbody and OpenSim.
    Sherman,
}

/// Plane strain modulus of a material, E₁* = E₁ / (1 − ν₁²), in N/m².
///
/// Young's modulus E₁ in N/m², above 0; Poisson's ratio ν₁ without unit, above −1 and at most ½.
///
/// Source: (A.1).
///
/// # Errors
/// [`DomainError`](crate::DomainError) outside that domain.
///
/// ```
/// # use contact_scaling::modulus;
/// assert_eq!(modulus::plane_strain(3e5, 0.5)?, 4e5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn plane_strain(young_n_m2: f64, poisson: f64) -> Result<f64> {
    let young = require_positive("young's modulus", young_n_m2)?;
    require_range(
        poisson > -1.0 && poisson <= 0.5,
        "poisson's ratio",
        poisson,
        "a number above -1, at most 0.5",
    )?;
    Ok(young / (1.0 - poisson * poisson))
}

/// Composite modulus by Johnson's rule, E* = E₁* E₂* / (E₁* + E₂*), in N/m².
///
/// Plane strain moduli E₁*, E₂* of the surfaces in N/m². OpenSim does not use this rule.
///
/// Source: (A.2).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both are finite and above 0.
///
/// ```
/// # use contact_scaling::modulus;
/// assert_eq!(modulus::composite_johnson(6e5, 3e5)?, 2e5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn composite_johnson(first_n_m2: f64, second_n_m2: f64) -> Result<f64> {
    let a = require_positive("plane strain modulus", first_n_m2)?;
    let b = require_positive("plane strain modulus", second_n_m2)?;
    Ok(a / (1.0 + a / b))
}

/// Composite modulus as OpenSim computes it, E* = (E₁*^(2/3) E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3)))^(3/2), in N/m².
///
/// Plane strain moduli E₁*, E₂* of the surfaces (each its own `stiffness`) in N/m².
///
/// Source: (A.3).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both are finite and above 0.
///
/// ```
/// # use contact_scaling::modulus;
/// assert!((modulus::composite_sherman(1e6, 1e6)? - 353_553.39).abs() < 0.01);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn composite_sherman(first_n_m2: f64, second_n_m2: f64) -> Result<f64> {
    let a = two_thirds(require_positive("plane strain modulus", first_n_m2)?);
    let b = two_thirds(require_positive("plane strain modulus", second_n_m2)?);
    let k = a * (b / (a + b));
    Ok(k * k.sqrt())
}

/// Modulus of each of two equal surfaces, E₁* = 2^p E*, in N/m²: the value for OpenSim's `stiffness`.
///
/// Composite modulus E* in N/m²; p = 1 by Johnson's rule, 3/2 by Sherman's rule, which OpenSim uses.
///
/// Source: (A.4).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless E* is finite and above 0.
///
/// ```
/// # use contact_scaling::modulus::{MixingRule, self};
/// assert_eq!(modulus::of_equal_surfaces(1e6, MixingRule::Johnson)?, 2e6);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn of_equal_surfaces(composite_n_m2: f64, rule: MixingRule) -> Result<f64> {
    Ok(equal_surfaces_factor(rule) * require_positive("composite modulus", composite_n_m2)?)
}

/// Composite modulus of two equal surfaces, E* = E₁* / 2^p, in N/m²; E₁* is the `stiffness` in a model file.
///
/// Modulus E₁* of each surface in N/m²; p as in [`of_equal_surfaces`].
///
/// Source: (A.4), solved for E*.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless E₁* is finite and above 0.
///
/// ```
/// # use contact_scaling::modulus::{MixingRule, self};
/// assert!((modulus::composite_of_equal(1e6, MixingRule::Sherman)? - 353_553.39).abs() < 0.01);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn composite_of_equal(surface_n_m2: f64, rule: MixingRule) -> Result<f64> {
    Ok(require_positive("plane strain modulus", surface_n_m2)? / equal_surfaces_factor(rule))
}

/// The `stiffness` with which OpenSim computes the contact of a measured material on rigid ground, 2^(3/2) E₁/(1 − ν₁²), in N/m².
///
/// Young's modulus E₁ in N/m²; Poisson's ratio ν₁ without unit. On rigid ground E₂* → ∞ and E* → E₁*, but OpenSim uses
/// `stiffness` for both surfaces.
///
/// Source: (A.5) with (A.1) and (A.4).
///
/// # Errors
/// As [`plane_strain`].
///
/// ```
/// # use contact_scaling::modulus;
/// assert!((modulus::stiffness_on_rigid_ground(3e5, 0.5)? - 1_131_370.85).abs() < 0.01);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn stiffness_on_rigid_ground(young_n_m2: f64, poisson: f64) -> Result<f64> {
    of_equal_surfaces(plane_strain(young_n_m2, poisson)?, MixingRule::Sherman)
}

/// The material of one of two surfaces in contact, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceValues {
    /// E₁*, in N/m²: `stiffness` of its `ContactParameters`.
    pub plane_strain_modulus: f64,
    /// α₁, in s/m: `dissipation` of its `ContactParameters`.
    pub dissipation: f64,
}

/// Dissipation of two different surfaces by Simbody's mixing rule, α = α₁ s₁ + α₂ (1 − s₁), in s/m.
///
/// s₁ = E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3)) is the share of the deformation in the first surface, without unit; E in N/m², α in
/// s/m.
///
/// Source: Simbody's `HuntCrossleyForce` (Sherman et al. 2011).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both moduli are above 0 and both dissipations 0 or above, all finite.
///
/// ```
/// # use contact_scaling::modulus::{SurfaceValues, self};
/// let soft = SurfaceValues { plane_strain_modulus: 1e6, dissipation: 2.0 };
/// let hard = SurfaceValues { plane_strain_modulus: 8e6, dissipation: 0.0 };
/// assert_eq!(modulus::mixed_dissipation(soft, hard)?, 1.6); // the soft one takes 4/5
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn mixed_dissipation(first: SurfaceValues, second: SurfaceValues) -> Result<f64> {
    let a = two_thirds(require_positive("plane strain modulus", first.plane_strain_modulus)?);
    let b = two_thirds(require_positive("plane strain modulus", second.plane_strain_modulus)?);
    let share = b / (a + b);
    Ok(require_non_negative("dissipation", first.dissipation)? * share
        + require_non_negative("dissipation", second.dissipation)? * (1.0 - share))
}

/// Composite radius of two spheres, R = R₁ R₂ / (R₁ + R₂), in m.
///
/// Radii R₁, R₂ in m. A half-space is the limit R₂ → ∞, where R = R₁.
///
/// Source: Johnson (1985), as in section 2.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless both are finite and above 0.
///
/// ```
/// # use contact_scaling::modulus;
/// assert_eq!(modulus::composite_radius(0.3, 0.3)?, 0.15);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn composite_radius(first_m: f64, second_m: f64) -> Result<f64> {
    let a = require_positive("sphere radius", first_m)?;
    let b = require_positive("sphere radius", second_m)?;
    Ok(a / (1.0 + a / b))
}

/// The factor 2^p of (A.4) for two equal surfaces.
fn equal_surfaces_factor(rule: MixingRule) -> f64 {
    match rule {
        MixingRule::Johnson => 2.0,
        MixingRule::Sherman => SURFACE_OVER_COMPOSITE_MODULUS,
    }
}

/// E^(2/3); the cube root gives the same bits on every platform.
fn two_thirds(modulus: f64) -> f64 {
    let root = libm::cbrt(modulus);
    root * root
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const RULES: [MixingRule; 2] = [MixingRule::Johnson, MixingRule::Sherman];

    fn composite(a: f64, b: f64, rule: MixingRule) -> f64 {
        match rule {
            MixingRule::Johnson => composite_johnson(a, b).unwrap(),
            MixingRule::Sherman => composite_sherman(a, b).unwrap(),
        }
    }

    #[test]
    fn the_poisson_ratio_is_above_minus_1_and_at_most_one_half() {
        for refused in [-1.0, 0.51, f64::NAN] {
            assert_eq!(plane_strain(1e6, refused).unwrap_err().quantity(), "poisson's ratio");
        }
        assert_eq!(plane_strain(1e6, 0.0), Ok(1e6));
    }

    #[test]
    fn with_a_rigid_surface_the_composite_modulus_is_that_of_the_other() {
        // (A.5): E* → E₁* as E₂* → ∞, by Sherman's rule as slowly as (E₁*/E₂*)^(2/3).
        for rule in RULES {
            assert!((composite(1e6, 1e30, rule) / 1e6 - 1.0).abs() < 1e-14);
        }
        assert!((composite_radius(0.1, 1e30).unwrap() / 0.1 - 1.0).abs() < 1e-14);
    }

    proptest! {
        #[test]
        fn equal_surfaces_are_the_special_case(e in 1e3..1e10) {
            for rule in RULES {
                let both = composite_of_equal(e, rule).unwrap();
                prop_assert!((composite(e, e, rule) / both - 1.0).abs() < 1e-14);
                prop_assert!((of_equal_surfaces(both, rule).unwrap() / e - 1.0).abs() < 1e-15);
            }
        }

        #[test]
        fn order_of_the_surfaces_does_not_matter(a in 1e3..1e10, b in 1e3..1e10) {
            for rule in RULES {
                prop_assert!((composite(a, b, rule) / composite(b, a, rule) - 1.0).abs() < 1e-14);
            }
            let s = |e, d| SurfaceValues { plane_strain_modulus: e, dissipation: d };
            let one = mixed_dissipation(s(a, 0.3), s(b, 1.7)).unwrap();
            let two = mixed_dissipation(s(b, 1.7), s(a, 0.3)).unwrap();
            prop_assert!((one / two - 1.0).abs() < 1e-13);
        }
    }
}
