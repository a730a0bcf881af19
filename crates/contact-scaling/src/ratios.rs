//! The factors that carry every contact parameter from one scale to another: (8) to (10), (14), (C.2),
//! (C.5), (C.10), and two extensions of the same argument, gravity and friction.
//!
//! With ρ = R_b/R_a, μ = M_b/M_a, ν = n_a/n_b and γ = g_b/g_a. Each factor is formed first and the parameter
//! multiplied once, so that a ratio of exactly 1 changes no bit of it.

use crate::Scale;
use crate::error::{DomainError, positive};

/// The four ratios of two scales, target over origin, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatioValues {
    /// μ = M_b / M_a.
    pub mass: f64,
    /// 1/ν = n_b / n_a, of the spheres that share the body weight.
    pub sphere_count: f64,
    /// ρ = R_b / R_a.
    pub radius: f64,
    /// γ = g_b / g_a; 1 unless the target lives elsewhere.
    pub gravity: f64,
}

/// How much larger the target of a rescaling is than its origin.
///
/// ```
/// use contact_scaling::Ratios;
/// let giraffe = Ratios::isometric(1190.0 / 62.0)?;
/// // With R ∝ M^(1/3), E* ∝ M^(1/3) too (8), and α ∝ M^(-1/6) (14).
/// assert!((giraffe.plane_strain_modulus() - giraffe.radius()).abs() < 1e-14);
/// assert!((giraffe.dissipation() - giraffe.dissipation_by_mass()).abs() < 1e-14);
/// assert_eq!(Ratios::identity().hertz_smoothing(), 1.0);
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratios(RatioValues);

impl Ratios {
    /// Checks the four ratios and keeps them.
    ///
    /// # Errors
    /// [`DomainError`] unless each ratio, and each factor formed from them, is finite and above 0.
    pub fn new(values: RatioValues) -> Result<Self, DomainError> {
        positive("mass ratio", values.mass)?;
        positive("sphere count ratio", values.sphere_count)?;
        positive("radius ratio", values.radius)?;
        positive("gravity ratio", values.gravity)?;
        let ratios = Self(values);
        positive("factor of the plane strain modulus", ratios.plane_strain_modulus())?;
        positive("factor of the dissipation", ratios.dissipation())?;
        positive("factor of the dissipation", ratios.dissipation_by_mass())?;
        positive("factor of the constant contact force", ratios.constant_contact_force())?;
        positive("factor of the hertz smoothing", ratios.hertz_smoothing())?;
        positive("factor of the transition velocity", ratios.transition_velocity())?;
        Ok(ratios)
    }

    /// The ratios that lead from scale `a` to scale `b`.
    ///
    /// # Errors
    /// [`DomainError`] if a ratio leaves the range of `f64`.
    pub fn between(a: &Scale, b: &Scale) -> Result<Self, DomainError> {
        Self::new(RatioValues {
            mass: b.mass_kg() / a.mass_kg(),
            sphere_count: b.sphere_count() / a.sphere_count(),
            radius: b.radius_m() / a.radius_m(),
            gravity: b.gravity_m_s2() / a.gravity_m_s2(),
        })
    }

    /// The ratios of two isometric bodies: ρ = ∛μ, equal sphere counts, equal gravity.
    ///
    /// # Errors
    /// [`DomainError`] unless the mass ratio is finite and above 0.
    pub fn isometric(mass_ratio: f64) -> Result<Self, DomainError> {
        let radius = libm::cbrt(mass_ratio);
        Self::new(RatioValues { mass: mass_ratio, sphere_count: 1.0, radius, gravity: 1.0 })
    }

    /// The ratios of a scale to itself: every factor is exactly 1.
    #[must_use]
    pub fn identity() -> Self {
        Self(RatioValues { mass: 1.0, sphere_count: 1.0, radius: 1.0, gravity: 1.0 })
    }

    /// The four ratios, by name.
    #[must_use]
    pub fn values(&self) -> RatioValues {
        self.0
    }

    /// μ = M_b / M_a.
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.0.mass
    }

    /// n_b / n_a, which is 1/ν.
    #[must_use]
    pub fn sphere_count(&self) -> f64 {
        self.0.sphere_count
    }

    /// ρ = R_b / R_a.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.0.radius
    }

    /// γ = g_b / g_a.
    #[must_use]
    pub fn gravity(&self) -> f64 {
        self.0.gravity
    }

    /// Factor of E* and of E₁* (`stiffness`): μ ν / ρ² · γ.
    ///
    /// It keeps the relative indentation x̂ at body weight. Source: (8) to (10); γ is the gravity extension.
    #[must_use]
    pub fn plane_strain_modulus(&self) -> f64 {
        self.mass() / self.sphere_count() / (self.radius() * self.radius()) * self.gravity()
    }

    /// Factor of α (`dissipation`): ρ^(−1/2) γ^(−1/2).
    ///
    /// It keeps α times a speed that grows as √(g R), and with it the restitution. Source: (14).
    #[must_use]
    pub fn dissipation(&self) -> f64 {
        1.0 / (self.radius() * self.gravity()).sqrt()
    }

    /// Factor of α (`dissipation`) by mass instead of radius: μ^(−1/6) γ^(−1/2).
    ///
    /// The same as [`Ratios::dissipation`] where R ∝ M^(1/3). Source: (14), its other proportionality.
    #[must_use]
    pub fn dissipation_by_mass(&self) -> f64 {
        1.0 / (libm::cbrt(self.mass()) * self.gravity()).sqrt()
    }

    /// Factor of cf (`constant_contact_force`, m²): ρ².
    ///
    /// It keeps the constant relative indentation √cf / R. Source: (C.2).
    #[must_use]
    pub fn constant_contact_force(&self) -> f64 {
        self.radius() * self.radius()
    }

    /// Factor of bd (`hertz_smoothing`, 1/m): 1/ρ.
    ///
    /// It keeps the share of R over which contact sets in, bd R. Source: (C.5).
    #[must_use]
    pub fn hertz_smoothing(&self) -> f64 {
        1.0 / self.radius()
    }

    /// Factor of bv (`hunt_crossley_smoothing`, s/m): ρ^(−1/2) γ^(−1/2).
    ///
    /// It keeps bv √(g R). Source: (C.10); γ is the gravity extension.
    #[must_use]
    pub fn hunt_crossley_smoothing(&self) -> f64 {
        self.dissipation()
    }

    /// Factor of `transition_velocity` (m/s): √(γ ρ).
    ///
    /// A speed grows as √(g R). Source: the friction extension, not in the paper.
    #[must_use]
    pub fn transition_velocity(&self) -> f64 {
        (self.gravity() * self.radius()).sqrt()
    }

    /// Factor of `viscous_friction` (s/m): 1/√(γ ρ).
    ///
    /// An inverse speed. Source: the friction extension, not in the paper.
    #[must_use]
    pub fn viscous_friction(&self) -> f64 {
        self.dissipation()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ScaleValues;
    use proptest::prelude::*;

    type Factor = fn(&Ratios) -> f64;

    /// Each factor with its exponents in μ, ν, ρ, γ (theory: the table under (C.10)).
    const FACTORS: [(&str, Factor, [f64; 4]); 8] = [
        ("stiffness", Ratios::plane_strain_modulus, [1.0, 1.0, -2.0, 1.0]),
        ("dissipation", Ratios::dissipation, [0.0, 0.0, -0.5, -0.5]),
        ("dissipation by mass", Ratios::dissipation_by_mass, [-1.0 / 6.0, 0.0, 0.0, -0.5]),
        ("constant_contact_force", Ratios::constant_contact_force, [0.0, 0.0, 2.0, 0.0]),
        ("hertz_smoothing", Ratios::hertz_smoothing, [0.0, 0.0, -1.0, 0.0]),
        ("hunt_crossley_smoothing", Ratios::hunt_crossley_smoothing, [0.0, 0.0, -0.5, -0.5]),
        ("transition_velocity", Ratios::transition_velocity, [0.0, 0.0, 0.5, 0.5]),
        ("viscous_friction", Ratios::viscous_friction, [0.0, 0.0, -0.5, -0.5]),
    ];

    #[test]
    fn identity_is_exactly_one_in_every_factor() {
        for (name, factor, _) in FACTORS {
            assert_eq!(factor(&Ratios::identity()), 1.0, "{name}");
            assert_eq!(factor(&Ratios::isometric(1.0).unwrap()), 1.0, "{name}");
        }
    }

    #[test]
    fn a_scale_has_the_ratio_one_to_itself() {
        let scale =
            Scale::new(ScaleValues { mass_kg: 0.1, radius_m: 0.3, sphere_count: 7.0, gravity_m_s2: 9.80665 });
        let scale = scale.unwrap();
        assert_eq!(Ratios::between(&scale, &scale).unwrap(), Ratios::identity());
    }

    #[test]
    fn isometric_radius_is_the_cube_root() {
        assert_eq!(Ratios::isometric(8.0).unwrap().radius(), 2.0);
        assert_eq!(Ratios::isometric(0.001).unwrap().radius(), 0.1);
        for refused in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Ratios::isometric(refused).unwrap_err().quantity(), "mass ratio");
        }
    }

    #[test]
    fn ratios_whose_factors_leave_f64_are_refused() {
        let far = RatioValues { mass: 1e300, sphere_count: 1.0, radius: 1e-100, gravity: 1.0 };
        assert_eq!(Ratios::new(far).unwrap_err().quantity(), "factor of the plane strain modulus");
    }

    prop_compose! {
        fn any_ratios()(mass in 1e-6..1e6, sphere_count in 0.05..20.0, radius in 1e-3..1e3, gravity in 0.05..20.0)
            -> Ratios {
            Ratios::new(RatioValues { mass, sphere_count, radius, gravity }).unwrap()
        }
    }

    proptest! {
        #[test]
        fn factors_are_the_declared_powers(r in any_ratios()) {
            for (name, factor, [mu, nu, rho, gamma]) in FACTORS {
                let expected = r.mass().powf(mu) * r.sphere_count().powf(-nu) * r.radius().powf(rho) * r.gravity().powf(gamma);
                prop_assert!((factor(&r) / expected - 1.0).abs() < 1e-13, "{name}");
            }
        }

        #[test]
        fn two_steps_equal_one(a in any_ratios(), b in any_ratios()) {
            let direct = Ratios::new(RatioValues {
                mass: a.mass() * b.mass(),
                sphere_count: a.sphere_count() * b.sphere_count(),
                radius: a.radius() * b.radius(),
                gravity: a.gravity() * b.gravity(),
            }).unwrap();
            for (name, factor, _) in FACTORS {
                prop_assert!((factor(&a) * factor(&b) / factor(&direct) - 1.0).abs() < 1e-14, "{name}");
            }
        }
    }
}
