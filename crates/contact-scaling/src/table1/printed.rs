//! What the paper says of its drop tests.

/// Gravity of the drop tests, m/s²: "gravity on Earth" in the paper, whose digits follow from 9.81 and not from OpenSim's 9.80665.
pub const GRAVITY_M_S2: f64 = 9.81;

/// Height of the drop tests, in radii (Section 3).
pub const HEIGHT_RADII: f64 = 0.25;

/// Duration of the drop tests, s (Section 3).
pub const DURATION_S: f64 = 2.0;

/// The rows of the table.
pub(super) fn lines() -> impl Iterator<Item = &'static str> {
    // The first two lines say what it is, and name the columns.
    include_str!("printed.csv").lines().skip(2)
}
