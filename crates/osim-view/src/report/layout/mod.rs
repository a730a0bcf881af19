//! How texts are laid out in 80 columns.

mod broken;
mod columns;
mod lines;
mod names;
mod paint;
mod sheet;
mod words;

pub use broken::broken;
pub use columns::{TextTable, table};
pub use lines::{WIDTH, wrapped};
pub(crate) use lines::{filled, options, wrapped_with_path};
pub use names::clipped;
pub use paint::{Colour, OUTSIDE};
pub(crate) use paint::{painted, severity, sign};
pub(crate) use sheet::csv_text;
