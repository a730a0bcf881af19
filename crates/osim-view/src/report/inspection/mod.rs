//! A model's contacts, and what they do under its weight, as text.

mod csv_rows;
pub mod force_groups;
pub mod lengths;
mod models_table;
pub mod on_feet;
pub mod rows;
mod sphere_sheet;
pub mod standing;
mod table;

pub use csv_rows::csv_rows;
pub use models_table::ModelsTable;
pub use table::text;
