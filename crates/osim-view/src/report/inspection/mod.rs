//! The contacts of a model, and the figures of these under its weight, as text.

mod models_table;
pub mod spheres;
pub mod table;

pub use models_table::ModelsTable;
pub use spheres::csv_rows;
pub use table::text;
