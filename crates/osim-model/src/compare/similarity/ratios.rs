//! How much larger one body is than another, and the factor that geometric similarity gives for a number of any dimension.

use crate::messages::named;
use crate::model::Dimension;

/// How much larger one body is than another: ratios of mass, length and gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeRatios {
    pub mass: f64,
    pub length: f64,
    pub gravity: f64,
}

impl SizeRatios {
    /// The factor that geometric similarity gives for a number of the dimension M^m L^l T^t. Times change like the time of a fall, T = √(L
    /// / G), so the factor is M^m L^(l + t/2) G^(-t/2).
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
    pub fn factor(&self, dimension: Dimension) -> f64 {
        let Dimension { mass, length, time } = dimension;
        let power = |base: f64, halves: i8| libm::pow(base, f64::from(halves) / 2.0);
        power(self.mass, 2 * mass) * power(self.length, 2 * length + time) * power(self.gravity, -time)
    }
}

/// The factor at equal gravity, as a formula of M and L: `M L^(3/2)`, `1 / L^(1/2)`.
pub fn similarity_formula(dimension: Dimension) -> String {
    let powers = [("M", 2 * dimension.mass), ("L", 2 * dimension.length + dimension.time)];
    let part = |wanted: fn(i8) -> bool| {
        let found = powers.iter().filter(|(_, halves)| wanted(*halves));
        found.map(|(name, halves)| power_text(name, halves.unsigned_abs())).collect::<Vec<_>>().join(" ")
    };
    let (above, below) = (part(|halves| halves > 0), part(|halves| halves < 0));
    match (above.is_empty(), below.is_empty()) {
        (true, true) => "1".to_owned(),
        (false, true) => above,
        (true, false) => format!("1 / {below}"),
        (false, false) => format!("{above} / {below}"),
    }
}

fn power_text(name: &str, halves: u8) -> String {
    match (halves, halves % 2) {
        (2, _) => name.to_owned(),
        (_, 0) => format!("{name}^{}", halves / 2),
        _ => format!("{name}^({halves}/2)"),
    }
}

/// The median, the least and the largest of some numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// The middle number; for an even count, the mean of the two middle numbers.
    pub median: f64,
    pub min: f64,
    pub max: f64,
}

impl Spread {
    /// The median and the range of `numbers`; `None` if there are none.
    ///
    /// ```
    /// use osim_model::compare::Spread;
    ///
    /// let spread = Spread::of([3.0, 1.0, 2.0, 6.0]);
    /// assert_eq!(spread, Some(Spread { median: 2.5, min: 1.0, max: 6.0 }));
    /// ```
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let (min, max) = (*sorted.first()?, *sorted.last()?);
        let upper = *sorted.get(sorted.len() / 2)?;
        let lower = *sorted.get((sorted.len() - 1) / 2)?;
        Some(Self { median: lower / 2.0 + upper / 2.0, min, max })
    }
}

/// Numbers that differ by less than this (relative) are equal: documents of old versions have six digits.
pub(super) const SAME_NUMBER_TOLERANCE: f64 = 1e-6;
/// An expected factor that is nearer to 1 than this cannot decide anything.
const LEAST_EXPECTED_CHANGE: f64 = 1e-3;
/// How far the median factor may be from the expected factor, as a difference of logarithms: at least this. Bodies are seldom scaled by one
/// factor along all axes.
const LEAST_TOLERANCE: f64 = 0.02;
/// The median factor may also be off by this part of the logarithm of the expected factor, if this is more than [`LEAST_TOLERANCE`].
const TOLERANCE_SHARE_OF_FACTOR: f64 = 0.25;

named! {
    /// Whether the numbers of one kind changed as geometric similarity expects.
    pub enum SizeVerdict {
        /// The numbers changed as expected: their median is near the expected factor, or the expected factor is in their range.
        Follows = "follows",
        /// No number of the kind changed.
        Left = "left",
        /// Some numbers of the kind did not change, others did.
        PartlyLeft = "partly-left",
        /// The numbers changed by another factor than similarity expects.
        Other = "other",
        /// No answer: similarity expects no change, because the bodies are too much alike, or all numbers are 0.
        Undecided = "undecided",
        /// The original model has no number of this kind.
        NotCompared = "not-compared",
    }
}

impl SizeVerdict {
    pub const fn words(self) -> &'static str {
        match self {
            Self::Follows => "follows",
            Self::Left => "left",
            Self::PartlyLeft => "left in part",
            Self::Other => "other",
            Self::Undecided => "no difference",
            Self::NotCompared => "not compared",
        }
    }

    /// The verdict on `factors`. `same` of them are 1; similarity expects the factor `expected`, which is finite and above 0.
    pub(super) fn of(factors: &[f64], same: usize, expected: Option<f64>) -> Self {
        let Some(spread) = Spread::of(factors.iter().copied()) else { return Self::NotCompared };
        let Some(expected) = expected else { return Self::Undecided };
        let distance = libm::log(expected);
        if distance.abs() < LEAST_EXPECTED_CHANGE {
            return Self::Undecided;
        }
        match same {
            0 if spread.median <= 0.0 => Self::Other,
            0 => {
                let off = libm::log(spread.median) - distance;
                let is_near = off.abs() <= LEAST_TOLERANCE.max(TOLERANCE_SHARE_OF_FACTOR * distance.abs());
                let is_in_range = spread.min <= expected && expected <= spread.max;
                if is_near || is_in_range { Self::Follows } else { Self::Other }
            }
            same if same == factors.len() => Self::Left,
            _ => Self::PartlyLeft,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::similarity::ratios::SizeVerdict::{
        Follows, Left, NotCompared, Other, PartlyLeft, Undecided,
    };
    use crate::model::SizedKind::{
        self, ActivationTime, BushingDamping, BushingRotationalDamping, BushingRotationalStiffness,
        BushingStiffness, Inertia, MaxContractionVelocity, MaxIsometricForce, MocoSpeed, OptimalFiberLength,
        SpringDissipation,
    };

    /// The powers of M and L at equal gravity, computed by hand from the unit with T = L^(1/2): N = M L T^-2 = M L L^-1 = M; N m = M L; N/m
    /// = M L^-1; N m s = M L L^(1/2) = M L^(3/2); N s/m = M L^-1 L^(1/2) = M L^(-1/2); 1/s = L^(-1/2); m/s = L L^(-1/2) = L^(1/2); s/m =
    /// L^(1/2) L^-1 = L^(-1/2); kg m² = M L².
    const FACTORS_BY_HAND: &[(SizedKind, f64, f64, &str)] = &[
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
        for (kind, mass, length, words) in FACTORS_BY_HAND {
            let expected = 5.0_f64.powf(*mass) * 1.7_f64.powf(*length);
            let found = ratios.factor(kind.dimension());
            assert!((found / expected - 1.0).abs() < 1e-14, "{kind:?}: {found}, {expected}");
            assert_eq!(similarity_formula(kind.dimension()), *words, "{kind:?}");
        }
    }

    /// A number of the dimension M^m L^l T^t has another value in other units, a^m b^l c^t times as large. The factor between two bodies is
    /// the same in all units.
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

    /// Under a gravity that is G times as large, a weight is M G, and a pendulum of the same length swings √(1/G) times as long.
    #[test]
    fn gravity_scales_weights_and_times() {
        let moon = SizeRatios { mass: 2.0, length: 1.0, gravity: 0.25 };
        assert_eq!(moon.factor(MaxIsometricForce.dimension()), 0.5);
        assert_eq!(moon.factor(ActivationTime.dimension()), 2.0);
    }

    #[test]
    fn the_median_decides_unless_some_numbers_are_unchanged() {
        // A body of 8 times the mass: lengths 2 times, forces 8 times. Areas grow 4 times, which no force at equal gravity does.
        let verdict = |factors: &[f64], same, expected| SizeVerdict::of(factors, same, Some(expected));
        assert_eq!(verdict(&[8.0, 8.1, 7.9], 0, 8.0), Follows);
        assert_eq!(verdict(&[4.0, 4.0, 4.0], 0, 8.0), Other);
        assert_eq!(verdict(&[1.0, 1.0, 1.0], 3, 8.0), Left);
        assert_eq!(verdict(&[1.0, 8.0, 8.0], 1, 8.0), PartlyLeft);
        assert_eq!(verdict(&[-8.0], 0, 8.0), Other);
        assert_eq!(verdict(&[1.0], 1, 1.0004), Undecided);
        assert_eq!(verdict(&[], 0, 8.0), NotCompared);
        assert_eq!(SizeVerdict::of(&[1.0], 1, None), Undecided);
    }

    #[test]
    fn a_median_may_be_off_by_a_quarter_or_two_per_cent() {
        // ln 2 = 0.693, a quarter of it 0.173: e^(0.693 - 0.173) = 1.68.
        assert_eq!(SizeVerdict::of(&[1.69], 0, Some(2.0)), Follows);
        assert_eq!(SizeVerdict::of(&[1.67], 0, Some(2.0)), Other);
        // Muscles lengthen with their own bones: what similarity gives is between the shortest and the longest.
        assert_eq!(SizeVerdict::of(&[1.9, 2.9, 3.0], 0, Some(2.0)), Follows);
        assert_eq!(SizeVerdict::of(&[1.025], 0, Some(1.01)), Follows);
        assert_eq!(SizeVerdict::of(&[1.035], 0, Some(1.01)), Other);
    }
}
