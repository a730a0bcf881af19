//! Reads the files of a request from memory or else from the disk. Keeps all bytes that were read, so that a result can be made
//! again without the disk.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_library::Disk;
use osim_model::files::{FileError, Files};
use pyo3::pybacked::PyBackedBytes;

/// Bytes of files by the files' names.
pub(crate) type Memory = BTreeMap<PathBuf, Vec<u8>>;

/// Reads files from memory first, then from the disk if `with_disk`.
pub(crate) struct RequestFiles {
    /// The files that Python gave.
    pub(crate) memory: Memory,
    with_disk: bool,
    /// Every file that was read.
    pub(crate) read: RefCell<Memory>,
}

impl RequestFiles {
    pub(crate) fn new(memory: Memory, with_disk: bool) -> Self {
        Self { memory, with_disk, read: RefCell::default() }
    }

    /// The files that Python gave, by name. Other files are read from the disk if `with_disk`.
    pub(crate) fn from_python(memory: &BTreeMap<PathBuf, PyBackedBytes>, with_disk: bool) -> Self {
        Self::new(memory.iter().map(|(path, bytes)| (path.clone(), bytes.to_vec())).collect(), with_disk)
    }

    fn record_read(&self, path: &Path, bytes: Vec<u8>) -> Vec<u8> {
        self.read.borrow_mut().insert(path.to_owned(), bytes.clone());
        bytes
    }

    fn read_without_disk(&self, path: &Path) -> Option<Result<Vec<u8>, FileError>> {
        match self.memory.get(path) {
            Some(bytes) => Some(Ok(self.record_read(path, bytes.clone()))),
            None if path.as_os_str() == "-" => {
                let message = "a Python program has no model on its standard input: give a path, bytes or an opensim.Model";
                Some(Err(FileError::new(message)))
            }
            None if !self.with_disk => {
                Some(Err(FileError::new(format!("{} did not come along", path.display()))))
            }
            None => None,
        }
    }
}

impl Files for RequestFiles {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read_without_disk(path)
            .unwrap_or_else(|| Disk.read(path).map(|bytes| self.record_read(path, bytes)))
    }

    fn read_included(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read_without_disk(path)
            .unwrap_or_else(|| Disk.read_included(path).map(|bytes| self.record_read(path, bytes)))
    }

    fn exists(&self, path: &Path) -> bool {
        self.memory.contains_key(path) || self.with_disk && Disk.exists(path)
    }

    fn today(&self) -> Option<String> {
        Disk.today()
    }
}
