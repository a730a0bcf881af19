//! The conditions of a drop test.

/// The conditions of a drop test, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DropValues {
    /// Body mass M, in kg.
    pub mass_kg: f64,
    /// Gravity g, in m/s².
    pub gravity_m_s2: f64,
    /// Height of the spheres' bottoms above the ground at the start, in m.
    pub height_m: f64,
    /// How long to follow the body, in s.
    pub duration_s: f64,
    /// Points of the series, both ends included.
    pub samples: usize,
}
