//! Frames as OpenSim has them: how they are turned, where they are in each other, and which of their axes points up.

mod placement;
mod rotation;

pub use placement::{Placement, six_digits};
pub use rotation::{Axis, LevelAxis, Rotation, times};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
