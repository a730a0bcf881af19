//! The contact patch of a sphere on a half-space: its size and the mean stress on it (15).

use std::f64::consts::PI;

use crate::error::{Result, require_non_negative, require_positive};

/// Radius of the contact patch, √(x R), in m.
///
/// Indentation x in m, 0 or above; sphere radius R in m. For small x.
///
/// Source: Fig. 3.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless x ≥ 0 and R > 0, both finite.
///
/// ```
/// # use contact_scaling::patch;
/// assert_eq!(patch::radius(0.01, 0.25)?, 0.05);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn radius(indentation_m: f64, radius_m: f64) -> Result<f64> {
    Ok((require_non_negative("indentation", indentation_m)? * require_positive("sphere radius", radius_m)?)
        .sqrt())
}

/// Diameter of the contact patch, 2 √(x R), in m.
///
/// Indentation x in m, 0 or above; sphere radius R in m. For small x.
///
/// Source: Fig. 3.
///
/// # Errors
/// As [`radius`].
///
/// ```
/// # use contact_scaling::patch;
/// assert_eq!(patch::diameter(0.01, 0.25)?, 0.1);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn diameter(indentation_m: f64, radius_m: f64) -> Result<f64> {
    Ok(2.0 * radius(indentation_m, radius_m)?)
}

/// Radius of the contact patch divided by the sphere radius, √x̂, without unit.
///
/// x̂ without unit, 0 or above. At the limit of the Hertz law, x̂ = 0.16, the result is 0.4.
///
/// Source: Fig. 3 with (2).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless x̂ is finite and 0 or above.
///
/// ```
/// # use contact_scaling::patch;
/// assert_eq!(patch::relative_radius(0.16)?, 0.4);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn relative_radius(relative_indentation: f64) -> Result<f64> {
    Ok(require_non_negative("relative indentation", relative_indentation)?.sqrt())
}

/// Mean stress on the contact patch, σ = F_c / (π R² x̂), in N/m².
///
/// Normal force F_c of one sphere in N, sphere radius R in m, x̂ without unit.
///
/// Source: (15).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless F_c ≥ 0, R > 0 and x̂ > 0, all finite: without contact there is no patch.
///
/// ```
/// # use contact_scaling::patch;
/// assert!((patch::mean_stress(100.0, 0.032, 0.353)? / 8.806e4 - 1.0).abs() < 1e-4);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn mean_stress(force_n: f64, radius_m: f64, relative_indentation: f64) -> Result<f64> {
    let force = require_non_negative("force", force_n)?;
    let radius = require_positive("sphere radius", radius_m)?;
    Ok(force / (PI * (radius * radius) * require_positive("relative indentation", relative_indentation)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outside_the_domain_is_an_error() {
        assert_eq!(radius(-1.0, 1.0).unwrap_err().quantity(), "indentation");
        assert_eq!(diameter(1.0, 0.0).unwrap_err().quantity(), "sphere radius");
        assert_eq!(relative_radius(f64::NAN).unwrap_err().quantity(), "relative indentation");
        assert_eq!(mean_stress(1.0, 1.0, 0.0).unwrap_err().quantity(), "relative indentation");
    }

    #[test]
    fn stress_is_force_over_patch_area() {
        let (force, r, x_hat) = (55.0, 0.03, 0.2);
        let patch = radius(x_hat * r, r).unwrap();
        let stress = mean_stress(force, r, x_hat).unwrap();
        assert!((stress * PI * patch * patch / force - 1.0).abs() < 1e-14);
    }
}
