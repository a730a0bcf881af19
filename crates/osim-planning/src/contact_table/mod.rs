//! Contacts in a table: their names, bodies, places and radii.

mod columns;
mod fault;
mod place;
mod read;

pub use fault::TableFault;
pub use place::{PlaceFault, PlaceOnBody, TablePlace};
pub use read::{ContactRow, ContactTable};
