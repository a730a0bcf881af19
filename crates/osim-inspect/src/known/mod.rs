//! Contacts that somebody published, known again by their dimensionless values; and which findings are their published state.

mod recognise;
mod slip;
mod table;

pub use recognise::KnownContacts;
pub use slip::unexplained_slip;
