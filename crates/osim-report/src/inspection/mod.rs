//! A model's contacts, and what they do under its weight, as text.

mod csv_rows;
pub(crate) mod force_groups;
pub(crate) mod lengths;
pub(crate) mod rows;
mod sphere_sheet;
pub(crate) mod standing;
mod table;

pub use csv_rows::csv_rows;
pub use table::text;
