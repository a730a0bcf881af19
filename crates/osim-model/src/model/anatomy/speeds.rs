//! How the coordinates of a joint change.

use crate::model::reference_frame::Rotation;

/// How the coordinates of a joint change, one number for each; 0 where there are fewer.
///
/// The two differ for the three angles of a BallJoint, FreeJoint and EllipsoidJoint alone: there, OpenSim's speeds (the `speed` columns
/// of its states) are the child's angular velocity in the parent's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speeds<'s> {
    /// Derivatives of the values, rad/s or m/s.
    Rates(&'s [f64]),
    /// OpenSim's generalized speeds.
    OfOpenSim(&'s [f64]),
}

impl Speeds<'_> {
    /// One of them.
    pub(super) fn get(&self, index: usize) -> f64 {
        let (Self::Rates(all) | Self::OfOpenSim(all)) = self;
        all.get(index).copied().unwrap_or(0.0)
    }

    /// The angular velocity of a frame that is turned by the first three of `values`, rad/s.
    pub(super) fn turning(&self, values: &[f64]) -> [f64; 3] {
        let first = [self.get(0), self.get(1), self.get(2)];
        match self {
            Self::Rates(_) => {
                let value = |index: usize| values.get(index).copied().unwrap_or(0.0);
                Rotation::body_fixed_velocity([value(0), value(1), value(2)], first)
            }
            Self::OfOpenSim(_) => first,
        }
    }
}
