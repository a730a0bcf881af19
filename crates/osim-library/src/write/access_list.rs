//! Keeps the access lists (POSIX ACLs) of files that are replaced. A folder may give every new file an access list; the new version
//! of a file without an access list should not get one.

use std::path::Path;

use rustix::buffer::spare_capacity;
use rustix::fs::{XattrFlags, fremovexattr, fsetxattr, getxattr};
use rustix::io::Errno;
use tempfile::NamedTempFile;

/// The extended attribute in which Linux stores the access list of a file.
const ACCESS_LIST_ATTRIBUTE: &str = "system.posix_acl_access";
/// Most bytes of an access list: Linux takes at most 64 KiB as one attribute.
const MOST_ACCESS_LIST_BYTES: usize = 1 << 16;

/// Gives the new `file` the access list of `existing`. If `existing` has none, removes the list that `file` got from its folder.
/// Does nothing on a file system without access lists.
pub(super) fn keep_access_list(file: &NamedTempFile, existing: &Path) {
    let mut list: Vec<u8> = Vec::with_capacity(MOST_ACCESS_LIST_BYTES);
    // A file that could not be read would not be replaced.
    let kept = match getxattr(existing, ACCESS_LIST_ATTRIBUTE, spare_capacity(&mut list)) {
        Ok(_) => fsetxattr(file, ACCESS_LIST_ATTRIBUTE, &list, XattrFlags::empty()),
        Err(Errno::NODATA) => fremovexattr(file, ACCESS_LIST_ATTRIBUTE),
        Err(_) => Ok(()),
    };
    // If the access list cannot be copied, the new file still has the mode bits of the old one.
    let _ = kept;
}

#[cfg(test)]
mod tests {
    use rustix::fs::setxattr;

    use super::*;
    use crate::write::{PendingFile, WriteMode};

    /// An access list as Linux stores it: version 2, then tag, rights and id of each entry. Owner, user 12345, group, mask, others.
    fn access_list_bytes(rights_of_user: u16) -> Vec<u8> {
        let nobody = u32::MAX;
        let entries = [
            (0x01, 6, nobody),
            (0x02, rights_of_user, 12345),
            (0x04, 4, nobody),
            (0x10, 6, nobody),
            (0x20, 4, nobody),
        ];
        let entry = |(tag, rights, id): (u16, u16, u32)| {
            [tag.to_le_bytes().as_slice(), &rights.to_le_bytes(), &id.to_le_bytes()].concat()
        };
        [2_u32.to_le_bytes().to_vec(), entries.into_iter().flat_map(entry).collect()].concat()
    }

    fn read(path: &Path) -> Option<Vec<u8>> {
        let mut seen = vec![0; MOST_ACCESS_LIST_BYTES];
        let length = getxattr(path, ACCESS_LIST_ATTRIBUTE, &mut seen).ok()?;
        seen.truncate(length);
        Some(seen)
    }

    #[test]
    fn the_list_of_a_folder_is_not_given_to_a_file_that_has_none() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.osim");
        let replace = || PendingFile::new(&path, b"new", None, WriteMode::InPlace).unwrap().commit().unwrap();
        std::fs::write(&path, "old").unwrap();
        if setxattr(folder.path(), "system.posix_acl_default", &access_list_bytes(6), XattrFlags::empty())
            .is_err()
        {
            println!(
                "skipped: the_list_of_a_folder_is_not_given_to_a_file_that_has_none: no access lists here"
            );
            return;
        }
        replace();
        assert_eq!(read(&path), None);
        // One of its own stays.
        setxattr(&path, ACCESS_LIST_ATTRIBUTE, &access_list_bytes(4), XattrFlags::empty()).unwrap();
        replace();
        assert_eq!(read(&path), Some(access_list_bytes(4)));
    }
}
