//! The scale of a body with contact spheres: mass, radius, sphere count, gravity.

use crate::error::{DomainError, at_least_one, positive};

/// The four numbers of a [`Scale`], by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaleValues {
    /// Body mass M that the contacts carry, in kg.
    pub mass_kg: f64,
    /// Sphere radius R, in m.
    pub radius_m: f64,
    /// Distinct spheres n that share the body weight; a mean over feet need not be whole.
    pub sphere_count: f64,
    /// Magnitude of the gravitational acceleration g, in m/s².
    pub gravity_m_s2: f64,
}

/// The scale of a body: everything its dimensionless contact parameters are formed with.
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
    /// Checks the four numbers and keeps them.
    ///
    /// # Errors
    /// [`DomainError`] unless M, R and g are finite and above 0, and n is finite and at least 1.
    pub fn new(values: ScaleValues) -> Result<Self, DomainError> {
        positive("mass", values.mass_kg)?;
        positive("sphere radius", values.radius_m)?;
        at_least_one("sphere count", values.sphere_count)?;
        positive("gravity", values.gravity_m_s2)?;
        Ok(Self(values))
    }

    /// Keeps numbers that are known to be valid.
    pub(crate) fn unchecked(values: ScaleValues) -> Self {
        Self(values)
    }

    /// The four numbers, by name.
    #[must_use]
    pub fn values(&self) -> ScaleValues {
        self.0
    }

    /// Body mass M, in kg.
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        self.0.mass_kg
    }

    /// Sphere radius R, in m.
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        self.0.radius_m
    }

    /// Spheres n that share the body weight.
    #[must_use]
    pub fn sphere_count(&self) -> f64 {
        self.0.sphere_count
    }

    /// Gravitational acceleration g, in m/s².
    #[must_use]
    pub fn gravity_m_s2(&self) -> f64 {
        self.0.gravity_m_s2
    }

    /// Body weight M g, in N.
    #[must_use]
    pub fn body_weight_n(&self) -> f64 {
        self.mass_kg() * self.gravity_m_s2()
    }

    /// Body weight on each sphere, M g / n, in N: (4) with its constant.
    #[must_use]
    pub fn load_per_sphere_n(&self) -> f64 {
        self.body_weight_n() / self.sphere_count()
    }

    /// The speed all speeds of the contact are compared with, √(g R), in m/s.
    #[must_use]
    pub fn speed_m_s(&self) -> f64 {
        (self.gravity_m_s2() * self.radius_m()).sqrt()
    }

    /// The time all times of the contact are compared with, √(R / g), in s (Fig. 4).
    #[must_use]
    pub fn time_s(&self) -> f64 {
        (self.radius_m() / self.gravity_m_s2()).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HUMAN: ScaleValues =
        ScaleValues { mass_kg: 62.0, radius_m: 0.032, sphere_count: 6.0, gravity_m_s2: 9.81 };

    #[test]
    fn every_field_is_checked_by_name() {
        let refused = |values| Scale::new(values).unwrap_err().quantity();
        assert_eq!(refused(ScaleValues { mass_kg: 0.0, ..HUMAN }), "mass");
        assert_eq!(refused(ScaleValues { radius_m: f64::NAN, ..HUMAN }), "sphere radius");
        assert_eq!(refused(ScaleValues { sphere_count: 0.5, ..HUMAN }), "sphere count");
        assert_eq!(refused(ScaleValues { gravity_m_s2: 0.0, ..HUMAN }), "gravity");
    }

    #[test]
    fn reference_quantities_have_their_dimensions() {
        // Other units: metres × 2, kilograms × 3, seconds × 5.
        let (l, m, t) = (2.0, 3.0, 5.0);
        let a = Scale::new(HUMAN).unwrap();
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
}
