//! Whether a floor is a floor: how it is turned against gravity, and what it hangs on.

mod judged;
mod slope;
mod stance;

pub(crate) use judged::{Floors, JudgedPlane, PlaneKind};
pub use slope::weight_share;
pub(crate) use slope::weight_share_at;
