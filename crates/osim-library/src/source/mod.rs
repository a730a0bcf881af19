//! Finds the models that a call names, and reads them from the disk or standard input, with all the files that belong to them.

mod find_models;
mod workbook;

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;
use std::fs::Metadata;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use crate::paths::similar_file;
use osim_model::FileId;
use osim_model::files::{Failure, FileError, Files, ModelFiles};
use osim_requests::options::SetFiles;

use crate::fault::{Context, LibraryFault, Result};
use crate::file_access::{self, FileKinds, sha256};
use crate::folder_of;

pub(crate) use find_models::SWEEP_FOLDER_ENDING;
pub use find_models::{ModelSource, Sources, SplitName};
pub use workbook::workbook_as_csv;

/// Reads files that the user named from the disk, also pipes and devices; the path `-` is standard input. A file whose name is in
/// another file has to be an ordinary file.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        read(path, FileKinds::Streams).map(|(bytes, _)| bytes).map_err(|error| with_advice(path, error))
    }

    fn read_included(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        OrdinaryFiles.read(path)
    }

    fn exists(&self, path: &Path) -> bool {
        path.exists()
    }

    fn today(&self) -> Option<String> {
        date_of(std::env::var("SOURCE_DATE_EPOCH").ok().as_deref(), SystemTime::now())
    }
}

/// The `error` of a file that the user named, with what may be meant instead.
fn with_advice(path: &Path, error: FileError) -> FileError {
    let typed = path.to_string_lossy();
    let advice = match similar_file(path) {
        _ if path.exists() => return error,
        _ if typed.contains("://") => "there is no such file, but an address: download it first".to_owned(),
        // The shells of Windows leave it to the program.
        _ if typed.contains('*') => {
            "there is no such file, and * is not expanded: name the folder or a file".to_owned()
        }
        Some(near) => format!("there is no such file: did you mean {}?", near.display()),
        None => return error,
    };
    FileError::new(advice)
}

/// The date in UTC: of `epoch` (seconds since 1970), which repeatable builds set, or else of `now`.
fn date_of(epoch: Option<&str>, now: SystemTime) -> Option<String> {
    let set = epoch.and_then(|seconds| seconds.parse().ok()).map(Duration::from_secs);
    let moment = set.map_or(Some(now), |since| SystemTime::UNIX_EPOCH.checked_add(since))?;
    // A clock that was never set may have a time without a date.
    let mut text = String::new();
    write!(text, "{}", humantime::format_rfc3339_seconds(moment)).ok()?;
    text.split_once('T').map(|(date, _)| date.to_owned())
}

/// Reads only ordinary files from the disk. It is used for names in a file such as a table.
#[derive(Debug, Clone, Copy, Default)]
pub struct OrdinaryFiles;

impl Files for OrdinaryFiles {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        read(path, FileKinds::Ordinary).map(|(bytes, _)| bytes)
    }

    fn exists(&self, path: &Path) -> bool {
        path.exists()
    }
}

/// Reads a whole file, or standard input, which has no stamp.
///
/// # Errors
/// The file does not exist, cannot be read, or changes while it is read.
fn read(path: &Path, kinds: FileKinds) -> Result<(Vec<u8>, Option<Metadata>), FileError> {
    if path.as_os_str() == "-" && kinds == FileKinds::Streams {
        let unread = |why: file_access::ReadRefusal| FileError::new(format!("standard input: {why}"));
        return Ok((file_access::standard_input().map_err(unread)?, None));
    }
    let (bytes, metadata) = file_access::read(path, kinds)?;
    Ok((workbook_as_csv(bytes)?, Some(metadata)))
}

/// Bytes of a model and of the files that belong to it, and the paths that they come from.
pub struct LoadedModel {
    pub files: ModelFiles,
    pub origin: ModelOrigin,
}

/// Where the files of a model were read, and their stamps, by which later changes are noticed.
pub struct ModelOrigin {
    path: PathBuf,
    /// Stamps of files on the disk; standard input and models in memory have none.
    stamps: HashMap<PathBuf, Metadata>,
    companions: HashMap<FileId, PathBuf>,
    /// Names of the files that the model includes, as the model spells them.
    included: Vec<String>,
}

impl LoadedModel {
    /// Reads the model `source`, the files that it includes and the files `set_files` that the user gave beside it.
    pub fn read(source: &ModelSource, set_files: &SetFiles) -> Result<Self, Failure> {
        Self::read_with_memory(source, set_files, &BTreeMap::new())
    }

    /// Reads the model `source` and the files that belong to it. A file in `memory` replaces a file of the same name on the disk.
    pub fn read_with_memory(
        source: &ModelSource,
        set_files: &SetFiles,
        memory: &BTreeMap<PathBuf, Vec<u8>>,
    ) -> Result<Self, Failure> {
        let kinds = if source.named { FileKinds::Streams } else { FileKinds::Ordinary };
        let disk = MemoryFirst { memory, kinds, stamps: RefCell::default() };
        let unreadable = |error| {
            let message = with_advice(&source.path, error).to_string();
            Failure::outside(source.path.as_path(), "unreadable", message)
        };
        let bytes = disk.read(&source.path).map_err(unreadable)?;
        let files = ModelFiles::read(&source.path, bytes, set_files.companion_paths(), &disk)?;
        Ok(Self::new(&source.path, files, disk.stamps.into_inner()))
    }

    /// A model with the given `bytes` and the name `path`; `files` has the files beside the model.
    pub fn in_memory(
        path: &Path,
        bytes: Vec<u8>,
        set_files: &SetFiles,
        files: &dyn Files,
    ) -> Result<Self, Failure> {
        let files = ModelFiles::read(path, bytes, set_files.companion_paths(), files)?;
        Ok(Self::new(path, files, HashMap::new()))
    }

    fn new(path: &Path, files: ModelFiles, stamps: HashMap<PathBuf, Metadata>) -> Self {
        let included = files.included().map(str::to_owned).collect();
        let companions = files.companions().map(|(file, path, _)| (file, path.to_owned())).collect();
        let origin = ModelOrigin { path: path.to_owned(), stamps, companions, included };
        Self { files, origin }
    }

    /// SHA-256 of each file, the model first, in the order of [`OpenModel::files`](osim_model::files::OpenModel::files).
    pub fn digests(&self) -> Vec<String> {
        let companions = self.files.companions().map(|(.., bytes)| bytes);
        std::iter::once(self.files.bytes()).chain(companions).map(sha256).collect()
    }
}

/// Reads a file from memory, or from the disk if memory has no file of this name.
pub(crate) struct MemoryFirst<'m> {
    pub(crate) memory: &'m BTreeMap<PathBuf, Vec<u8>>,
    /// The kinds of files that may be named on the disk.
    pub(crate) kinds: FileKinds,
    /// The metadata that each file on the disk had when it was read, to notice later changes by other programs.
    pub(crate) stamps: RefCell<HashMap<PathBuf, Metadata>>,
}

impl MemoryFirst<'_> {
    fn read_with_stamp(&self, path: &Path, kinds: FileKinds) -> Result<Vec<u8>, FileError> {
        if let Some(bytes) = self.memory.get(path) {
            return Ok(bytes.clone());
        }
        let (bytes, stamp) = read(path, kinds)?;
        if let Some(stamp) = stamp {
            self.stamps.borrow_mut().insert(path.to_owned(), stamp);
        }
        Ok(bytes)
    }
}

impl Files for MemoryFirst<'_> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read_with_stamp(path, self.kinds)
    }

    fn read_included(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read_with_stamp(path, FileKinds::Ordinary)
    }

    fn exists(&self, path: &Path) -> bool {
        self.memory.contains_key(path) || path.exists()
    }
}

impl ModelOrigin {
    /// Metadata of one of the model's files when it was read; `None` for standard input.
    pub(crate) fn stamp_of(&self, file: FileId) -> Option<&Metadata> {
        let path = if file == FileId::MAIN { &self.path } else { self.companions.get(&file)? };
        self.stamps.get(path)
    }

    /// Refuses a file whose length or time changed since it was read.
    ///
    /// # Errors
    /// The file was changed or removed since it was read.
    pub(crate) fn refuse_if_changed(&self, file: FileId, path: &Path) -> Result<()> {
        let Some(then) = self.stamp_of(file) else { return Ok(()) };
        let gone = || format!("{} is no longer there, so nothing was written", path.display());
        let now = std::fs::metadata(path).context(gone)?;
        if now.len() != then.len() || now.modified().ok() != then.modified().ok() {
            return Err(LibraryFault::new(format!(
                "another program changed {} while it was being worked on, so nothing was written: run again",
                path.display()
            )));
        }
        Ok(())
    }

    /// The file of the model whose path is `path`.
    pub(crate) fn file_at(&self, path: &Path) -> Option<FileId> {
        self.companions.iter().find(|(_, companion)| *companion == path).map(|(&file, _)| file)
    }

    /// Refuses an output in a folder where OpenSim would not find the files that the model includes.
    ///
    /// # Errors
    /// The first included file that OpenSim would not find.
    pub(crate) fn refuse_output_without_includes(&self, output: &Path) -> Result<()> {
        for file in &self.included {
            if !folder_of(output).join(file).is_file() {
                return Err(LibraryFault::new(format!(
                    "the model includes file=\"{file}\", which is not in {}: copy it there first, or write beside the model",
                    folder_of(output).display()
                )));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_date_is_that_of_the_clock_or_of_a_repeatable_build() {
        let now = SystemTime::UNIX_EPOCH + Duration::from_secs(1_764_115_199);
        // date -u -d @1764115199: Tue Nov 25 23:59:59 UTC 2025.
        assert_eq!(date_of(None, now).as_deref(), Some("2025-11-25"));
        assert_eq!(date_of(Some("1764115200"), now).as_deref(), Some("2025-11-26"));
        assert_eq!(date_of(Some("soon"), now).as_deref(), Some("2025-11-25"));
        assert_eq!(date_of(Some(&u64::MAX.to_string()), now), None);
    }
}
