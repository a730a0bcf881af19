//! Whether contact spheres still fit their bodies, which OpenSim scales without them.
//!
//! From one file alone ([`evidence`]): the note in the file, a published layout on bones of another size, spheres beyond where
//! any published model has them. With the model that was scaled ([`compare`]) it is exact.

mod bones;
mod compare;
mod evidence;
mod layouts;
mod reach;

pub use compare::{PlacedSphere, Placement, is_stretched};
pub use evidence::Evidence;
pub use layouts::LayoutAnswer;
pub use reach::Reach;
