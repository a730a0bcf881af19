//! Files that a model or a request names, wherever they are: on a disk, in memory, in a browser.

mod failure;
mod file_name;
mod model_files;
mod source;

pub use failure::Failure;
pub use file_name::FileName;
pub use model_files::{Beside, ModelFiles, OpenModel};
pub use source::{FileError, Files, InMemory};
