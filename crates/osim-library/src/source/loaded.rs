//! A model with all the files that belong to it, from the disk.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

use osim_model::FileId;
use osim_model::files::{Failure, FileError, Files, ModelFiles};
use osim_requests::options::SetFiles;

use super::disk::{Stamp, StampedDisk};
use super::sources::Source;
use crate::digest::sha256;
use crate::door::Kinds;
use crate::fault::LibraryFault;
use crate::paths::folder_of;

/// Bytes of a model and of the files that belong to it, and where they come from.
#[derive(Debug)]
#[non_exhaustive]
pub struct Loaded {
    /// The files.
    pub files: ModelFiles,
    /// Where they come from.
    pub origin: Origin,
}

/// Where a model comes from.
#[derive(Debug)]
pub struct Origin {
    path: PathBuf,
    /// Files as they were when they were read; standard input and a model in memory are none.
    stamps: HashMap<PathBuf, Stamp>,
    /// The other files.
    companions: HashMap<FileId, PathBuf>,
    /// Files that the model includes, as it names them.
    included: Vec<String>,
}

impl Loaded {
    /// Reads `source`, the files it includes and those given beside it.
    ///
    /// # Errors
    /// One of them cannot be read.
    pub fn read(source: &Source, set_files: &SetFiles) -> Result<Self, Failure> {
        Self::read_beside(source, set_files, &BTreeMap::new())
    }

    /// Reads `source` and the files that belong to it. Those that are in `memory` are taken from there, also where the disk has
    /// others of the same name.
    ///
    /// # Errors
    /// One of them cannot be read.
    pub fn read_beside(
        source: &Source,
        set_files: &SetFiles,
        memory: &BTreeMap<PathBuf, Vec<u8>>,
    ) -> Result<Self, Failure> {
        let stamped = StampedDisk::new(if source.named { Kinds::Streams } else { Kinds::Ordinary });
        let disk = MemoryFirst { memory, disk: &stamped };
        let unreadable =
            |error: FileError| Failure::outside(source.path.as_path(), "unreadable", error.to_string());
        let bytes = disk.read(&source.path).map_err(unreadable)?;
        let files = ModelFiles::read(&source.path, bytes, set_files.beside(), &disk)?;
        Ok(Self::of(&source.path, files, stamped.into_stamps()))
    }

    /// A model whose bytes are known, at `path`, with the files that `files` has beside it.
    ///
    /// # Errors
    /// One of those cannot be read.
    pub fn in_memory(
        path: &Path,
        bytes: Vec<u8>,
        set_files: &SetFiles,
        files: &dyn Files,
    ) -> Result<Self, Failure> {
        Ok(Self::of(path, ModelFiles::read(path, bytes, set_files.beside(), files)?, HashMap::new()))
    }

    fn of(path: &Path, files: ModelFiles, stamps: HashMap<PathBuf, Stamp>) -> Self {
        let included = files.included().map(str::to_owned).collect();
        let companions = files.companions().map(|(file, path, _)| (file, path.to_owned())).collect();
        let origin = Origin { path: path.to_owned(), stamps, companions, included };
        Self { files, origin }
    }

    /// SHA-256 of each file, the model first, in the order of [`OpenModel::files`](osim_model::files::OpenModel::files).
    #[must_use]
    pub fn digests(&self) -> Vec<String> {
        let companions = self.files.companions().map(|(.., bytes)| bytes);
        std::iter::once(self.files.bytes()).chain(companions).map(sha256).collect()
    }
}

/// Files in memory, then those of the disk.
struct MemoryFirst<'m> {
    memory: &'m BTreeMap<PathBuf, Vec<u8>>,
    disk: &'m StampedDisk,
}

impl Files for MemoryFirst<'_> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.memory.get(path).map_or_else(|| self.disk.read(path), |bytes| Ok(bytes.clone()))
    }

    fn read_included(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.memory.get(path).map_or_else(|| self.disk.read_included(path), |bytes| Ok(bytes.clone()))
    }

    fn exists(&self, path: &Path) -> bool {
        self.memory.contains_key(path) || self.disk.exists(path)
    }
}

impl Origin {
    /// A file of the model as it was when it was read; `None` for standard input.
    #[must_use]
    pub fn stamp_of(&self, file: FileId) -> Option<&Stamp> {
        let path = if file == FileId::MAIN { &self.path } else { self.companions.get(&file)? };
        self.stamps.get(path)
    }

    /// Which of the model's files is at `path`.
    pub(crate) fn file_at(&self, path: &Path) -> Option<FileId> {
        self.companions.iter().find(|(_, companion)| *companion == path).map(|(&file, _)| file)
    }

    /// Refuses to write the model where OpenSim would not find the files that it includes.
    ///
    /// # Errors
    /// The first that is not there.
    pub fn find_included_from(&self, output: &Path) -> Result<(), LibraryFault> {
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
