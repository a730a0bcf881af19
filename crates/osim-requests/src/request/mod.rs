//! A request type for each verb, with typed fields.

mod any;
mod change;
mod inspect;
mod knowledge;
mod library;
mod parameters;
mod plot;
mod verbs;

pub use any::NoteDetails;
pub use change::*;
pub use inspect::*;
pub use knowledge::*;
pub use library::*;
pub use parameters::*;
pub use plot::*;
pub use verbs::*;
