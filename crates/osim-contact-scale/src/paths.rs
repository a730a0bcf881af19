//! Paths as the file system sees them, also where parts of them do not exist yet.

use std::path::{Component, Path, PathBuf};

/// The absolute path without links, `.` and `..`; what does not exist yet is taken as written.
pub(crate) fn resolved(path: &Path) -> PathBuf {
    let start = if path.is_absolute() { PathBuf::new() } else { std::env::current_dir().unwrap_or_default() };
    let mut real = start;
    for component in path.components() {
        match component {
            Component::ParentDir => {
                real.pop();
            }
            Component::CurDir => {}
            other => {
                real.push(other);
                real = real.canonicalize().unwrap_or(real);
            }
        }
    }
    real
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_through_a_folder_that_does_not_exist_leads_to_the_same_file() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.osim");
        std::fs::write(&file, "").unwrap();
        assert_eq!(resolved(&folder.path().join("new/../a.osim")), resolved(&file));
        assert_eq!(resolved(&folder.path().join("./new")), resolved(folder.path()).join("new"));
    }
}
