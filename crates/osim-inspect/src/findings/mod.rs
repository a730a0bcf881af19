//! What is wrong with a model, and what would put it right.

mod check;
mod finding;
mod limits;
mod remedy;
mod traps;

pub use check::{can_be_changed, check_known, check_model};
pub use finding::{CheckResult, Counts, Finding};
pub use remedy::{Remedy, RemedyChange, RemedyDesign, RemedyDialect, RemedyLoad};
