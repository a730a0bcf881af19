//! Computes two of load, radius, indentation, modulus and stiffness from the other three: (3) and (B.2) together.

use crate::design;
use crate::error::{DomainError, require_positive, require_range};

/// The known quantities of one sphere under its load, not yet checked; a quantity that is `None` is computed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KnownQuantities {
    /// Load on each sphere F/n, in N.
    pub load_per_sphere_n: Option<f64>,
    /// Sphere radius R, in m.
    pub radius_m: Option<f64>,
    /// Relative indentation x̂, without unit, 0 < x̂ ≤ 1.
    pub relative_indentation: Option<f64>,
    /// Composite modulus E*, in N/m².
    pub composite_modulus_n_m2: Option<f64>,
    /// Stiffness k of one sphere under its load, in N/m.
    pub stiffness_n_m: Option<f64>,
}

/// All quantities of one sphere under its load.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Sizing {
    /// Load on each sphere F/n, in N.
    pub load_per_sphere_n: f64,
    /// Sphere radius R, in m.
    pub radius_m: f64,
    /// Relative indentation x̂, without unit; above 1 if the sphere is too soft for its load.
    pub relative_indentation: f64,
    /// Composite modulus E*, in N/m².
    pub composite_modulus_n_m2: f64,
    /// Stiffness k of one sphere under its load, in N/m.
    pub stiffness_n_m: f64,
}

/// The reason why the quantities cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SizingError {
    /// A number is outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Fewer than three quantities are known.
    #[error("{} of load, radius, indentation, modulus and stiffness are known, expected three", .known.len())]
    Insufficient {
        /// Names of the quantities that are known.
        known: Vec<&'static str>,
        /// Names of the quantities that are not known.
        missing: Vec<&'static str>,
    },
    /// More than three quantities are given, and they contradict each other.
    #[error("the {quantity} is given as {given}, but {follows} follows from the other quantities")]
    Contradictory {
        /// Name of the given quantity that contradicts the others.
        quantity: &'static str,
        /// The value that the caller gave for this quantity.
        given: f64,
        /// The value that follows from the first three known quantities.
        follows: f64,
    },
}

/// Largest relative difference of a given quantity from the value that follows from the others.
const CONSISTENCY_TOLERANCE: f64 = 1e-6;

impl KnownQuantities {
    fn names_and_values(&self) -> [(&'static str, Option<f64>); 5] {
        [
            ("load", self.load_per_sphere_n),
            ("radius", self.radius_m),
            ("indentation", self.relative_indentation),
            ("modulus", self.composite_modulus_n_m2),
            ("stiffness", self.stiffness_n_m),
        ]
    }

    /// Computes the quantities that are not known.
    ///
    /// With f = F/n: f = 4/3 R² E* x̂^{3/2} (3) and k = 2 R E* √x̂ (B.2).
    ///
    /// # Errors
    /// [`SizingError`] if fewer than three quantities are known, if a number is outside its domain, or if more than three are
    /// known and contradict each other.
    ///
    /// ```
    /// use contact_scaling::sizing::KnownQuantities;
    /// // A heel pad of 30 mm radius that carries 300 N at 10 % indentation.
    /// let known = KnownQuantities {
    ///     load_per_sphere_n: Some(300.0),
    ///     radius_m: Some(0.03),
    ///     relative_indentation: Some(0.1),
    ///     ..KnownQuantities::default()
    /// };
    /// let sizing = known.solve()?;
    /// assert!((sizing.stiffness_n_m / 150e3 - 1.0).abs() < 1e-12); // k = 3 f / (2 R x̂)
    /// # Ok::<(), contact_scaling::sizing::SizingError>(())
    /// ```
    pub fn solve(&self) -> Result<Sizing, SizingError> {
        for (name, value) in self.names_and_values() {
            if let Some(value) = value {
                require_positive(name, value)?;
            }
        }
        if let Some(x) = self.relative_indentation {
            require_range(x <= 1.0, "relative indentation", x, "a number above 0, at most 1")?;
        }
        let sizing = self.solve_checked().ok_or_else(|| {
            let names = |known: bool| {
                self.names_and_values()
                    .into_iter()
                    .filter(|(_, v)| v.is_some() == known)
                    .map(|(name, _)| name)
                    .collect()
            };
            SizingError::Insufficient { known: names(true), missing: names(false) }
        })?;
        for ((quantity, given), (_, follows)) in
            self.names_and_values().into_iter().zip(sizing.names_and_values())
        {
            require_positive(quantity, follows)?;
            if let Some(given) =
                given.filter(|given| (given - follows).abs() > CONSISTENCY_TOLERANCE * follows)
            {
                return Err(SizingError::Contradictory { quantity, given, follows });
            }
        }
        Ok(sizing)
    }

    /// Computes the quantities that are not known, for a smoothed contact at speed 0. Its force and stiffness are
    /// `speed_state` times those of the Hertz law: [`crate::smoothing::speed_state_at_rest`], without unit.
    ///
    /// # Errors
    /// The errors of [`KnownQuantities::solve`], and a `speed_state` that is not above 0.
    ///
    /// ```
    /// use contact_scaling::sizing::KnownQuantities;
    /// let known = KnownQuantities {
    ///     load_per_sphere_n: Some(300.0),
    ///     radius_m: Some(0.03),
    ///     relative_indentation: Some(0.1),
    ///     ..KnownQuantities::default()
    /// };
    /// // Where 0.8 of the Hertz force is left, E* makes up for it; k at that load and depth is the same.
    /// let (hertz, smoothed) = (known.solve()?, known.solve_smoothed(0.8)?);
    /// assert!((smoothed.composite_modulus_n_m2 * 0.8 / hertz.composite_modulus_n_m2 - 1.0).abs() < 1e-15);
    /// assert_eq!(smoothed.stiffness_n_m, hertz.stiffness_n_m);
    /// # Ok::<(), contact_scaling::sizing::SizingError>(())
    /// ```
    pub fn solve_smoothed(&self, speed_state: f64) -> Result<Sizing, SizingError> {
        let share = require_positive("speed state", speed_state)?;
        let given = self.composite_modulus_n_m2;
        let hertz_like = Self { composite_modulus_n_m2: given.map(|modulus| modulus * share), ..*self };
        match hertz_like.solve() {
            Ok(sizing) => {
                let modulus = given.unwrap_or(sizing.composite_modulus_n_m2 / share);
                Ok(Sizing { composite_modulus_n_m2: modulus, ..sizing })
            }
            Err(SizingError::Contradictory { quantity: "modulus", given, follows }) => {
                let (given, follows) = (given / share, follows / share);
                Err(SizingError::Contradictory { quantity: "modulus", given, follows })
            }
            Err(other) => Err(other),
        }
    }

    /// Computes radius, indentation and modulus from any three quantities, then load and stiffness by (3) and (B.2).
    fn solve_checked(&self) -> Option<Sizing> {
        let (f, r, x) = (self.load_per_sphere_n, self.radius_m, self.relative_indentation);
        let (e, k) = (self.composite_modulus_n_m2, self.stiffness_n_m);
        let power = |x: f64| x * x.sqrt();
        let with_modulus = |r: f64, x: f64, k: f64| (r, x, k / (2.0 * r * x.sqrt()));
        let with_indentation = |r: f64, e: f64, k: f64| {
            let root = k / (2.0 * r * e);
            (r, root * root, e)
        };
        let (r, x, e) = match (f, r, x, e, k) {
            (Some(f), Some(r), Some(x), ..) => (r, x, 0.75 * f / (r * r * power(x))),
            (Some(f), Some(r), _, Some(e), _) => (r, design::relative_depth(f, e, r), e),
            (Some(f), Some(r), _, _, Some(k)) => with_modulus(r, 1.5 * f / (k * r), k),
            (Some(f), _, Some(x), Some(e), _) => ((0.75 * f / (e * power(x))).sqrt(), x, e),
            (Some(f), _, Some(x), _, Some(k)) => with_modulus(1.5 * f / (k * x), x, k),
            // k³/f = 6 R E², from (B.2) cubed over (3).
            (Some(f), _, _, Some(e), Some(k)) => with_indentation(k / e * (k / e) * (k / f) / 6.0, e, k),
            (_, Some(r), Some(x), Some(e), _) => (r, x, e),
            (_, Some(r), Some(x), _, Some(k)) => with_modulus(r, x, k),
            (_, Some(r), _, Some(e), Some(k)) => with_indentation(r, e, k),
            (_, _, Some(x), Some(e), Some(k)) => (k / (2.0 * e * x.sqrt()), x, e),
            _ => return None,
        };
        Some(Sizing {
            load_per_sphere_n: f.unwrap_or(4.0 / 3.0 * (r * r) * e * power(x)),
            radius_m: r,
            relative_indentation: x,
            composite_modulus_n_m2: e,
            stiffness_n_m: 2.0 * r * e * x.sqrt(),
        })
    }
}

impl Sizing {
    fn names_and_values(&self) -> [(&'static str, f64); 5] {
        [
            ("load", self.load_per_sphere_n),
            ("radius", self.radius_m),
            ("indentation", self.relative_indentation),
            ("modulus", self.composite_modulus_n_m2),
            ("stiffness", self.stiffness_n_m),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The human of Table 1 under body weight: load per sphere 62 · 9.81 / 6 N, R, and x̂, E*, k for E₁* = 1 MPa, computed
    /// with mpmath 1.4.1.
    const HUMAN_AT_BODY_WEIGHT: [f64; 5] =
        [101.37, 0.032, 0.353_300_157_597_401_94, 353_553.390_593_273_76, 13_449.523_437_277_24];

    fn quantities_of_mask(mask: usize) -> KnownQuantities {
        let pick = |i: usize| (mask & (1 << i) != 0).then(|| HUMAN_AT_BODY_WEIGHT[i]);
        KnownQuantities {
            load_per_sphere_n: pick(0),
            radius_m: pick(1),
            relative_indentation: pick(2),
            composite_modulus_n_m2: pick(3),
            stiffness_n_m: pick(4),
        }
    }

    #[test]
    fn any_three_quantities_give_the_other_two() {
        for mask in (0_usize..32).filter(|mask| mask.count_ones() >= 3) {
            let sizing = quantities_of_mask(mask).solve().unwrap();
            for ((name, found), expected) in sizing.names_and_values().into_iter().zip(HUMAN_AT_BODY_WEIGHT) {
                assert!((found / expected - 1.0).abs() < 1e-12, "{mask:05b} {name} {found} {expected}");
            }
        }
    }

    #[test]
    fn with_fewer_than_three_quantities_the_error_names_the_missing_ones() {
        for mask in (0_usize..32).filter(|mask| mask.count_ones() < 3) {
            assert!(matches!(quantities_of_mask(mask).solve(), Err(SizingError::Insufficient { .. })));
        }
    }

    #[test]
    fn contradictions_and_impossible_numbers_are_refused() {
        let four = KnownQuantities { stiffness_n_m: Some(1e4), ..quantities_of_mask(0b00111) };
        assert!(matches!(four.solve(), Err(SizingError::Contradictory { quantity: "stiffness", .. })));
        let negative = KnownQuantities { radius_m: Some(-1.0), ..quantities_of_mask(0b00111) };
        assert!(matches!(negative.solve(), Err(SizingError::Domain(_))));
        let deep = KnownQuantities { relative_indentation: Some(1.5), ..quantities_of_mask(0b00111) };
        assert!(matches!(deep.solve(), Err(SizingError::Domain(_))));
    }
}
