//! Dimensionless stiffness and natural frequency: (B.3) to (B.5). Stiffness itself is [`crate::Hertz::stiffness`].

use std::f64::consts::TAU;

use crate::SharedLoad;
use crate::error::{Result, require_positive};

/// Dimensionless stiffness k̂ = k R n / F_c, without unit.
///
/// Stiffness k of one sphere in N/m; sphere radius R in m; load F_c in N on n spheres.
///
/// Source: (B.3).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless k and R are finite and above 0.
///
/// ```
/// # use contact_scaling::{SharedLoad, stiffness};
/// let human = SharedLoad::new(62.0 * 9.81, 6.0)?;
/// assert!((stiffness::dimensionless(13_449.5, 0.032, &human)? - 4.2457).abs() < 1e-4);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn dimensionless(stiffness_n_m: f64, radius_m: f64, load: &SharedLoad) -> Result<f64> {
    let k = require_positive("contact stiffness", stiffness_n_m)?;
    Ok(k * require_positive("sphere radius", radius_m)? / load.per_sphere_n())
}

/// Dimensionless stiffness of the Hertz law under the load at which the relative indentation is x̂: k̂ = 3 / (2 x̂), without
/// unit.
///
/// x̂ without unit, above 0.
///
/// Source: (B.3) with (B.2) and (3).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless x̂ is finite and above 0.
///
/// ```
/// # use contact_scaling::stiffness;
/// assert_eq!(stiffness::dimensionless_hertz(0.375)?, 4.0);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn dimensionless_hertz(relative_indentation: f64) -> Result<f64> {
    Ok(1.5 / require_positive("relative indentation", relative_indentation)?)
}

/// Natural frequency of small oscillations, f_n = √(k / M) / (2π), in Hz.
///
/// Stiffness k of one sphere in N/m; mass M on this sphere in kg: the body mass divided by the number n of spheres.
///
/// Source: (B.4).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless k and M are finite and above 0.
///
/// ```
/// # use contact_scaling::stiffness;
/// assert!((stiffness::natural_frequency(13_449.5, 62.0 / 6.0)? - 5.742).abs() < 1e-3);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn natural_frequency(stiffness_n_m: f64, mass_on_sphere_kg: f64) -> Result<f64> {
    let k = require_positive("contact stiffness", stiffness_n_m)?;
    Ok((k / require_positive("mass on the sphere", mass_on_sphere_kg)?).sqrt() / TAU)
}

/// Natural frequency of small oscillations about the equilibrium under body weight, f_n,eq = √(3/2 · g / (x̂_eq R)) / (2π), in
/// Hz.
///
/// x̂_eq without unit; sphere radius R in m; gravity g in m/s².
///
/// Source: (B.5).
///
/// # Errors
/// [`DomainError`](crate::DomainError) unless x̂_eq, R and g are finite and above 0.
///
/// ```
/// # use contact_scaling::stiffness;
/// assert!((stiffness::equilibrium_frequency(0.3533, 0.032, 9.81)? - 5.742).abs() < 1e-3);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
pub fn equilibrium_frequency(relative_indentation: f64, radius_m: f64, gravity_m_s2: f64) -> Result<f64> {
    let x = require_positive("relative indentation", relative_indentation)?;
    let radius = require_positive("sphere radius", radius_m)?;
    Ok((1.5 * require_positive("gravity", gravity_m_s2)? / (x * radius)).sqrt() / TAU)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Hertz, design};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_general_forms_agree_with_the_equilibrium_forms(
            e in 1e4..1e8, r in 1e-3..0.2, mass in 1e-2..1e3, g in 1.0..20.0, n in 1.0..12.0,
        ) {
            let load = SharedLoad::new(mass * g, n).unwrap();
            let x_hat = design::relative_indentation(e, r, &load).unwrap();
            let k = Hertz::sphere(e, r).unwrap().stiffness_at_relative_indentation(x_hat);
            let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-13;
            prop_assert!(close(dimensionless(k, r, &load).unwrap(), dimensionless_hertz(x_hat).unwrap()));
            let free = natural_frequency(k, mass / n).unwrap();
            prop_assert!(close(free, equilibrium_frequency(x_hat, r, g).unwrap()));
        }
    }

    #[test]
    fn outside_the_domain_is_an_error() {
        let load = SharedLoad::new(1.0, 1.0).unwrap();
        assert!(dimensionless(0.0, 1.0, &load).is_err());
        assert!(dimensionless_hertz(0.0).is_err());
        assert!(natural_frequency(1.0, -1.0).is_err());
        assert_eq!(equilibrium_frequency(0.3, 0.1, 0.0).unwrap_err().quantity(), "gravity");
    }
}
