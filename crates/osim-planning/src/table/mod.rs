//! Rows of a table as requests: one row for each model.

mod cells;
mod columns;
mod fault;
mod masses;
mod read;

pub use fault::RowFault;
pub use read::{RowRequest, Table};
