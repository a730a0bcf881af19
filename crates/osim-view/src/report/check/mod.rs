//! What was found, as text.

mod csv_rows;
mod library;
mod table;
mod verdicts;

pub use csv_rows::csv_rows;
pub use library::LibraryTable;
pub use table::text;
