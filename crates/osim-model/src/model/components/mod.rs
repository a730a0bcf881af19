//! The components of a model: which elements OpenSim turns into objects, what they are called, and what their sockets mean.

mod classes;
mod counted;
mod documents;
mod tree;

pub use documents::Companion;
pub(crate) use documents::{Base, Components, MAX_FRAME_CHAIN};
pub(crate) use tree::{Component, ComponentId};
