//! Where the two laws stop being those of a material, and what smoothing the paper starts from.

/// The largest relative indentation x̂ for which the Hertz law was found accurate (Lin et al. 2009, as cited
/// in section 4.1): patch radius 0.4 R.
pub const HERTZ_RELATIVE_INDENTATION: f64 = 0.16;

/// The smallest restitution c_r for which the Hunt–Crossley law is accurate (section 4.2).
pub const HUNT_CROSSLEY_RESTITUTION: f64 = 0.8;

/// The largest constant relative indentation x̂_c = √cf / R that the paper starts from (section C.1): Falisse et
/// al. (2022), who had no trouble with it, have 0.0988. Where x̂ ≤ 0.16 is wanted, 0.05.
pub const CONSTANT_INDENTATION: f64 = 0.1;

/// The fraction t of the contact state from which, and up to 1 − t, the width of the contact transition is given
/// (section C.2).
pub const TRANSITION_THRESHOLD: f64 = 0.05;

/// The largest width Δx̂ of the contact transition, from 5 % to 95 %, that the paper starts from: 0.29 with
/// bd R = 10, 0.307 with the 9.6 of Falisse et al. (2022), who had no trouble with it (section C.2).
pub const TRANSITION_WIDTH: f64 = 0.31;

/// The largest force of a sphere that just touches, over its share of the body weight. The paper shows the harm
/// (Fig. C.5) and prints no limit; Falisse et al. (2022), whose smoothing "does not have the issue", have 0.074.
pub const TOUCHING_SHARE: f64 = 0.1;

/// Whether the Hertz law holds at the relative indentation x̂: x̂ ≤ 0.16.
///
/// ```
/// assert!(!contact_scaling::limits::hertz_holds(0.353)); // every model of Table 1
/// ```
#[must_use]
pub fn hertz_holds(relative_indentation: f64) -> bool {
    relative_indentation <= HERTZ_RELATIVE_INDENTATION
}

/// Whether the Hunt–Crossley law holds at the restitution c_r: c_r ≥ 0.8.
///
/// ```
/// assert!(!contact_scaling::limits::hunt_crossley_holds(0.2)); // the human of Table 1
/// ```
#[must_use]
pub fn hunt_crossley_holds(restitution: f64) -> bool {
    restitution >= HUNT_CROSSLEY_RESTITUTION
}
