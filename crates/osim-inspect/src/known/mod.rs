//! Contacts that somebody published, known again by their dimensionless values; and which findings are their published state.

mod odd_side;
mod recognise;
mod reference_contacts;
mod slip;
mod table;

pub(crate) use odd_side::{KnownSide, odd_side};
pub use recognise::KnownContacts;
pub use reference_contacts::ReferenceContacts;
pub use slip::{perhaps_in_pounds, unexplained_slip};
