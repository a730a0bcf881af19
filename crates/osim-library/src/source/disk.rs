//! Files on a disk, and standard input.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fs::{File, Metadata};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use osim_model::files::{FileError, Files};

use crate::fault::{Context, LibraryFault};

/// The disk: paths are those of the file system, and `-` is standard input.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        read(path).map(|(bytes, _)| bytes)
    }

    fn exists(&self, path: &Path) -> bool {
        path.exists()
    }
}

/// The disk, remembering each file as it was when it was read.
#[derive(Debug, Default)]
pub(super) struct StampedDisk {
    stamps: RefCell<HashMap<PathBuf, Stamp>>,
}

impl StampedDisk {
    pub(super) fn into_stamps(self) -> HashMap<PathBuf, Stamp> {
        self.stamps.into_inner()
    }
}

impl Files for StampedDisk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        let (bytes, stamp) = read(path)?;
        if let Some(stamp) = stamp {
            self.stamps.borrow_mut().insert(path.to_owned(), stamp);
        }
        Ok(bytes)
    }

    fn exists(&self, path: &Path) -> bool {
        path.exists()
    }
}

/// A file's metadata at a moment, to notice that somebody else writes it.
#[derive(Debug, Clone)]
pub struct Stamp {
    metadata: Metadata,
    modified: Option<SystemTime>,
}

impl Stamp {
    fn of(metadata: Metadata) -> Self {
        let modified = metadata.modified().ok();
        Self { metadata, modified }
    }

    /// The metadata at that moment.
    #[must_use]
    pub fn metadata(&self) -> &Metadata {
        &self.metadata
    }

    /// Refuses a file that is no longer as it was read.
    ///
    /// # Errors
    /// It was changed or removed since.
    pub(crate) fn still_holds(&self, path: &Path) -> Result<(), LibraryFault> {
        let gone = || format!("{} is no longer there, so nothing was written", path.display());
        let now = std::fs::metadata(path).context(gone)?;
        if now.len() != self.metadata.len() || now.modified().ok() != self.modified {
            return Err(LibraryFault::new(format!(
                "another program changed {} while it was being worked on, so nothing was written: run again",
                path.display()
            )));
        }
        Ok(())
    }
}

/// Reads a whole file, or standard input, which has no stamp.
///
/// # Errors
/// It is not there, cannot be read, or changes while it is being read.
fn read(path: &Path) -> Result<(Vec<u8>, Option<Stamp>), FileError> {
    let mut bytes = Vec::new();
    if path.as_os_str() == "-" {
        let read = std::io::stdin().lock().read_to_end(&mut bytes);
        read.map_err(|error| FileError::new(format!("cannot read standard input: {error}")))?;
        return Ok((bytes, None));
    }
    let cannot = |error: std::io::Error| FileError::new(format!("cannot be read: {error}"));
    let mut file = File::open(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => FileError::not_found(),
        _ => cannot(error),
    })?;
    let stamp = Stamp::of(file.metadata().map_err(cannot)?);
    let length = usize::try_from(stamp.metadata.len()).unwrap_or(0);
    bytes.try_reserve_exact(length).map_err(|error| {
        FileError::new(format!("cannot be read: too large for this computer's memory: {error}"))
    })?;
    file.read_to_end(&mut bytes).map_err(cannot)?;
    let after = file.metadata().map_err(cannot)?;
    let changed = after.modified().ok() != stamp.modified || bytes.len() as u64 != after.len();
    if changed && after.is_file() {
        let why = "another program changed it while it was being read: run again when that is done";
        return Err(FileError::new(why));
    }
    Ok((bytes, Some(stamp)))
}
