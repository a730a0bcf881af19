//! A request type for each verb, with typed fields.

mod any;
mod change;
mod design_and_fit;
mod inspect;
mod knowledge;
mod library;
mod plot;
mod verbs;

pub use any::NoteDetails;
pub use change::*;
pub use design_and_fit::*;
pub use inspect::*;
pub use knowledge::*;
pub use library::*;
pub use plot::*;
pub use verbs::*;
