//! The limits within which the two laws describe a material, and the smoothing that the paper recommends.

use std::fmt;

/// Relative amount by which a figure may exceed a limit because of rounding, without unit.
const ROUNDING_ALLOWANCE: f64 = 1e-9;

/// The side of a limit on which values are allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// A figure must not be above the limit.
    AtMost,
    /// A figure must not be below the limit.
    AtLeast,
}

/// A limit of a dimensionless figure, with its value and source; no other code repeats them.
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
    /// Value of the limit, without unit.
    pub value: f64,
    /// The side of the limit on which values are allowed.
    pub bound: Bound,
    /// The quantity that is limited, in a few words.
    pub what: &'static str,
    /// The publication that gives the limit.
    pub source: &'static str,
}

impl Limit {
    const fn at_most(value: f64, what: &'static str, source: &'static str) -> Self {
        Self { value, bound: Bound::AtMost, what, source }
    }

    /// Whether `figure` is within the limit, or beyond it by at most 1e-9 of the limit; false for NaN.
    pub fn admits(&self, figure: f64) -> bool {
        match self.bound {
            Bound::AtMost => figure <= self.value * (1.0 + ROUNDING_ALLOWANCE),
            Bound::AtLeast => figure >= self.value * (1.0 - ROUNDING_ALLOWANCE),
        }
    }

    /// The limit for sentences, such as `at most 0.16`.
    pub fn in_words(&self) -> String {
        let side = match self.bound {
            Bound::AtMost => "at most",
            Bound::AtLeast => "at least",
        };
        format!("{side} {}", self.value)
    }
}

/// The limit for tables, such as `<= 0.16`.
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
pub const RESTITUTION: Limit = Limit {
    value: 0.8,
    bound: Bound::AtLeast,
    what: "coefficient of restitution by (13)",
    source: "Hunt and Crossley (1975), as cited in section 4.2 of the paper: below it their law is not accurate",
};

/// The largest constant relative indentation x̂_c = √cf / R that the paper recommends, without unit; 0.05 if x̂ ≤ 0.16 is wanted.
pub const CONSTANT_INDENTATION: Limit = Limit::at_most(
    0.1,
    "constant indentation sqrt(cf)/R",
    "section C.1 of the paper starts from it; Falisse et al. (2022), who had no trouble with it, have 0.0988",
);

/// The largest width Δx̂ of the contact transition, from 5 % to 95 %, without unit: 0.29 with bd R = 10, 0.307 with 9.6 as in
/// Falisse et al.
pub const TRANSITION_WIDTH: Limit = Limit::at_most(
    0.31,
    "width of the contact transition over R",
    "section C.2 of the paper starts from bd R = 10, which is 0.29; Falisse et al. (2022), who had no trouble with it, have 0.307",
);

/// The largest force of a sphere that just touches (x = 0), divided by its share of the body weight; without unit.
pub const TOUCHING_SHARE: Limit = Limit::at_most(
    0.1,
    "force of a sphere that just touches, over its share of body weight",
    "a choice of this project: the paper shows the harm (Fig. C.5) and prints no number; Falisse et al. (2022), whose smoothing \
     \"does not have the issue\", have 0.074",
);

/// The factors that bring x̂ to [`INDENTATION`] under the same load: (x̂/0.16)^(3/4) on the radius alone, and (x̂/0.16)^(3/2) on
/// modulus or number of spheres alone, without unit: (3), and the advice of section 4.3. `None` if x̂ is within the limit.
///
/// ```
/// # use contact_scaling::limits;
/// let [radius, modulus_or_count] = limits::growth_to_indentation_limit(0.3533).unwrap(); // every model of Table 1
/// assert!((radius - 1.811).abs() < 5e-4 && (modulus_or_count - 3.281).abs() < 5e-4);
/// assert_eq!(limits::growth_to_indentation_limit(0.16), None);
/// ```
pub fn growth_to_indentation_limit(relative_indentation: f64) -> Option<[f64; 2]> {
    let excess = (relative_indentation / INDENTATION.value).sqrt();
    let is_above = relative_indentation > 0.0 && !INDENTATION.admits(relative_indentation);
    is_above.then(|| [excess * excess.sqrt(), excess * excess * excess])
}

/// Threshold t for the width of the contact transition, without unit: the width is from s_c = t to s_c = 1 − t (section C.2).
pub const TRANSITION_SHARE: f64 = 0.05;

/// Suggested x̂_c if x̂ ≤ 0.16 is wanted, without unit (section C.1).
pub const SUGGESTED_CONSTANT_INDENTATION: f64 = 0.05;

/// Suggested width Δx̂ of the contact transition, without unit: a round number within [`TRANSITION_WIDTH`].
pub const SUGGESTED_TRANSITION_WIDTH: f64 = 0.3;

/// All limits of this module.
pub const ALL: [Limit; 5] =
    [INDENTATION, RESTITUTION, CONSTANT_INDENTATION, TRANSITION_WIDTH, TOUCHING_SHARE];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_equal_to_the_limit_is_allowed() {
        // 0.16 by way of a stiffness comes back as 0.16000000000000003.
        assert!(INDENTATION.admits(0.16 + f64::EPSILON) && !INDENTATION.admits(0.160_001));
        assert!(RESTITUTION.admits(0.8 - f64::EPSILON) && !RESTITUTION.admits(0.799_999));
        assert!(!INDENTATION.admits(f64::NAN) && !RESTITUTION.admits(f64::NAN));
    }
}
