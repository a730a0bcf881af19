//! Where the two laws stop being those of a material, and what smoothing the paper starts from.

use std::fmt;

/// A design that asks for a limit gets it except for the last bits, which counts as within.
const LAST_BITS: f64 = 1e-9;

/// The side of a limit on which a figure has to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// The figure is not above the limit.
    AtMost,
    /// The figure is not below the limit.
    AtLeast,
}

/// A limit of a figure without unit: the one place that knows its number and where it comes from.
///
/// ```
/// use contact_scaling::limits;
/// assert!(!limits::INDENTATION.admits(0.353)); // every model of Table 1
/// assert!(!limits::RESTITUTION.admits(0.2)); // the human of Table 1
/// assert_eq!(limits::INDENTATION.to_string(), "<= 0.16");
/// assert_eq!(limits::RESTITUTION.in_words(), "at least 0.8");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Limit {
    /// The limit's number.
    pub value: f64,
    /// The side on which figures have to be.
    pub bound: Bound,
    /// The quantity that is limited, in a few words.
    pub what: &'static str,
    /// Source of the limit.
    pub source: &'static str,
}

impl Limit {
    const fn at_most(value: f64, what: &'static str, source: &'static str) -> Self {
        Self { value, bound: Bound::AtMost, what, source }
    }

    const fn at_least(value: f64, what: &'static str, source: &'static str) -> Self {
        Self { value, bound: Bound::AtLeast, what, source }
    }

    /// Whether `figure` is within the limit, or on it except for the last bits (1e-9 of it). NaN is not.
    #[must_use]
    pub fn admits(&self, figure: f64) -> bool {
        match self.bound {
            Bound::AtMost => figure <= self.value * (1.0 + LAST_BITS),
            Bound::AtLeast => figure >= self.value * (1.0 - LAST_BITS),
        }
    }

    /// The limit for sentences: `at most 0.16`.
    #[must_use]
    pub fn in_words(&self) -> String {
        let side = match self.bound {
            Bound::AtMost => "at most",
            Bound::AtLeast => "at least",
        };
        format!("{side} {}", self.value)
    }
}

/// The limit for tables: `<= 0.16`.
impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let side = match self.bound {
            Bound::AtMost => "<=",
            Bound::AtLeast => ">=",
        };
        write!(f, "{side} {}", self.value)
    }
}

/// The largest relative indentation x̂ for which the Hertz law was found accurate: patch radius 0.4 R.
pub const INDENTATION: Limit = Limit::at_most(
    0.16,
    "relative indentation x/R",
    "Lin et al. (2009), as cited in section 4.1 of the paper: the Hertz law was found accurate up to there, a contact patch \
     of 0.4 R",
);

/// The smallest restitution c_r for which the Hunt–Crossley law is accurate.
pub const RESTITUTION: Limit = Limit::at_least(
    0.8,
    "coefficient of restitution by (13)",
    "Hunt and Crossley (1975), as cited in section 4.2 of the paper: below it their law is not accurate",
);

/// The largest constant relative indentation x̂_c = √cf / R that the paper starts from. Where x̂ ≤ 0.16 is wanted, 0.05.
pub const CONSTANT_INDENTATION: Limit = Limit::at_most(
    0.1,
    "constant indentation sqrt(cf)/R",
    "section C.1 of the paper starts from it; Falisse et al. (2022), who had no trouble with it, have 0.0988",
);

/// The largest width Δx̂ of the contact transition, from 5 % to 95 %: 0.29 with bd R = 10, 0.307 with the 9.6 of Falisse et al.
pub const TRANSITION_WIDTH: Limit = Limit::at_most(
    0.31,
    "width of the contact transition over R",
    "section C.2 of the paper starts from bd R = 10, which is 0.29; Falisse et al. (2022), who had no trouble with it, have 0.307",
);

/// The largest force of a sphere that just touches, over its share of the body weight.
pub const TOUCHING_SHARE: Limit = Limit::at_most(
    0.1,
    "force of a sphere that just touches, over its share of body weight",
    "a choice of this project: the paper shows the harm (Fig. C.5) and prints no number; Falisse et al. (2022), whose smoothing \
     \"does not have the issue\", have 0.074",
);

/// The fraction t of the contact state from which, and up to 1 − t, the width of the contact transition is given
/// (section C.2).
pub const TRANSITION_THRESHOLD: f64 = 0.05;

/// x̂_c that the paper suggests where x̂ ≤ 0.16 is wanted (section C.1).
pub const SUGGESTED_CONSTANT_INDENTATION: f64 = 0.05;

/// Width Δx̂ of the contact transition that is proposed: a round number within its limit.
pub const SUGGESTED_TRANSITION_WIDTH: f64 = 0.3;

/// Every limit of the paper.
pub const ALL: [Limit; 5] =
    [INDENTATION, RESTITUTION, CONSTANT_INDENTATION, TRANSITION_WIDTH, TOUCHING_SHARE];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_on_the_limit_is_within() {
        // 0.16 by way of a stiffness comes back as 0.16000000000000003.
        assert!(INDENTATION.admits(0.16 + f64::EPSILON) && !INDENTATION.admits(0.160_001));
        assert!(RESTITUTION.admits(0.8 - f64::EPSILON) && !RESTITUTION.admits(0.799_999));
        assert!(!INDENTATION.admits(f64::NAN) && !RESTITUTION.admits(f64::NAN));
    }
}
