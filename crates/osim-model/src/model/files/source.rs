//! Reading the bytes of files from any source; and the names of files.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fmt;
use std::ops::Deref;
use std::path::{Component, Path, PathBuf};

use crate::messages::shown_whole;

/// A file name as the caller wrote it. If the name is not UTF-8, its bytes are kept and the text is only similar.
///
/// Prints on one line, with invisible letters escaped. [`Deref`] gives the text unchanged.
///
/// ```
/// use osim_model::files::FileName;
///
/// let name = FileName::from("feet.osim");
/// assert_eq!((&*name, name.bytes()), ("feet.osim", None));
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileName {
    text: String,
    bytes: Option<Box<[u8]>>,
}

impl FileName {
    /// The bytes of the name, if they are not UTF-8.
    pub fn bytes(&self) -> Option<&[u8]> {
        self.bytes.as_deref()
    }

    /// The name from the parts that [`into_parts`](Self::into_parts) returned.
    pub fn from_parts(text: String, bytes: Option<Vec<u8>>) -> Self {
        Self { text, bytes: bytes.map(Into::into) }
    }

    /// The name as a path. If the name is not UTF-8, systems whose file names are bytes get the exact bytes.
    pub fn to_path(&self) -> PathBuf {
        #[cfg(unix)]
        if let Some(bytes) = &self.bytes {
            return <OsStr as std::os::unix::ffi::OsStrExt>::from_bytes(bytes).into();
        }
        PathBuf::from(&self.text)
    }

    /// The text, and the bytes if they are not UTF-8: two fields in JSON.
    pub fn into_parts(self) -> (String, Option<Vec<u8>>) {
        (self.text, self.bytes.map(Into::into))
    }
}

impl Deref for FileName {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for FileName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        shown_whole(&self.text).fmt(f)
    }
}

impl<N: AsRef<OsStr> + ?Sized> From<&N> for FileName {
    fn from(name: &N) -> Self {
        let name = name.as_ref();
        let bytes = name.to_str().is_none().then(|| name.as_encoded_bytes().into());
        Self { text: name.to_string_lossy().into_owned(), bytes }
    }
}

impl From<String> for FileName {
    fn from(text: String) -> Self {
        Self { text, bytes: None }
    }
}

impl From<&Self> for FileName {
    fn from(name: &Self) -> Self {
        name.clone()
    }
}

/// Reads files by their names in models and requests.
///
/// The libraries of this project read no file directly. Each front end gives them a source: the command a disk, a web page the files that
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
    /// The bytes of the file at `path`.
    ///
    /// # Errors
    /// The file does not exist or cannot be read.
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError>;

    /// The bytes of a file that another file names, such as a model that includes it. On a system with pipes and devices, only ordinary
    /// files are read: the author of a model should not decide which devices are opened.
    ///
    /// # Errors
    /// As for [`read`](Self::read), or the file is not an ordinary file.
    fn read_included(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.read(path)
    }

    /// Whether the file exists. A name without a file may be the name of a preset.
    fn exists(&self, path: &Path) -> bool;

    /// Today's date, such as `2026-11-25`, for notes in changed files; `None` if it is not known.
    fn today(&self) -> Option<String> {
        None
    }
}

/// Why a file cannot be read, in words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct FileError(String);

impl FileError {
    /// An error with its reason in words, without the name of the file.
    pub fn new(why: impl Into<String>) -> Self {
        Self(why.into())
    }

    pub fn not_found() -> Self {
        Self::new("there is no such file: check the name and the folder")
    }
}

/// Files in memory, by their names.
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
    /// Adds a file, or replaces the file of this name.
    pub fn add(&mut self, path: impl Into<PathBuf>, bytes: impl Into<Vec<u8>>) {
        self.files.insert(without_dots(&path.into()), bytes.into());
    }

    /// Removes a file, if it exists.
    pub fn remove(&mut self, path: &Path) {
        self.files.remove(&without_dots(path));
    }

    /// Sets the date that [`Files::today`] returns, such as `2026-11-25`. Without a call, the date is not known.
    pub fn set_today(&mut self, date: &str) {
        self.today = Some(date.to_owned());
    }
}

impl<P: Into<PathBuf>, B: Into<Vec<u8>>> FromIterator<(P, B)> for InMemory {
    fn from_iter<I: IntoIterator<Item = (P, B)>>(files: I) -> Self {
        let named = files.into_iter().map(|(path, bytes)| (without_dots(&path.into()), bytes.into()));
        Self { files: named.collect(), today: None }
    }
}

impl Files for InMemory {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.files.get(&without_dots(path)).cloned().ok_or_else(FileError::not_found)
    }

    fn exists(&self, path: &Path) -> bool {
        self.files.contains_key(&without_dots(path))
    }

    fn today(&self) -> Option<String> {
        self.today.clone()
    }
}

/// The path without `.` and `..`. Models use these to name files in other folders.
fn without_dots(path: &Path) -> PathBuf {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_name_that_is_no_utf8_keeps_its_bytes() {
        use std::os::unix::ffi::OsStrExt;

        let name = FileName::from(Path::new(OsStr::from_bytes(b"m\xE4use.osim")));
        assert_eq!(&*name, "m\u{FFFD}use.osim");
        assert_eq!(name.bytes(), Some(b"m\xE4use.osim".as_slice()));
        assert_eq!(name.to_path().as_os_str().as_bytes(), b"m\xE4use.osim");
        let (text, bytes) = name.clone().into_parts();
        assert_eq!(FileName::from_parts(text, bytes), name);
    }

    #[test]
    fn text_is_enough_for_other_names() {
        assert_eq!(FileName::from(Path::new("mäuse.osim")), FileName::from("mäuse.osim"));
    }
}
