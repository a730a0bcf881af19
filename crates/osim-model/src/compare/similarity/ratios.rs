//! How much larger one body is than another one, and what similarity makes of a number of any dimension.

use crate::model::Dimension;

/// How much larger one body is than another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeRatios {
    /// Mass over mass.
    pub mass: f64,
    /// Length over length.
    pub length: f64,
    /// Gravity over gravity.
    pub gravity: f64,
}

impl SizeRatios {
    /// The factor that similarity gives a number of the dimension M^m L^l T^t: with times as those of a fall, T = √(L / G), it is
    /// M^m L^(l + t/2) G^(-t/2).
    ///
    /// M, L and G are the ratios of mass, length and gravity, finite and above 0. Source: dimensional analysis at equal Froude number;
    /// (14) is its case for a dissipation, s/m.
    ///
    /// ```
    /// use osim_model::compare::SizeRatios;
    /// use osim_model::SizedKind;
    ///
    /// let ratios = SizeRatios { mass: 64.0, length: 4.0, gravity: 1.0 };
    /// // A force is a weight; a time goes with √4; a torque is a weight times a length.
    /// assert_eq!(ratios.factor(SizedKind::MaxIsometricForce.dimension()), 64.0);
    /// assert_eq!(ratios.factor(SizedKind::ActivationTime.dimension()), 2.0);
    /// assert_eq!(ratios.factor(SizedKind::ActuatorTorque.dimension()), 256.0);
    /// ```
    #[must_use]
    pub fn factor(&self, dimension: Dimension) -> f64 {
        let Dimension { mass, length, time } = dimension;
        let power = |base: f64, halves: i8| libm::pow(base, f64::from(halves) / 2.0);
        power(self.mass, 2 * mass) * power(self.length, 2 * length + time) * power(self.gravity, -time)
    }
}

/// The same at equal gravity as a formula of M and L: `M L^(3/2)`, `1 / L^(1/2)`.
#[must_use]
pub fn formula(dimension: Dimension) -> String {
    let powers = [("M", 2 * dimension.mass), ("L", 2 * dimension.length + dimension.time)];
    let part = |wanted: fn(i8) -> bool| {
        let found = powers.iter().filter(|(_, halves)| wanted(*halves));
        found.map(|(name, halves)| power(name, halves.unsigned_abs())).collect::<Vec<_>>().join(" ")
    };
    let (above, below) = (part(|halves| halves > 0), part(|halves| halves < 0));
    match (above.is_empty(), below.is_empty()) {
        (true, true) => "1".to_owned(),
        (false, true) => above,
        (true, false) => format!("1 / {below}"),
        (false, false) => format!("{above} / {below}"),
    }
}

fn power(name: &str, halves: u8) -> String {
    match (halves, halves % 2) {
        (2, _) => name.to_owned(),
        (_, 0) => format!("{name}^{}", halves / 2),
        _ => format!("{name}^({halves}/2)"),
    }
}

#[cfg(test)]
mod tests {
    use crate::model::SizedKind;
    use crate::model::SizedKind::{
        ActivationTime, BushingDamping, BushingRotationalDamping, BushingRotationalStiffness,
        BushingStiffness, Inertia, MaxContractionVelocity, MaxIsometricForce, MocoSpeed, OptimalFiberLength,
        SpringDissipation,
    };

    use super::*;

    /// The powers of M and L at equal gravity, worked out by hand from the unit with T = L^(1/2):
    /// N = M L T^-2 = M L L^-1 = M; N m = M L; N/m = M L^-1; N m s = M L L^(1/2) = M L^(3/2); N s/m = M L^-1 L^(1/2) = M L^(-1/2);
    /// 1/s = L^(-1/2); m/s = L L^(-1/2) = L^(1/2); s/m = L^(1/2) L^-1 = L^(-1/2); kg m² = M L².
    const BY_HAND: &[(SizedKind, f64, f64, &str)] = &[
        (MaxIsometricForce, 1.0, 0.0, "M"),
        (BushingRotationalStiffness, 1.0, 1.0, "M L"),
        (BushingStiffness, 1.0, -1.0, "M / L"),
        (BushingRotationalDamping, 1.0, 1.5, "M L^(3/2)"),
        (BushingDamping, 1.0, -0.5, "M / L^(1/2)"),
        (MaxContractionVelocity, 0.0, -0.5, "1 / L^(1/2)"),
        (ActivationTime, 0.0, 0.5, "L^(1/2)"),
        (MocoSpeed, 0.0, 0.5, "L^(1/2)"),
        (SpringDissipation, 0.0, -0.5, "1 / L^(1/2)"),
        (OptimalFiberLength, 0.0, 1.0, "L"),
        (Inertia, 1.0, 2.0, "M L^2"),
    ];

    #[test]
    fn factors_are_the_powers_of_mass_and_length_worked_out_by_hand() {
        let ratios = SizeRatios { mass: 5.0, length: 1.7, gravity: 1.0 };
        for (kind, mass, length, words) in BY_HAND {
            let expected = 5.0_f64.powf(*mass) * 1.7_f64.powf(*length);
            let found = ratios.factor(kind.dimension());
            assert!((found / expected - 1.0).abs() < 1e-14, "{kind:?}: {found}, {expected}");
            assert_eq!(formula(kind.dimension()), *words, "{kind:?}");
        }
    }

    /// In other units of mass, length and time a number of the dimension M^m L^l T^t has a value a^m b^l c^t times as large; two bodies
    /// compared in those units have the same factor.
    #[test]
    fn factors_do_not_depend_on_units() {
        // Two bodies in SI, and the same in pounds (0.4536 kg) and feet (0.3048 m); gravity in ft/s².
        let si = SizeRatios { mass: 80.0 / 20.0, length: 1.8 / 1.1, gravity: 9.81 / 1.62 };
        let [lb, ft] = [0.4536, 0.3048];
        let other = SizeRatios {
            mass: (80.0 / lb) / (20.0 / lb),
            length: (1.8 / ft) / (1.1 / ft),
            gravity: (9.81 / ft) / (1.62 / ft),
        };
        for kind in SizedKind::ALL {
            let [a, b] = [si, other].map(|ratios| ratios.factor(kind.dimension()));
            assert!((a / b - 1.0).abs() < 1e-14, "{kind:?}");
        }
    }

    /// On the moon a weight is M G, and a pendulum of the same length swings √(1/G) times as long.
    #[test]
    fn gravity_counts_by_hand() {
        let moon = SizeRatios { mass: 2.0, length: 1.0, gravity: 0.25 };
        assert_eq!(moon.factor(MaxIsometricForce.dimension()), 0.5);
        assert_eq!(moon.factor(ActivationTime.dimension()), 2.0);
    }
}
