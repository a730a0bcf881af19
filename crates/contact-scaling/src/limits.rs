//! Where the two laws stop being those of a material.

/// The largest relative indentation x̂ for which the Hertz law was found accurate (Lin et al. 2009, as cited
/// in section 4.1): patch radius 0.4 R.
pub const HERTZ_RELATIVE_INDENTATION: f64 = 0.16;

/// The smallest restitution c_r for which the Hunt–Crossley law is accurate (section 4.2).
pub const HUNT_CROSSLEY_RESTITUTION: f64 = 0.8;

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
