//! A model's contacts, and what they do under its weight, as text.

mod csv_rows;
pub(crate) mod force_groups;
pub(crate) mod lengths;
mod models_table;
pub(crate) mod rows;
mod sphere_sheet;
pub(crate) mod standing;
mod table;

pub use csv_rows::csv_rows;
pub use models_table::ModelsTable;
pub use table::text;
