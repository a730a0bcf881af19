//! A plan as text.

mod diff;
pub(crate) mod groups;
mod table;

pub use diff::unified_diff;
pub use table::{line, text};
