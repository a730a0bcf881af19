//! The modules of one target of a crate, and the files they stand in.

mod module;
mod place;
mod read;

pub(crate) use module::{Module, ModuleId, Tree};
pub(crate) use read::{read, shown};
