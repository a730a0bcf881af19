//! Two files that exchange their names in one step, so that at no moment a name is without a file, and what was replaced is
//! still there to be looked at.

use std::path::Path;

/// The outcome of an exchange.
#[derive(Debug)]
#[cfg_attr(
    not(any(target_os = "linux", target_vendor = "apple")),
    expect(dead_code, reason = "other systems cannot do it, and say only that")
)]
pub(super) enum Exchange {
    Done,
    /// This system, or this file system, cannot do it.
    NotPossible,
    Failed(std::io::Error),
}

/// Whether this system can do it on some of its file systems.
pub(super) const IS_KNOWN: bool = cfg!(any(target_os = "linux", target_vendor = "apple"));

/// Exchanges two files of one folder: `renameat2` with `RENAME_EXCHANGE` on Linux, `renameatx_np` with `RENAME_SWAP` on macOS.
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
pub(super) fn exchange(one: &Path, other: &Path) -> Exchange {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    const NOT_POSSIBLE: [Errno; 4] = [Errno::INVAL, Errno::NOSYS, Errno::NOTSUP, Errno::OPNOTSUPP];
    match renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE) {
        Ok(()) => Exchange::Done,
        Err(errno) if NOT_POSSIBLE.contains(&errno) => Exchange::NotPossible,
        Err(errno) => Exchange::Failed(errno.into()),
    }
}

/// `ReplaceFileW` does not exchange: it renames twice, and between the two there is no file under the name.
#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
pub(super) fn exchange(_one: &Path, _other: &Path) -> Exchange {
    Exchange::NotPossible
}
