//! Contacts along a recorded motion, beside what force plates measured.

mod beyond;
pub(crate) mod opened;
mod plates;
pub(crate) mod remarks;
mod result;
pub(crate) mod run;
mod verdict;

pub use plates::PlatesRead;
pub use remarks::MotionRemark;
pub use result::MotionResult;
pub use run::run_motion;
pub(crate) use verdict::CheckedMotion;
