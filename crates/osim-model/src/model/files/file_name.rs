//! The name of a file, for people and for scripts.

use std::fmt;
use std::ops::Deref;
use std::path::{Path, PathBuf};

use crate::messages::shown_whole;

/// A file as it was named: text, and the bytes of the name if it is not UTF-8 and the text only an approximation.
///
/// It prints on one line, with what cannot be seen escaped; [`Deref`] gives the text itself.
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
    /// The bytes of the name as the system has them, where they are not UTF-8.
    #[must_use]
    pub fn bytes(&self) -> Option<&[u8]> {
        self.bytes.as_deref()
    }

    /// The name with the bytes that [`into_parts`](Self::into_parts) gave.
    #[must_use]
    pub fn from_parts(text: String, bytes: Option<Vec<u8>>) -> Self {
        Self { text, bytes: bytes.map(Into::into) }
    }

    /// The name as the system has it, where the system has names of bytes; elsewhere the text.
    #[must_use]
    pub fn to_path(&self) -> PathBuf {
        #[cfg(unix)]
        if let Some(bytes) = &self.bytes {
            return <std::ffi::OsStr as std::os::unix::ffi::OsStrExt>::from_bytes(bytes).into();
        }
        PathBuf::from(&self.text)
    }

    /// The text, and the bytes where they are not UTF-8: as JSON has them, side by side.
    #[must_use]
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

impl From<&Path> for FileName {
    fn from(path: &Path) -> Self {
        let bytes = path.to_str().is_none().then(|| path.as_os_str().as_encoded_bytes().into());
        Self { text: path.to_string_lossy().into_owned(), bytes }
    }
}

impl From<String> for FileName {
    fn from(text: String) -> Self {
        Self { text, bytes: None }
    }
}

impl From<&str> for FileName {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<&String> for FileName {
    fn from(text: &String) -> Self {
        text.as_str().into()
    }
}

impl From<&Self> for FileName {
    fn from(name: &Self) -> Self {
        name.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_name_that_is_no_utf8_keeps_its_bytes() {
        use std::os::unix::ffi::OsStrExt;

        let name = FileName::from(Path::new(std::ffi::OsStr::from_bytes(b"m\xE4use.osim")));
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
