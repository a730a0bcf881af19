//! A plan as text.

mod diff;
pub(crate) mod groups;
pub(crate) mod object_groups;
pub(crate) mod table;

pub use diff::unified_diff;
pub use table::{line, text};
