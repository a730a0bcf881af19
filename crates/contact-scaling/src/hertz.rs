//! The Hertz law of a sphere, (1) to (3), (B.1), (B.2), and the law of Hunt and Crossley (12), which adds dissipation.

use crate::Contact;
use crate::error::{Result, require_non_negative, require_positive};

/// The values of the Hertz law of one sphere, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzValues {
    /// E*, composite plane strain modulus, in N/m² (not OpenSim's `stiffness`, which is E₁*).
    pub composite_modulus: f64,
    /// R, in m: of the sphere on a half-space, R₁R₂/(R₁+R₂) for two spheres.
    pub radius_m: f64,
    /// η, 1 for spheres.
    pub shape_factor: f64,
}

/// The Hertz law of one sphere: F_e = 4/3 η √R E* x^(3/2).
///
/// E* > 0, R > 0 and η > 0, all finite: checked once. Its methods take any number for the indentation:
/// at x ≤ 0 there is no contact and no force, and NaN gives NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    values: HertzValues,
    /// 4/3 η √R E*, in N/m^(3/2).
    coefficient: f64,
}

impl Hertz {
    /// Checks the values and makes a law of them.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless E*, R and η are finite and above 0.
    pub fn new(values: HertzValues) -> Result<Self> {
        require_positive("composite modulus", values.composite_modulus)?;
        require_positive("sphere radius", values.radius_m)?;
        require_positive("shape factor", values.shape_factor)?;
        let coefficient = 4.0 / 3.0 * values.shape_factor * values.radius_m.sqrt() * values.composite_modulus;
        require_positive("force coefficient", coefficient)?;
        Ok(Self { values, coefficient })
    }

    /// The law of a sphere of radius R (m) with the composite modulus E* (N/m²); η is 1.
    ///
    /// # Errors
    /// As [`Hertz::new`].
    pub fn sphere(composite_modulus: f64, radius_m: f64) -> Result<Self> {
        Self::new(HertzValues { composite_modulus, radius_m, shape_factor: 1.0 })
    }

    /// The Hertz law of a sphere of radius R (m) with the parameters `contact` of a model file: E* = E₁* / 2^(3/2).
    ///
    /// # Errors
    /// As [`Hertz::new`].
    pub fn of(contact: &Contact, radius_m: f64) -> Result<Self> {
        Self::sphere(contact.composite_modulus(), radius_m)
    }

    /// E*, R and η, by name.
    pub fn values(&self) -> HertzValues {
        self.values
    }

    /// Radius R of the sphere, in m.
    pub fn radius_m(&self) -> f64 {
        self.values.radius_m
    }

    /// 4/3 η √R E*, in N/m^(3/2): the force at x is this times x^(3/2).
    pub fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// Relative indentation x̂ = x / R.
    ///
    /// x in m; R of this sphere in m; x̂ has no unit. Any x.
    ///
    /// Source: (2).
    ///
    /// ```
    /// # use contact_scaling::Hertz;
    /// assert_eq!(Hertz::sphere(1e6, 0.5)?.relative_indentation(0.25), 0.5);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn relative_indentation(&self, indentation_m: f64) -> f64 {
        indentation_m / self.values.radius_m
    }

    /// Indentation x = x̂ R, in m.
    ///
    /// x̂ without unit; R of this sphere in m. Any x̂.
    ///
    /// Source: (2), solved for x.
    ///
    /// ```
    /// # use contact_scaling::Hertz;
    /// assert_eq!(Hertz::sphere(1e6, 0.5)?.indentation(0.5), 0.25);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn indentation(&self, relative_indentation: f64) -> f64 {
        relative_indentation * self.values.radius_m
    }

    /// Elastic force F_e = 4/3 η √R E* x^(3/2), in N.
    ///
    /// x in m, E* in N/m², R in m. The force is 0 without contact, at x ≤ 0.
    ///
    /// Source: (1).
    ///
    /// ```
    /// # use contact_scaling::Hertz;
    /// let law = Hertz::sphere(3e6, 0.25)?;
    /// assert_eq!(law.force(0.0625), 31250.0); // 4/3 · 0.5 · 3e6 · 0.25³
    /// assert_eq!(law.force(-0.01), 0.0);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn force(&self, indentation_m: f64) -> f64 {
        if indentation_m <= 0.0 { 0.0 } else { self.coefficient * (indentation_m * indentation_m.sqrt()) }
    }

    /// Elastic force from the relative indentation: F_e = 4/3 η R² E* x̂^(3/2), in N.
    ///
    /// x̂ without unit, E* in N/m², R in m. 0 at x̂ ≤ 0.
    ///
    /// Source: (3).
    ///
    /// ```
    /// # use contact_scaling::Hertz;
    /// assert_eq!(Hertz::sphere(3e6, 0.25)?.force_at_relative_indentation(0.25), 31250.0);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn force_at_relative_indentation(&self, relative_indentation: f64) -> f64 {
        let HertzValues { composite_modulus, radius_m, shape_factor } = self.values;
        if relative_indentation <= 0.0 {
            return 0.0;
        }
        let power = relative_indentation * relative_indentation.sqrt();
        4.0 / 3.0 * shape_factor * (radius_m * radius_m) * composite_modulus * power
    }

    /// Indentation at which the force is F_e: x = (F_e / (4/3 η √R E*))^(2/3), in m.
    ///
    /// F_e in N, 0 or above.
    ///
    /// Source: (1), solved for x.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) if the force is negative or not finite, because the law never pulls.
    ///
    /// ```
    /// # use contact_scaling::Hertz;
    /// let law = Hertz::sphere(3e6, 0.25)?;
    /// assert!((law.indentation_from_force(31250.0)? - 0.0625).abs() < 1e-16);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn indentation_from_force(&self, force_n: f64) -> Result<f64> {
        Ok(depth(require_non_negative("force", force_n)?, self.coefficient))
    }

    /// Stiffness k = ∂F_e/∂x = 2 η √R E* √x, in N/m.
    ///
    /// x in m, E* in N/m², R in m. 0 at x ≤ 0.
    ///
    /// Source: (B.1).
    ///
    /// ```
    /// # use contact_scaling::Hertz;
    /// assert_eq!(Hertz::sphere(3e6, 0.25)?.stiffness(0.0625), 750_000.0); // 3/2 F / x
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn stiffness(&self, indentation_m: f64) -> f64 {
        if indentation_m <= 0.0 { 0.0 } else { 1.5 * self.coefficient * indentation_m.sqrt() }
    }

    /// Stiffness from the relative indentation: k = 2 η R E* √x̂, in N/m.
    ///
    /// x̂ without unit, E* in N/m², R in m. 0 at x̂ ≤ 0.
    ///
    /// Source: (B.2).
    ///
    /// ```
    /// # use contact_scaling::Hertz;
    /// assert_eq!(Hertz::sphere(3e6, 0.25)?.stiffness_at_relative_indentation(0.25), 750_000.0);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn stiffness_at_relative_indentation(&self, relative_indentation: f64) -> f64 {
        let HertzValues { composite_modulus, radius_m, shape_factor } = self.values;
        if relative_indentation <= 0.0 {
            return 0.0;
        }
        2.0 * shape_factor * radius_m * composite_modulus * relative_indentation.sqrt()
    }
}

/// The depth d with `coefficient` d^(3/2) = `force`: (1) solved for x, or (3) solved for x̂, depending on the coefficient.
///
/// All indentations by the Hertz law are computed here.
pub(crate) fn depth(force: f64, coefficient: f64) -> f64 {
    let root = libm::cbrt(force / coefficient);
    root * root
}

// The Hunt–Crossley law of a sphere: Hertz force with dissipation (12), as OpenSim's `HuntCrossleyForce`.

/// The normal force of one sphere of a `HuntCrossleyForce`.
///
/// α ≥ 0 and finite: checked once. Indentation x in m, its rate ẋ in m/s, positive while the indentation grows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HuntCrossley {
    hertz: Hertz,
    dissipation: f64,
}

impl HuntCrossley {
    /// A Hertz law with the dissipation α (s/m).
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless α is finite and 0 or above.
    pub fn new(hertz: Hertz, dissipation: f64) -> Result<Self> {
        Ok(Self { hertz, dissipation: require_non_negative("dissipation", dissipation)? })
    }

    /// The Hunt–Crossley law of a sphere of radius R (m) with the parameters `contact` of a model file; its smoothing is
    /// ignored.
    ///
    /// # Errors
    /// As [`Hertz::of`].
    pub fn of(contact: &Contact, radius_m: f64) -> Result<Self> {
        Self::new(Hertz::of(contact, radius_m)?, contact.dissipation())
    }

    /// The elastic part of the law.
    pub fn hertz(&self) -> &Hertz {
        &self.hertz
    }

    /// Dissipation α, in s/m.
    pub fn dissipation(&self) -> f64 {
        self.dissipation
    }

    /// Dissipative force F_d = 3/2 F_e α ẋ, in N.
    ///
    /// F_e in N by (1) at x (m), α in s/m, ẋ in m/s. Negative while the indentation decreases; 0 at x ≤ 0.
    ///
    /// Source: (12).
    ///
    /// ```
    /// # use contact_scaling::{Hertz, HuntCrossley};
    /// let law = HuntCrossley::new(Hertz::sphere(3e6, 0.25)?, 2.0)?;
    /// assert!((law.dissipative_force(0.0625, 0.1) - 0.3 * 31250.0).abs() < 1e-9);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn dissipative_force(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        self.hertz.force(indentation_m) * (1.5 * self.dissipation * speed_m_s)
    }

    /// Normal force F_c = F_e + F_d = F_e (1 + 3/2 α ẋ), in N; never below 0.
    ///
    /// x in m, ẋ in m/s. If the sum is below 0, at ẋ < −2/(3α), the result is 0, as in Simbody.
    ///
    /// Source: (12), with the lower bound of Simbody's `HuntCrossleyForce`.
    ///
    /// ```
    /// # use contact_scaling::{Hertz, HuntCrossley};
    /// let law = HuntCrossley::new(Hertz::sphere(3e6, 0.25)?, 2.0)?;
    /// assert_eq!(law.force(0.0625, 0.0), 31250.0);
    /// assert_eq!(law.force(0.0625, -0.5), 0.0);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn force(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        let force = self.hertz.force(indentation_m) * (1.0 + 1.5 * self.dissipation * speed_m_s);
        if force < 0.0 { 0.0 } else { force }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn every_value_is_checked_by_name() {
        let refused = |e, r, s| {
            let values = HertzValues { composite_modulus: e, radius_m: r, shape_factor: s };
            Hertz::new(values).unwrap_err().quantity()
        };
        assert_eq!(refused(0.0, 1.0, 1.0), "composite modulus");
        assert_eq!(refused(1.0, -1.0, 1.0), "sphere radius");
        assert_eq!(refused(1.0, 1.0, f64::NAN), "shape factor");
        assert_eq!(refused(1e300, 1e200, 1.0), "force coefficient");
    }

    #[test]
    fn without_contact_the_force_is_0_and_nan_stays_nan() {
        let law = Hertz::sphere(1e6, 0.032).unwrap();
        for f in [Hertz::force, Hertz::stiffness, Hertz::force_at_relative_indentation] {
            assert_eq!(f(&law, 0.0), 0.0);
            assert_eq!(f(&law, -1.0), 0.0);
            assert!(f(&law, f64::NAN).is_nan());
        }
        assert!(law.indentation_from_force(-1.0).is_err());
    }

    proptest! {
        #[test]
        fn forms_agree_and_inverses_round_trip(e in 1e3..1e9, r in 1e-3..1.0, x_hat in 1e-6..1.0) {
            let law = Hertz::sphere(e, r).unwrap();
            let x = law.indentation(x_hat);
            let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-14;
            prop_assert!(close(law.force(x), law.force_at_relative_indentation(x_hat)));
            prop_assert!(close(law.stiffness(x), law.stiffness_at_relative_indentation(x_hat)));
            prop_assert!(close(law.indentation_from_force(law.force(x)).unwrap(), x));
            prop_assert!(close(law.relative_indentation(x), x_hat));
        }

        #[test]
        fn stiffness_is_the_slope_of_the_force(x in 1e-4..1e-2) {
            let law = Hertz::sphere(1e6, 0.032).unwrap();
            let h = 1e-5 * x;
            let slope = (law.force(x + h) - law.force(x - h)) / (2.0 * h);
            prop_assert!((slope / law.stiffness(x) - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn force_is_elastic_plus_dissipative_force_unless_the_sum_is_negative() {
        let law = HuntCrossley::new(Hertz::sphere(1e6, 0.032).unwrap(), 0.7).unwrap();
        for speed in [-0.9, -0.1, 0.0, 0.3, 5.0] {
            let sum = law.hertz().force(0.004) + law.dissipative_force(0.004, speed);
            assert!((law.force(0.004, speed) / sum - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn without_dissipation_speed_does_not_matter() {
        let hertz = Hertz::sphere(1e6, 0.032).unwrap();
        let law = HuntCrossley::new(hertz, 0.0).unwrap();
        assert_eq!(law.force(0.004, -100.0), hertz.force(0.004));
        assert_eq!(HuntCrossley::new(hertz, -1.0).unwrap_err().quantity(), "dissipation");
    }
}
