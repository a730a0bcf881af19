//! The folder of fixtures, for several test files.

use std::path::Path;

use osim_model::files::{FileError, Files};

/// Reads the files in the folder of fixtures from the disk.
pub(crate) struct Folder;

impl Folder {
    fn path(path: &Path) -> std::path::PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/feet").join(path)
    }
}

impl Files for Folder {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        std::fs::read(Self::path(path)).map_err(|error| FileError::new(error.to_string()))
    }

    fn exists(&self, path: &Path) -> bool {
        Self::path(path).is_file()
    }
}
