//! Writing without ever leaving a file half written or losing one.

mod prepared;
pub(crate) mod temporary;

pub(crate) use prepared::backup;
pub use prepared::{Mode, Prepared};
