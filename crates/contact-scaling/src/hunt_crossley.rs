//! The Hunt–Crossley law of a sphere: Hertz force with dissipation (12), as OpenSim's `HuntCrossleyForce`.

use crate::error::{DomainError, non_negative};
use crate::{Contact, Hertz};

/// The normal force of one sphere of a `HuntCrossleyForce`.
///
/// α ≥ 0 and finite: checked once. Indentation x in m, its rate ẋ in m/s, positive while going in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HuntCrossley {
    hertz: Hertz,
    dissipation: f64,
}

impl HuntCrossley {
    /// A Hertz law with the dissipation α (s/m).
    ///
    /// # Errors
    /// [`DomainError`] unless α is finite and 0 or above.
    pub fn new(hertz: Hertz, dissipation: f64) -> Result<Self, DomainError> {
        Ok(Self { hertz, dissipation: non_negative("dissipation", dissipation)? })
    }

    /// The law of a sphere of radius R (m) whose file holds `contact`; its smoothing is not looked at.
    ///
    /// # Errors
    /// As [`Hertz::of`].
    pub fn of(contact: &Contact, radius_m: f64) -> Result<Self, DomainError> {
        Self::new(Hertz::of(contact, radius_m)?, contact.dissipation())
    }

    /// The elastic part of the law.
    #[must_use]
    pub fn hertz(&self) -> &Hertz {
        &self.hertz
    }

    /// α, in s/m.
    #[must_use]
    pub fn dissipation(&self) -> f64 {
        self.dissipation
    }

    /// Dissipative force F_d = 3/2 F_e α ẋ, in N.
    ///
    /// F_e in N by (1) at x (m), α in s/m, ẋ in m/s. Negative while the sphere comes out; 0 at x ≤ 0.
    ///
    /// Source: (12).
    ///
    /// ```
    /// # use contact_scaling::{Hertz, HuntCrossley};
    /// let law = HuntCrossley::new(Hertz::sphere(3e6, 0.25)?, 2.0)?;
    /// assert!((law.dissipative_force(0.0625, 0.1) - 0.3 * 31250.0).abs() < 1e-9);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    #[must_use]
    pub fn dissipative_force(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        self.hertz.force(indentation_m) * (1.5 * self.dissipation * speed_m_s)
    }

    /// Normal force F_c = F_e + F_d = F_e (1 + 3/2 α ẋ), in N, and never a pull.
    ///
    /// x in m, ẋ in m/s. Where the sum is below 0, at ẋ < −2/(3α), this gives 0, as Simbody does.
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
    #[must_use]
    pub fn force(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        let force = self.hertz.force(indentation_m) * (1.0 + 1.5 * self.dissipation * speed_m_s);
        if force < 0.0 { 0.0 } else { force }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn force_is_the_sum_of_its_parts_while_it_pushes() {
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
