//! Names of files in JSON, which knows text only.

use std::path::Path;

/// The name as text.
pub(super) fn text(path: &Path) -> String {
    path.display().to_string()
}

/// The bytes of a name that is not UTF-8, of which the text is only an approximation.
pub(crate) fn bytes(path: &Path) -> Option<Vec<u8>> {
    path.to_str().is_none().then(|| path.as_os_str().as_encoded_bytes().to_vec())
}
