//! The scale of a body with contact spheres, a load and the spheres that share it, and the scaling factors between two scales.

use crate::error::{Result, require_at_least_one, require_positive};

/// The four numbers of a [`Scale`], by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaleValues {
    /// Body mass M that the contacts carry, in kg.
    pub mass_kg: f64,
    /// Sphere radius R, in m.
    pub radius_m: f64,
    /// Number n of spheres that share the body weight; a mean over feet need not be a whole number.
    pub sphere_count: f64,
    /// Magnitude of the gravitational acceleration g, in m/s².
    pub gravity_m_s2: f64,
}

/// The scale of a body: the quantities by which its contact parameters are made dimensionless.
///
/// M > 0, R > 0, g > 0 and n ≥ 1, all finite: checked once, in [`Scale::new`].
///
/// ```
/// use contact_scaling::{Scale, ScaleValues};
/// let values = ScaleValues { mass_kg: 62.0, radius_m: 0.032, sphere_count: 6.0, gravity_m_s2: 9.81 };
/// assert!((Scale::new(values)?.load_per_sphere_n() - 101.37).abs() < 1e-12);
/// assert!(Scale::new(ScaleValues { radius_m: 0.0, ..values }).is_err());
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale(ScaleValues);

impl Scale {
    /// Checks mass, radius, sphere count and gravity of a body, and makes a scale of them.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless M, R and g are finite and above 0, and n is finite and at least 1.
    pub fn new(values: ScaleValues) -> Result<Self> {
        require_positive("mass", values.mass_kg)?;
        require_positive("sphere radius", values.radius_m)?;
        require_at_least_one("sphere count", values.sphere_count)?;
        require_positive("gravity", values.gravity_m_s2)?;
        Ok(Self(values))
    }

    /// A scale of numbers that are known to be valid.
    pub(crate) fn unchecked(values: ScaleValues) -> Self {
        Self(values)
    }

    /// Mass, radius, number of spheres and gravity, by name.
    pub fn values(&self) -> ScaleValues {
        self.0
    }

    /// Body mass M, in kg.
    pub fn mass_kg(&self) -> f64 {
        self.0.mass_kg
    }

    /// Sphere radius R, in m.
    pub fn radius_m(&self) -> f64 {
        self.0.radius_m
    }

    /// Number n of spheres that share the body weight.
    pub fn sphere_count(&self) -> f64 {
        self.0.sphere_count
    }

    /// Gravitational acceleration g, in m/s².
    pub fn gravity_m_s2(&self) -> f64 {
        self.0.gravity_m_s2
    }

    /// Body weight M g, in N.
    pub fn body_weight_n(&self) -> f64 {
        self.mass_kg() * self.gravity_m_s2()
    }

    /// Body weight on each sphere, M g / n, in N: the load in (4).
    pub fn load_per_sphere_n(&self) -> f64 {
        self.body_weight_n() / self.sphere_count()
    }

    /// √(g R), in m/s: the speed by which the speeds of the contact are made dimensionless.
    pub fn speed_m_s(&self) -> f64 {
        (self.gravity_m_s2() * self.radius_m()).sqrt()
    }

    /// √(R / g), in s: the time by which the times of the contact are made dimensionless (Fig. 4).
    pub fn time_s(&self) -> f64 {
        (self.radius_m() / self.gravity_m_s2()).sqrt()
    }
}

// A load and the spheres that share it.

/// A total load F, in N, on n spheres that share it equally (4).
///
/// F > 0 and n ≥ 1, finite: checked once. The load may be body weight, a multiple of it, or another force such as a bite.
///
/// ```
/// # use contact_scaling::SharedLoad;
/// assert_eq!(SharedLoad::new(600.0, 6.0)?.per_sphere_n(), 100.0);
/// assert!(SharedLoad::new(600.0, 0.5).is_err());
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SharedLoad {
    load_n: f64,
    sphere_count: f64,
}

impl SharedLoad {
    /// The load F (N) on n spheres.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless F is finite and above 0, and n finite and at least 1.
    pub fn new(load_n: f64, sphere_count: f64) -> Result<Self> {
        Ok(Self {
            load_n: require_positive("load", load_n)?,
            sphere_count: require_at_least_one("sphere count", sphere_count)?,
        })
    }

    /// The body weight of `scale` times `multiple`, on the spheres of `scale`.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless the load is finite and above 0.
    pub fn body_weights(scale: &Scale, multiple: f64) -> Result<Self> {
        Self::new(require_positive("body weights", multiple)? * scale.body_weight_n(), scale.sphere_count())
    }

    /// The total load F, in N.
    pub fn load_n(&self) -> f64 {
        self.load_n
    }

    /// Number n of spheres that share the load.
    pub fn sphere_count(&self) -> f64 {
        self.sphere_count
    }

    /// The load on each sphere, F / n, in N.
    pub fn per_sphere_n(&self) -> f64 {
        self.load_n / self.sphere_count
    }
}

// The factors that carry every contact parameter from one scale to another: (8) to (10), (14), (C.2),
// (C.5), (C.10), and two extensions of the same argument, gravity and friction.
//
// With ρ = R_b/R_a, μ = M_b/M_a, ν = n_a/n_b and γ = g_b/g_a. Each factor is formed first and the parameter
// multiplied once, so that a ratio of exactly 1 changes no bit of it.

/// The four ratios between two scales, target divided by origin, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatioValues {
    /// μ = M_b / M_a.
    pub mass: f64,
    /// 1/ν = n_b / n_a, of the spheres that share the body weight.
    pub sphere_count: f64,
    /// ρ = R_b / R_a.
    pub radius: f64,
    /// γ = g_b / g_a; 1 unless the target has another gravity.
    pub gravity: f64,
}

/// The ratios between the target and the origin of a rescaling, and the factors of all contact parameters.
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
    /// Checks the four ratios, and makes them available as factors.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless each ratio, and each factor formed from them, is finite and above 0.
    pub fn new(values: RatioValues) -> Result<Self> {
        require_positive("mass ratio", values.mass)?;
        require_positive("sphere count ratio", values.sphere_count)?;
        require_positive("radius ratio", values.radius)?;
        require_positive("gravity ratio", values.gravity)?;
        let ratios = Self(values);
        require_positive("factor of the plane strain modulus", ratios.plane_strain_modulus())?;
        require_positive("factor of the dissipation", ratios.dissipation())?;
        require_positive("factor of the dissipation", ratios.dissipation_by_mass())?;
        require_positive("factor of the constant contact force", ratios.constant_contact_force())?;
        require_positive("factor of the hertz smoothing", ratios.hertz_smoothing())?;
        require_positive("factor of the transition velocity", ratios.transition_velocity())?;
        Ok(ratios)
    }

    /// The ratios from scale `a` to scale `b`.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) if a ratio leaves the range of `f64`.
    pub fn between(a: &Scale, b: &Scale) -> Result<Self> {
        Self::new(RatioValues {
            mass: b.mass_kg() / a.mass_kg(),
            sphere_count: b.sphere_count() / a.sphere_count(),
            radius: b.radius_m() / a.radius_m(),
            gravity: b.gravity_m_s2() / a.gravity_m_s2(),
        })
    }

    /// The ratios of two geometrically similar bodies: ρ = ∛μ, equal sphere counts, equal gravity.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless the mass ratio is finite and above 0.
    pub fn isometric(mass_ratio: f64) -> Result<Self> {
        let radius = libm::cbrt(mass_ratio);
        Self::new(RatioValues { mass: mass_ratio, sphere_count: 1.0, radius, gravity: 1.0 })
    }

    /// The ratios of a scale to itself: every factor is exactly 1.
    pub fn identity() -> Self {
        Self(RatioValues { mass: 1.0, sphere_count: 1.0, radius: 1.0, gravity: 1.0 })
    }

    /// The four ratios, by name.
    pub fn values(&self) -> RatioValues {
        self.0
    }

    /// μ = M_b / M_a.
    pub fn mass(&self) -> f64 {
        self.0.mass
    }

    /// n_b / n_a = 1/ν.
    pub fn sphere_count(&self) -> f64 {
        self.0.sphere_count
    }

    /// ρ = R_b / R_a.
    pub fn radius(&self) -> f64 {
        self.0.radius
    }

    /// γ = g_b / g_a.
    pub fn gravity(&self) -> f64 {
        self.0.gravity
    }

    /// Factor of E* and of E₁* (`stiffness`): μ ν / ρ² · γ.
    ///
    /// With this factor the relative indentation x̂ under body weight stays. Source: (8) to (10); γ is the gravity extension.
    pub fn plane_strain_modulus(&self) -> f64 {
        self.mass() / self.sphere_count() / (self.radius() * self.radius()) * self.gravity()
    }

    /// Factor of α (`dissipation`): ρ^(−1/2) γ^(−1/2).
    ///
    /// With this factor α times a speed ∝ √(g R) stays, and so does the restitution. Source: (14).
    pub fn dissipation(&self) -> f64 {
        1.0 / (self.radius() * self.gravity()).sqrt()
    }

    /// Factor of α (`dissipation`) by mass instead of radius: μ^(−1/6) γ^(−1/2).
    ///
    /// It is equal to [`Ratios::dissipation`] if R ∝ M^(1/3). Source: (14), its second proportionality.
    pub fn dissipation_by_mass(&self) -> f64 {
        1.0 / (libm::cbrt(self.mass()) * self.gravity()).sqrt()
    }

    /// Factor of cf (`constant_contact_force`, m²): ρ².
    ///
    /// With this factor the constant relative indentation √cf / R stays. Source: (C.2).
    pub fn constant_contact_force(&self) -> f64 {
        self.radius() * self.radius()
    }

    /// Factor of bd (`hertz_smoothing`, 1/m): 1/ρ.
    ///
    /// With this factor bd R stays: contact begins over the same share of R. Source: (C.5).
    pub fn hertz_smoothing(&self) -> f64 {
        1.0 / self.radius()
    }

    /// Factor of bv (`hunt_crossley_smoothing`, s/m): ρ^(−1/2) γ^(−1/2).
    ///
    /// With this factor bv √(g R) stays. Source: (C.10); γ is the gravity extension.
    pub fn hunt_crossley_smoothing(&self) -> f64 {
        self.dissipation()
    }

    /// Factor of `transition_velocity` (m/s): √(γ ρ).
    ///
    /// The velocity is scaled like other speeds, ∝ √(g R). Source: the friction extension, not in the paper.
    pub fn transition_velocity(&self) -> f64 {
        (self.gravity() * self.radius()).sqrt()
    }

    /// Factor of `viscous_friction` (s/m): 1/√(γ ρ).
    ///
    /// It is the inverse of the factor of speeds. Source: the friction extension, not in the paper.
    pub fn viscous_friction(&self) -> f64 {
        self.dissipation()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const HUMAN_SCALE: ScaleValues =
        ScaleValues { mass_kg: 62.0, radius_m: 0.032, sphere_count: 6.0, gravity_m_s2: 9.81 };

    #[test]
    fn every_field_is_checked_by_name() {
        let refused = |values| Scale::new(values).unwrap_err().quantity();
        assert_eq!(refused(ScaleValues { mass_kg: 0.0, ..HUMAN_SCALE }), "mass");
        assert_eq!(refused(ScaleValues { radius_m: f64::NAN, ..HUMAN_SCALE }), "sphere radius");
        assert_eq!(refused(ScaleValues { sphere_count: 0.5, ..HUMAN_SCALE }), "sphere count");
        assert_eq!(refused(ScaleValues { gravity_m_s2: 0.0, ..HUMAN_SCALE }), "gravity");
    }

    #[test]
    fn reference_quantities_have_their_dimensions() {
        // Other units: metres × 2, kilograms × 3, seconds × 5.
        let (l, m, t) = (2.0, 3.0, 5.0);
        let a = Scale::new(HUMAN_SCALE).unwrap();
        let b = Scale::new(ScaleValues {
            mass_kg: 62.0 * m,
            radius_m: 0.032 * l,
            sphere_count: 6.0,
            gravity_m_s2: 9.81 * l / (t * t),
        })
        .unwrap();
        let close = |x: f64, y: f64| assert!((x / y - 1.0).abs() < 1e-14, "{x} {y}");
        close(b.body_weight_n(), a.body_weight_n() * m * l / (t * t));
        close(b.load_per_sphere_n(), a.load_per_sphere_n() * m * l / (t * t));
        close(b.speed_m_s(), a.speed_m_s() * l / t);
        close(b.time_s(), a.time_s() * t);
    }

    type Factor = fn(&Ratios) -> f64;

    /// Each factor with its exponents of μ, ν, ρ, γ (from the table under (C.10)).
    const FACTORS_AND_EXPONENTS: [(&str, Factor, [f64; 4]); 8] = [
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
        for (name, factor, _) in FACTORS_AND_EXPONENTS {
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
    fn ratios_with_factors_outside_f64_are_refused() {
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
            for (name, factor, [mu, nu, rho, gamma]) in FACTORS_AND_EXPONENTS {
                let expected = r.mass().powf(mu) * r.sphere_count().powf(-nu) * r.radius().powf(rho) * r.gravity().powf(gamma);
                prop_assert!((factor(&r) / expected - 1.0).abs() < 1e-13, "{name}");
            }
        }

        #[test]
        fn two_scalings_in_turn_equal_one(a in any_ratios(), b in any_ratios()) {
            let direct = Ratios::new(RatioValues {
                mass: a.mass() * b.mass(),
                sphere_count: a.sphere_count() * b.sphere_count(),
                radius: a.radius() * b.radius(),
                gravity: a.gravity() * b.gravity(),
            }).unwrap();
            for (name, factor, _) in FACTORS_AND_EXPONENTS {
                prop_assert!((factor(&a) * factor(&b) / factor(&direct) - 1.0).abs() < 1e-14, "{name}");
            }
        }
    }
}
