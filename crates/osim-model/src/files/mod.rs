//! Files that a model or a request names, wherever they are: on a disk, in memory, in a browser.

mod failure;
mod model_files;
mod source;

pub use failure::Failure;
pub use model_files::{Beside, ModelFiles, OpenModel};
pub use source::{FileError, Files, InMemory};
