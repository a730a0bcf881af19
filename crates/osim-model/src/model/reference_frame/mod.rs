//! Reference frames as OpenSim has them: how they are turned, where they are in each other, and which of their axes points up.

mod moving;
mod placement;
mod rotation;

pub use moving::MovingPlacement;
pub use placement::Placement;
pub(crate) use placement::six_digits;
pub(crate) use rotation::times;
pub use rotation::{Axis, LevelAxis, Rotation, cross};
