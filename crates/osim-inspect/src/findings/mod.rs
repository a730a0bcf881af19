//! Whether the contacts are right: findings, and what puts them right.

mod answers;
mod check;
mod found;
mod known;
mod limits;
mod places;
mod remedy;
mod result;
mod traps;

pub use check::{Changeable, check_model};
pub use found::Found;
pub use places::misplaced_spheres;
pub use result::{CheckResult, Counts};
