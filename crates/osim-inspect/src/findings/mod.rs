//! Whether the contacts are right: findings, and what puts them right.

mod check;
mod finding;
mod remedy;
mod result;

pub use check::{Changeable, check_model, check_numbers};
pub use finding::{Found, Kin};
pub(crate) use remedy::{Remedies, exactly, rounded, standing_width, touching_indentation};
pub use result::{CheckResult, Counts};
