//! Friction of one sphere that slips, as both contact classes of OpenSim have it.

use crate::error::{DomainError, non_negative, positive};

/// What friction follows from, as in the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionValues {
    /// `static_friction`, the coefficient near rest.
    pub static_friction: f64,
    /// `dynamic_friction`, the coefficient far above the transition velocity.
    pub dynamic_friction: f64,
    /// `viscous_friction`, s/m.
    pub viscous_friction: f64,
    /// `transition_velocity`, m/s.
    pub transition_velocity: f64,
}

/// The friction of one sphere: how many times its normal force it brakes.
///
/// Coefficients ≥ 0 and a transition velocity above 0: checked once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction(FrictionValues);

impl Friction {
    /// Friction by these values.
    ///
    /// # Errors
    /// [`DomainError`] unless coefficients are finite and 0 or above, and the transition velocity is finite and above 0.
    pub fn new(values: FrictionValues) -> Result<Self, DomainError> {
        non_negative("static friction", values.static_friction)?;
        non_negative("dynamic friction", values.dynamic_friction)?;
        non_negative("viscous friction", values.viscous_friction)?;
        positive("transition velocity", values.transition_velocity)?;
        Ok(Self(values))
    }

    /// Its values.
    #[must_use]
    pub const fn values(&self) -> FrictionValues {
        self.0
    }

    /// Friction force over normal force at the slip speed v (m/s): min(v/vt, 1) (μd + 2 (μs − μd)/(1 + (v/vt)²)) + μv v.
    ///
    /// Not in the paper: Simbody's `HuntCrossleyForce` has it so, and the smoothed class the same.
    ///
    /// ```
    /// # use contact_scaling::{Friction, FrictionValues};
    /// let values =
    ///     FrictionValues { static_friction: 0.8, dynamic_friction: 0.6, viscous_friction: 0.5, transition_velocity: 0.2 };
    /// let friction = Friction::new(values)?;
    /// assert_eq!(friction.coefficient(0.0), 0.0);
    /// // At the transition velocity: the static coefficient, and what is viscous.
    /// assert!((friction.coefficient(0.2) - (0.8 + 0.1)).abs() < 1e-15);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    #[must_use]
    pub fn coefficient(&self, slip_speed_m_s: f64) -> f64 {
        let FrictionValues { static_friction, dynamic_friction, viscous_friction, transition_velocity } =
            self.0;
        let relative = slip_speed_m_s / transition_velocity;
        let dry = dynamic_friction + 2.0 * (static_friction - dynamic_friction) / (1.0 + relative * relative);
        relative.min(1.0) * dry + viscous_friction * slip_speed_m_s
    }

    /// The coefficient of two surfaces that have their own: 2 a b/(a + b), and 0 where both are 0.
    ///
    /// Not in the paper: Simbody's `HuntCrossleyForce` mixes so.
    ///
    /// ```
    /// # use contact_scaling::Friction;
    /// assert_eq!((Friction::mixed(0.8, 0.8), Friction::mixed(0.0, 0.8), Friction::mixed(0.0, 0.0)), (0.8, 0.0, 0.0));
    /// ```
    #[must_use]
    pub fn mixed(one: f64, other: f64) -> f64 {
        if one == other { one } else { 2.0 * one * other / (one + other) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn far_above_the_transition_it_is_dynamic() {
        let values = FrictionValues {
            static_friction: 0.9,
            dynamic_friction: 0.5,
            viscous_friction: 0.0,
            transition_velocity: 1e-6,
        };
        let friction = Friction::new(values).unwrap();
        assert!((friction.coefficient(1.0) - 0.5).abs() < 1e-11);
        assert!(Friction::new(FrictionValues { transition_velocity: 0.0, ..values }).is_err());
        assert!(Friction::new(FrictionValues { dynamic_friction: -0.1, ..values }).is_err());
        assert!(Friction::new(FrictionValues { viscous_friction: f64::NAN, ..values }).is_err());
    }
}
