//! A request type for each verb, with typed fields.

mod any;
mod change;
mod inspect;
mod knowledge;
mod library;
mod design_and_fit;
mod plot;
mod verbs;

pub use any::NoteDetails;
pub use change::*;
pub use inspect::*;
pub use knowledge::*;
pub use library::*;
pub use design_and_fit::*;
pub use plot::*;
pub use verbs::*;
