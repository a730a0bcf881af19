//! Which models a call is about, and reading them from the disk.

mod disk;
mod sources;
mod workbook;

pub(crate) use disk::MemoryFirst;
pub use disk::{Disk, Loaded, OrdinaryFiles, Origin, Stamp};
pub(crate) use sources::SWEEP_FOLDER_ENDING;
pub use sources::{Source, Sources, SplitName};
