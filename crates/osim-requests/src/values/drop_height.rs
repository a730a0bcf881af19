//! From how high a body falls.

use osim_model::messages::readable;

/// Height of the sphere bottoms at the start of a fall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DropHeight {
    /// In m.
    Metres(f64),
    /// In radii of the sphere.
    Radii(f64),
}

impl DropHeight {
    /// In m, for a sphere of this radius.
    #[must_use]
    pub fn metres(self, radius_m: f64) -> f64 {
        match self {
            Self::Metres(metres) => metres,
            Self::Radii(radii) => radii * radius_m,
        }
    }

    /// For people: the number, and what it counts.
    #[must_use]
    pub fn describe(self, metre: &str, radius: &str) -> String {
        match self {
            Self::Metres(metres) => format!("{} {metre}", readable(metres)),
            Self::Radii(radii) => format!("{} {radius}", readable(radii)),
        }
    }
}
