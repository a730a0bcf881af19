//! The note that the tool leaves in a model: which mass its contacts were made for, at which size of its bones, and by what.
//!
//! A model keeps it in `<credits>`, which every OpenSim from 1.9 to 4.6 copies when it saves or scales a model; comments are
//! lost then. Standalone sets have no credits and keep a comment.

mod comment;
mod credits;
mod data;
mod found;
mod grammar;
mod parts;
mod since;
mod spelling;
mod step;

pub use credits::Credits;
pub use data::{BodySize, Note, Scope};
pub(crate) use found::NotesFound;
pub use parts::{NotedNames, NotedParts};
pub use since::{ChangedContacts, ChangedSinceNote};
pub use step::{Source, Step};
