//! Whether the contacts are right: findings, and what puts them right.

mod answers;
mod check;
mod found;
mod kin;
mod known;
mod places;
mod remedy;
mod result;
mod traps;

pub use check::{Changeable, check_model, check_numbers};
pub use found::Found;
pub use kin::Kin;
pub use places::misplaced_spheres;
pub(crate) use remedy::{Remedies, exactly, rounded, standing_width, touching_indentation};
pub use result::{CheckResult, Counts};
