//! A plan as text.

mod diff;
pub mod groups;
pub mod object_groups;
pub mod table;

pub use diff::unified_diff;
pub use table::{line, text};
