//! A model that was opened.

use std::path::{Path, PathBuf};

use osim_model::files::{Failure, Files, ModelFiles, OpenModel};
use osim_requests::options::SetFiles;
use osim_view::html::NamedDigest;
use sha2::{Digest, Sha256};

use crate::shelf::Shelf;

/// A model that was opened, with the files of a standalone set.
#[derive(Debug)]
pub(crate) struct Opened {
    pub(crate) path: PathBuf,
    pub(crate) set_files: SetFiles,
    pub(crate) model: OpenModel,
    /// Its files, but for its own bytes.
    pub(crate) files: ModelFiles,
}

impl Opened {
    /// Opens the model at `path`.
    ///
    /// # Errors
    /// It cannot be read.
    pub(crate) fn read(path: &Path, set_files: &SetFiles, shelf: &Shelf) -> Result<Self, Failure> {
        let failed =
            |error: osim_model::files::FileError| Failure::outside(path, "unreadable", error.to_string());
        let bytes = shelf.read(path).map_err(failed)?;
        let all = ModelFiles::read(path, bytes, set_files.beside(), shelf)?;
        let files = all.with_bytes(Vec::new());
        Ok(Self { path: path.to_owned(), set_files: set_files.clone(), model: all.open()?, files })
    }

    /// Whether it is the model at `path` with these files.
    pub(crate) fn is(&self, path: &Path, set_files: &SetFiles) -> bool {
        self.path == path && self.set_files == *set_files
    }

    /// Names of the files that it was read from, the model first.
    pub(crate) fn names(&self) -> Vec<String> {
        self.model.files().map(|(name, _)| name.to_owned()).collect()
    }

    /// The same with their digests.
    pub(crate) fn digests(&self) -> Vec<NamedDigest> {
        let digest =
            |(name, bytes): (&str, &[u8])| NamedDigest { name: name.to_owned(), sha256: sha256(bytes) };
        self.model.files().map(digest).collect()
    }
}

/// The SHA-256 of some bytes, in hexadecimal digits.
pub(crate) fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
