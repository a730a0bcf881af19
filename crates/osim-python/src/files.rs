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
    /// Files that Python gave as bytes, by their names.
    pub(crate) memory: Memory,
    with_disk: bool,
    /// The bytes of every file that was read, from memory or from the disk.
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

    /// Reads a file from memory; or by `read_disk`, if the request may use the disk.
    fn read_with(
        &self,
        path: &Path,
        read_disk: impl FnOnce(&Path) -> Result<Vec<u8>, FileError>,
    ) -> Result<Vec<u8>, FileError> {
        let bytes = match self.memory.get(path) {
            Some(bytes) => bytes.clone(),
            None if path.as_os_str() == "-" => {
                let message = "a Python program has no model on its standard input: give a path, bytes or an opensim.Model";
                return Err(FileError::new(message));
            }
            None if !self.with_disk => {
                return Err(FileError::new(format!("{} did not come along", path.display())));
            }
            None => read_disk(path)?,
        };
        self.read.borrow_mut().insert(path.to_owned(), bytes.clone());
        Ok(bytes)
    }
}

impl Files for RequestFiles {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read_with(path, |path| Disk.read(path))
    }

    fn read_included(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read_with(path, |path| Disk.read_included(path))
    }

    fn exists(&self, path: &Path) -> bool {
        self.memory.contains_key(path) || self.with_disk && Disk.exists(path)
    }

    fn today(&self) -> Option<String> {
        Disk.today()
    }
}
