//! A model's contacts, and what they do under its weight, as text.

mod models_table;
pub mod spheres;
pub mod table;

pub use models_table::ModelsTable;
pub use spheres::csv_rows;
pub use table::text;
