//! Writing without ever leaving a file half written or losing one.

#[cfg(target_os = "linux")]
mod access_list;
mod in_place;
mod prepared;
pub(crate) mod replaced;
pub(crate) mod temporary;

pub(crate) use in_place::{InPlace, Successor, other_names};
pub(crate) use prepared::backup;
pub use prepared::{Mode, Prepared};
