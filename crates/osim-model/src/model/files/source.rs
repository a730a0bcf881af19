//! Where bytes come from.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

/// Reads files by the names that models and requests give them.
///
/// The libraries read nothing by themselves. A front end hands them what it has: the command a disk, a page the files that
/// were dropped on it ([`InMemory`]). For a folder:
///
/// ```
/// use std::path::{Path, PathBuf};
/// use osim_model::files::{FileError, Files};
///
/// struct Folder(PathBuf);
///
/// impl Files for Folder {
///     fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
///         std::fs::read(self.0.join(path)).map_err(|error| FileError::new(error.to_string()))
///     }
///
///     fn exists(&self, path: &Path) -> bool {
///         self.0.join(path).is_file()
///     }
/// }
///
/// let folder = Folder("tests/data".into());
/// assert!(folder.read(Path::new("one_foot.osim")).is_ok_and(|bytes| bytes.starts_with(b"<?xml")));
/// assert!(!folder.exists(Path::new("two_feet.osim")));
/// ```
pub trait Files {
    /// The bytes of a file.
    ///
    /// # Errors
    /// It is not there or cannot be read.
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError>;

    /// The bytes of a file that another file names, such as a model that includes it. Who wrote that other file should not decide
    /// what else is opened: where the world has pipes and devices, this reads ordinary files only.
    ///
    /// # Errors
    /// Those of [`read`](Self::read), or it is not an ordinary file.
    fn read_included(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read(path)
    }

    /// Whether there is such a file. A name without a file may be that of a preset.
    fn exists(&self, path: &Path) -> bool;

    /// The date where the files are, as `2026-11-25`, for the notes that changed files get; `None` where nobody knows it.
    fn today(&self) -> Option<String> {
        None
    }
}

/// Why a file cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct FileError(String);

impl FileError {
    /// In words, without the name of the file.
    pub fn new(why: impl Into<String>) -> Self {
        Self(why.into())
    }

    /// The error that there is no such file.
    #[must_use]
    pub fn not_found() -> Self {
        Self::new("there is no such file: check the name and the folder")
    }
}

/// Files in memory, by name.
///
/// ```
/// use std::path::Path;
/// use osim_model::files::{Files, InMemory};
///
/// let files = InMemory::from_iter([("walker.osim", "<OpenSimDocument/>")]);
/// assert!(files.exists(Path::new("walker.osim")));
/// assert!(files.read(Path::new("runner.osim")).is_err());
/// // Models name files in folders beside their own.
/// assert!(files.exists(Path::new("parts/../walker.osim")));
/// ```
#[derive(Debug, Clone, Default)]
pub struct InMemory {
    files: BTreeMap<PathBuf, Vec<u8>>,
    today: Option<String>,
}

impl InMemory {
    /// Adds a file, or replaces the one of that name.
    pub fn add(&mut self, path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) {
        self.files.insert(plain(&path.into()), bytes.into());
    }

    /// Takes a file away, if it is there.
    pub fn remove(&mut self, path: &Path) {
        self.files.remove(&plain(path));
    }

    /// The date there, as `2026-11-25`: at first nobody knows it.
    pub fn set_today(&mut self, date: &str) {
        self.today = Some(date.to_owned());
    }
}

impl<P: Into<PathBuf>, B: Into<Vec<u8>>> FromIterator<(P, B)> for InMemory {
    fn from_iter<I: IntoIterator<Item = (P, B)>>(files: I) -> Self {
        let named = files.into_iter().map(|(path, bytes)| (plain(&path.into()), bytes.into()));
        Self { files: named.collect(), today: None }
    }
}

impl Files for InMemory {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.files.get(&plain(path)).cloned().ok_or_else(FileError::not_found)
    }

    fn exists(&self, path: &Path) -> bool {
        self.files.contains_key(&plain(path))
    }

    fn today(&self) -> Option<String> {
        self.today.clone()
    }
}

/// A path without `.` and `..`, as models write them to name files in folders beside their own.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir if matches!(plain.components().next_back(), Some(Component::Normal(_))) => {
                plain.pop();
            }
            component => plain.push(component),
        }
    }
    plain
}
