//! Numbers of a model that have mass, length or time in their unit, beside those of its contacts: of muscles, ligaments, springs,
//! bushings, actuators and bodies.

mod classes;
mod kind;
mod read;

pub use kind::{Dimension, SizedKind};
pub use read::{NotRead, SizedValue, SizedValues};
