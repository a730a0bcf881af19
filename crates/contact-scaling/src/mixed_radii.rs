//! Spheres of different radii with one common modulus.

use crate::error::{Result, require_positive};

/// Mean of the squared radii, Σ R_i² / n, in m²: it replaces R² in (10) for spheres with one common `stiffness`.
///
/// Radii R_i in m. One `ContactParameters` has one modulus for all its spheres. With this mean in (10), each sphere keeps its x̂,
/// and the loads on the spheres are proportional to R_i².
///
/// Source: (3) summed over spheres of equal x̂ and E*.
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless there is at least one radius, and each is finite and above 0.
///
/// ```
/// # use contact_scaling::mixed_radii;
/// assert_eq!(mixed_radii::mean_square(&[3.0, 4.0])?, 12.5);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn mean_square(radii_m: &[f64]) -> Result<f64> {
    let mut sum = 0.0;
    let mut count = 0.0;
    for &radius in radii_m {
        sum += require_positive("sphere radius", radius)? * radius;
        count += 1.0;
    }
    Ok(sum / require_positive("number of spheres", count)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Hertz;

    #[test]
    fn no_sphere_is_an_error() {
        assert_eq!(mean_square(&[]).unwrap_err().quantity(), "number of spheres");
        assert_eq!(mean_square(&[1.0, 0.0]).unwrap_err().quantity(), "sphere radius");
    }

    #[test]
    fn the_mean_radius_replaces_each_radius() {
        let (e, x_hat, radii) = (1e6, 0.2, [0.01, 0.02, 0.05]);
        let force = |r: f64| Hertz::sphere(e, r).unwrap().force_at_relative_indentation(x_hat);
        let sum: f64 = radii.iter().map(|&r| force(r)).sum();
        let mean = force(mean_square(&radii).unwrap().sqrt());
        assert!((3.0 * mean / sum - 1.0).abs() < 1e-14);
    }
}
