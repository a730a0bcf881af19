//! Tables as text: CSV of any country, and texts as cells of it.

mod cell;
mod spreadsheet;
mod unequal;

pub use cell::{cell, from_cell, marked, unmarked};
pub(crate) use spreadsheet::is_broken_formula;
pub use spreadsheet::{BROKEN_FORMULA, Row, Sheet};
