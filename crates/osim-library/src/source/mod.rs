//! Which models a call is about, and reading them from the disk.

mod blanks;
mod disk;
mod loaded;
mod sources;
mod workbook;

pub use blanks::SplitName;
pub use disk::{Disk, OrdinaryFiles, Stamp};
pub use loaded::{Loaded, Origin};
pub use sources::{FOLDER_MARK, Source, Sources};
