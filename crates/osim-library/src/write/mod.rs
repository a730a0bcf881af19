//! Writing without ever leaving a file half written or losing one.

#[cfg(target_os = "linux")]
mod access_list;
pub(crate) mod exchange;
mod in_place;
mod replace;
pub(crate) mod temporary;

pub(crate) use in_place::{ExchangedModel, Successor, hard_link_finding};
pub(crate) use replace::backup;
pub use replace::{PendingFile, WriteMode};
