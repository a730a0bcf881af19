//! What was made of the numbers of one kind.

use super::spread::Spread;

/// Numbers that differ by less than this (relative) are the same: documents of old versions have six digits.
pub(super) const SAME: f64 = 1e-6;
/// Factors nearer to 1 than this show nothing.
const NO_DIFFERENCE: f64 = 1e-3;
/// How far the median may be from what similarity gives, as a difference of logarithms: this, or a quarter of what similarity gives,
/// whichever is more. Bodies are seldom scaled by one factor along all axes.
const NEAR: f64 = 0.02;
const QUARTER: f64 = 0.25;

/// What was made of the numbers of one kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SizeVerdict {
    /// They changed as similarity has it: their median is near that factor, or the factor is in their range.
    Follows,
    /// None changed.
    Left,
    /// Some did not change.
    PartlyLeft,
    /// They changed otherwise.
    Other,
    /// Similarity would not change them either: the bodies are too much alike, or all are 0.
    Undecided,
    /// There are none in the other model.
    NotCompared,
}

impl SizeVerdict {
    /// As a word for scripts.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Follows => "follows",
            Self::Left => "left",
            Self::PartlyLeft => "partly-left",
            Self::Other => "other",
            Self::Undecided => "undecided",
            Self::NotCompared => "not-compared",
        }
    }

    /// For people.
    #[must_use]
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

    /// Of `factors`, `same` of them 1, where similarity gives `expected`, which is finite and above 0.
    pub(super) fn of(factors: &[f64], same: usize, expected: Option<f64>) -> Self {
        let Some(spread) = Spread::of(factors.iter().copied()) else { return Self::NotCompared };
        let Some(expected) = expected else { return Self::Undecided };
        let distance = libm::log(expected);
        if distance.abs() < NO_DIFFERENCE {
            return Self::Undecided;
        }
        match same {
            0 if spread.median <= 0.0 => Self::Other,
            0 => {
                let off = libm::log(spread.median) - distance;
                let is_near = off.abs() <= NEAR.max(QUARTER * distance.abs());
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
    use super::SizeVerdict::{Follows, Left, NotCompared, Other, PartlyLeft, Undecided};
    use super::*;

    #[test]
    fn the_median_decides_unless_some_are_the_same() {
        // A body of 8 times the mass: lengths 2 times, forces 8 times. Areas grow 4 times, which no force at equal gravity does.
        let of = |factors: &[f64], same, expected| SizeVerdict::of(factors, same, Some(expected));
        assert_eq!(of(&[8.0, 8.1, 7.9], 0, 8.0), Follows);
        assert_eq!(of(&[4.0, 4.0, 4.0], 0, 8.0), Other);
        assert_eq!(of(&[1.0, 1.0, 1.0], 3, 8.0), Left);
        assert_eq!(of(&[1.0, 8.0, 8.0], 1, 8.0), PartlyLeft);
        assert_eq!(of(&[-8.0], 0, 8.0), Other);
        assert_eq!(of(&[1.0], 1, 1.0004), Undecided);
        assert_eq!(of(&[], 0, 8.0), NotCompared);
        assert_eq!(SizeVerdict::of(&[1.0], 1, None), Undecided);
    }

    #[test]
    fn what_is_near_is_a_quarter_of_the_way_but_at_least_two_per_cent() {
        // ln 2 = 0.693, a quarter of it 0.173: e^(0.693 - 0.173) = 1.68.
        assert_eq!(SizeVerdict::of(&[1.69], 0, Some(2.0)), Follows);
        assert_eq!(SizeVerdict::of(&[1.67], 0, Some(2.0)), Other);
        // Muscles lengthen with their own bones: what similarity gives is between the shortest and the longest.
        assert_eq!(SizeVerdict::of(&[1.9, 2.9, 3.0], 0, Some(2.0)), Follows);
        assert_eq!(SizeVerdict::of(&[1.025], 0, Some(1.01)), Follows);
        assert_eq!(SizeVerdict::of(&[1.035], 0, Some(1.01)), Other);
    }
}
