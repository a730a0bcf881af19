//! The smoothed law of OpenSim's `SmoothSphereHalfSpaceForce`: (C.1), (C.3), (C.4), (C.9).

use crate::error::{Result, require_non_negative, require_positive};
use crate::{Contact, Hertz, SmoothingValues, smoothing};

/// The normal force of one `SmoothSphereHalfSpaceForce`.
///
/// α ≥ 0, cf ≥ 0, bd > 0, bv > 0, all finite: checked once. Indentation x in m, negative before contact; its rate ẋ in m/s,
/// positive while the indentation grows. NaN gives NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothSphere {
    hertz: Hertz,
    dissipation: f64,
    smoothing: SmoothingValues,
    /// The speed state at ẋ = 0, without unit.
    at_rest: f64,
}

impl SmoothSphere {
    /// A Hertz law with the dissipation α (s/m) and smoothing.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless α ≥ 0, cf ≥ 0, bd > 0 and bv > 0, all finite.
    pub fn new(hertz: Hertz, dissipation: f64, smoothing: SmoothingValues) -> Result<Self> {
        require_non_negative("dissipation", dissipation)?;
        require_non_negative("constant contact force", smoothing.constant_contact_force)?;
        require_positive("hertz smoothing", smoothing.hertz_smoothing)?;
        require_positive("hunt crossley smoothing", smoothing.hunt_crossley_smoothing)?;
        let mut law = Self { hertz, dissipation, smoothing, at_rest: 1.0 };
        law.at_rest = law.speed_state(0.0);
        Ok(law)
    }

    /// The smoothed law of a sphere of radius R (m) with the parameters `contact` of a model file; without smoothing in
    /// `contact`, OpenSim's default smoothing is used.
    ///
    /// # Errors
    /// As [`Hertz::of`].
    pub fn of(contact: &Contact, radius_m: f64) -> Result<Self> {
        let smoothing = contact.smoothing().unwrap_or(SmoothingValues::OPENSIM_DEFAULT);
        Self::new(Hertz::of(contact, radius_m)?, contact.dissipation(), smoothing)
    }

    /// The Hertz law of the sphere, without smoothing and dissipation.
    pub fn hertz(&self) -> &Hertz {
        &self.hertz
    }

    /// Dissipation α, in s/m.
    pub fn dissipation(&self) -> f64 {
        self.dissipation
    }

    /// cf, bd and bv, by name.
    pub fn smoothing(&self) -> SmoothingValues {
        self.smoothing
    }

    /// Hertz force with the constant indentation, F_cf = 4/3 η √R E* (x² + cf)^(3/4), in N.
    ///
    /// x in m, cf in m², E* in N/m², R in m. The force is equal at x and −x, so that it is also above 0 before contact.
    ///
    /// Source: (C.1), printed there as √(x² + cf)^(3/2).
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let smoothing = SmoothingValues { constant_contact_force: 0.0, ..SmoothingValues::OPENSIM_DEFAULT };
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 2.0, smoothing)?;
    /// assert_eq!(law.constant_indentation_force(0.0625), 31250.0); // as (1)
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn constant_indentation_force(&self, indentation_m: f64) -> f64 {
        let root = (indentation_m * indentation_m + self.smoothing.constant_contact_force).sqrt();
        self.hertz.coefficient() * (root * root.sqrt())
    }

    /// Contact state, s_c = ½ + ½ tanh(bd x), from 0 to 1.
    ///
    /// x in m, bd in 1/m. ½ at x = 0.
    ///
    /// Source: (C.4).
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 2.0, SmoothingValues::OPENSIM_DEFAULT)?;
    /// assert_eq!(law.contact_state(0.0), 0.5);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn contact_state(&self, indentation_m: f64) -> f64 {
        0.5 + 0.5 * libm::tanh(self.smoothing.hertz_smoothing * indentation_m)
    }

    /// Smoothed elastic force, F_s = F_cf s_c(x), in N.
    ///
    /// x in m. The force is above 0 also before contact; smoothing has this purpose.
    ///
    /// Source: (C.3).
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 2.0, SmoothingValues::OPENSIM_DEFAULT)?;
    /// assert_eq!(law.elastic_force(0.0), 0.5 * law.constant_indentation_force(0.0));
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn elastic_force(&self, indentation_m: f64) -> f64 {
        self.constant_indentation_force(indentation_m) * self.contact_state(indentation_m)
    }

    /// Speed state, ½ + ½ tanh(bv (ẋ + 2/(3α))): the share of the force that smoothing leaves at a speed, from 0 to 1.
    ///
    /// Near 0 where the contact separates so fast that the force would pull, near 1 at all other speeds. ẋ in m/s, bv in s/m,
    /// α in s/m. ½ at the speed where F_d = −F_e; 1 for α = 0.
    ///
    /// Source: (C.9), its second factor.
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 2.0, SmoothingValues::OPENSIM_DEFAULT)?;
    /// assert_eq!(law.speed_state(-2.0 / 6.0), 0.5);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn speed_state(&self, speed_m_s: f64) -> f64 {
        smoothing::speed_state(self.dissipation, self.smoothing.hunt_crossley_smoothing, speed_m_s)
    }

    /// Smoothed normal force, F = (F_s + 3/2 F_s α ẋ)(½ + ½ tanh(bv (ẋ + 2/(3α)))), in N.
    ///
    /// x in m, ẋ in m/s. A pulling force is reduced, but not excluded: F can be slightly below 0.
    ///
    /// Source: (C.9).
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 0.0, SmoothingValues::OPENSIM_DEFAULT)?;
    /// assert_eq!(law.force(0.01, -3.0), law.elastic_force(0.01)); // α = 0
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn force(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        let elastic = self.elastic_force(indentation_m);
        elastic * (1.0 + 1.5 * self.dissipation * speed_m_s) * self.speed_state(speed_m_s)
    }

    /// Normal force at speed 0, F = F_s (½ + ½ tanh(2 bv/(3α))), in N.
    ///
    /// x in m, bv in s/m, α in s/m. This force carries a body at equilibrium; it is less than (C.3) if α is large compared
    /// with bv.
    ///
    /// Source: (C.9) at ẋ = 0.
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 20.0, SmoothingValues::OPENSIM_DEFAULT)?;
    /// assert_eq!(law.rest_force(0.01), law.force(0.01, 0.0));
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn rest_force(&self, indentation_m: f64) -> f64 {
        self.elastic_force(indentation_m) * self.at_rest
    }

    /// An upper bound (N) of the force at speed 0 between two indentations (m): F_cf grows with |x|, the contact state with
    /// x.
    pub(crate) fn rest_force_limit(&self, from_m: f64, to_m: f64) -> f64 {
        let farthest = from_m.abs().max(to_m.abs());
        self.constant_indentation_force(farthest) * self.contact_state(to_m) * self.at_rest
    }

    /// Stiffness at speed 0, ∂F/∂x = ∂F_s/∂x (½ + ½ tanh(2 bv/(3α))), in N/m.
    ///
    /// x in m, bv in s/m, α in s/m.
    ///
    /// Source: the derivative of (C.9) at ẋ = 0; not in the paper.
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 20.0, SmoothingValues::OPENSIM_DEFAULT)?;
    /// let slope = (law.force(0.01 + 1e-6, 0.0) - law.force(0.01 - 1e-6, 0.0)) / 2e-6;
    /// assert!((law.rest_stiffness(0.01) / slope - 1.0).abs() < 1e-6);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn rest_stiffness(&self, indentation_m: f64) -> f64 {
        self.stiffness(indentation_m) * self.at_rest
    }

    /// Stiffness of the smoothed elastic force, ∂F_s/∂x, in N/m.
    ///
    /// With u = x² + cf it is 4/3 η √R E* (3/2 x u^(−1/4) s_c + u^(3/4) · bd/2 · (1 − tanh²(bd x))); x in m.
    ///
    /// Source: the derivative of (C.3); not in the paper.
    ///
    /// ```
    /// # use contact_scaling::{Hertz, SmoothSphere, SmoothingValues};
    /// let law = SmoothSphere::new(Hertz::sphere(3e6, 0.25)?, 2.0, SmoothingValues::OPENSIM_DEFAULT)?;
    /// let slope = (law.elastic_force(0.01 + 1e-6) - law.elastic_force(0.01 - 1e-6)) / 2e-6;
    /// assert!((law.stiffness(0.01) / slope - 1.0).abs() < 1e-6);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn stiffness(&self, indentation_m: f64) -> f64 {
        let SmoothingValues { constant_contact_force, hertz_smoothing, .. } = self.smoothing;
        let root = (indentation_m * indentation_m + constant_contact_force).sqrt();
        if root == 0.0 {
            return 0.0;
        }
        let tanh = libm::tanh(hertz_smoothing * indentation_m);
        let hertz = 1.5 * indentation_m / root.sqrt() * (0.5 + 0.5 * tanh);
        let onset = root * root.sqrt() * (0.5 * hertz_smoothing * (1.0 - tanh * tanh));
        self.hertz.coefficient() * (hertz + onset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{HuntCrossley, falisse2022};
    use proptest::prelude::*;

    fn falisse(change: impl Fn(&mut SmoothingValues)) -> SmoothSphere {
        let contact = falisse2022().contact;
        let mut smoothing = contact.smoothing().unwrap();
        change(&mut smoothing);
        SmoothSphere::new(Hertz::of(&contact, 0.032).unwrap(), 2.0, smoothing).unwrap()
    }

    #[test]
    fn every_value_is_checked_by_name() {
        let hertz = Hertz::sphere(1e6, 0.032).unwrap();
        let good = SmoothingValues::OPENSIM_DEFAULT;
        let refused = |a, s| SmoothSphere::new(hertz, a, s).unwrap_err().quantity();
        assert_eq!(refused(-1.0, good), "dissipation");
        let cf = SmoothingValues { constant_contact_force: -1.0, ..good };
        assert_eq!(refused(1.0, cf), "constant contact force");
        let bd = SmoothingValues { hertz_smoothing: 0.0, ..good };
        assert_eq!(refused(1.0, bd), "hertz smoothing");
        let bv = SmoothingValues { hunt_crossley_smoothing: f64::INFINITY, ..good };
        assert_eq!(refused(1.0, bv), "hunt crossley smoothing");
    }

    #[test]
    fn with_negligible_smoothing_the_force_is_that_of_hunt_crossley() {
        // cf → 0, bd → ∞, bv → ∞.
        let sharp = falisse(|s| {
            s.constant_contact_force = 0.0;
            s.hertz_smoothing = 1e12;
            s.hunt_crossley_smoothing = 1e12;
        });
        let plain = HuntCrossley::new(*sharp.hertz(), 2.0).unwrap();
        for x in [-0.03, -1e-6, 0.0, 1e-6, 0.001, 0.02] {
            for speed in [-2.0, -0.4, -0.3, 0.0, 1.0] {
                let (a, b) = (sharp.force(x, speed), plain.force(x, speed));
                assert!((a - b).abs() <= 1e-15 * b.abs(), "{x} {speed}: {a} {b}");
            }
        }
    }

    #[test]
    fn limits_are_approached_one_by_one() {
        let hertz = *falisse(|_| ()).hertz();
        let (x, f) = (0.004, hertz.force(0.004));
        let mut last = f64::INFINITY;
        for cf in [1e-5, 1e-6, 1e-7, 1e-8] {
            let off =
                (falisse(|s| s.constant_contact_force = cf).constant_indentation_force(x) / f - 1.0).abs();
            assert!(off < last);
            last = off;
        }
        assert!(last < 1e-3);
        assert!((falisse(|s| s.hertz_smoothing = 1e4).contact_state(x) - 1.0).abs() < 1e-15);
        assert!((falisse(|s| s.hunt_crossley_smoothing = 1e3).speed_state(-0.3) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn no_constant_force_and_no_contact_have_no_slope() {
        let law = falisse(|s| s.constant_contact_force = 0.0);
        assert_eq!(law.stiffness(0.0), 0.0);
        assert_eq!(law.elastic_force(0.0), 0.0);
    }

    #[test]
    fn the_rest_force_is_the_force_at_speed_0() {
        for alpha in [0.0, 1e-9, 2.0, 20.0, 50.0, 1e9] {
            let law =
                SmoothSphere::new(*falisse(|_| ()).hertz(), alpha, SmoothingValues::OPENSIM_DEFAULT).unwrap();
            for x in [-0.01, 0.0, 0.004] {
                assert_eq!(law.rest_force(x), law.force(x, 0.0), "{alpha} {x}");
            }
        }
    }

    proptest! {
        #[test]
        fn contact_state_is_symmetric_about_one_half(x in -0.03..0.03) {
            let law = falisse(|_| ());
            prop_assert!((law.contact_state(x) + law.contact_state(-x) - 1.0).abs() < 1e-15);
        }

        #[test]
        fn stiffness_is_the_slope_of_the_force(x in -0.01..0.02) {
            let law = falisse(|_| ());
            let h = 1e-7;
            let slope = (law.elastic_force(x + h) - law.elastic_force(x - h)) / (2.0 * h);
            prop_assert!((slope - law.stiffness(x)).abs() < 1e-3 + 1e-6 * slope.abs());
        }
    }
}
