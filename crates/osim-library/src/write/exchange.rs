//! Two files that exchange their names in one step, so that at no moment a name is without a file, and what was replaced is
//! still there to be looked at.
//!
//! A successor and a model exchange under the name `NAME.replaced-HOST-PROCESS-XXXXXX-DIGEST`, beside the model.
//! From the exchange on it is the name of what the model was, and that may be another program's work. So it is not a temporary
//! name: whenever the process is killed, the file stays, and no run removes it before it has read it. `DIGEST` is that of the
//! successor. What has it was made here; what is in a backup too is not needed; anything else becomes a further backup.

use std::ffi::{OsStr, OsString};
use std::fs::Metadata;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use crate::digest::sha256_of_parts;
use crate::file_access;
use crate::write::replace::backup_names;
use crate::write::temporary;

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
pub(super) const EXCHANGE_IS_KNOWN: bool = cfg!(any(target_os = "linux", target_vendor = "apple"));

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

const INFIX: &str = ".replaced-";

/// Most file systems do not allow longer names.
const LONGEST: usize = 255;

/// Gives a complete successor of `target` its name for the exchange. From here on nothing removes it by itself.
pub(super) fn renamed(
    successor: NamedTempFile,
    target: &Path,
    after: &[&[u8]],
) -> std::io::Result<NamedTempFile> {
    let whose = temporary::whose(successor.path().file_name().unwrap_or_default()).unwrap_or_default();
    let end = format!("{INFIX}{whose}-{}", digest(after));
    let mut name = beginning(target.file_name().unwrap_or_default(), LONGEST.saturating_sub(end.len()));
    name.push(end);
    let name = target.with_file_name(name);
    if name.symlink_metadata().is_ok() {
        return Err(ErrorKind::AlreadyExists.into());
    }
    let (file, path) = successor.into_parts();
    path.persist(&name).map_err(|error| error.error)?;
    let mut path = TempPath::try_from_path(name)?;
    path.disable_cleanup(true);
    Ok(NamedTempFile::from_parts(file, path))
}

/// A name, or as much of it as there is room for.
fn beginning(name: &OsStr, most: usize) -> OsString {
    if name.len() <= most {
        return name.to_owned();
    }
    let (mut short, name) = (String::new(), name.to_string_lossy());
    for letter in name.chars().take_while(|letter| *letter != char::REPLACEMENT_CHARACTER) {
        if short.len() + letter.len_utf8() > most {
            break;
        }
        short.push(letter);
    }
    short.into()
}

/// The first 16 of the digits.
fn digest(parts: &[&[u8]]) -> String {
    sha256_of_parts(parts.iter().copied()).chars().take(16).collect()
}

/// The name of the model, whose file it is, and the digest of the successor.
fn parts(name: &OsStr) -> Option<(&str, &str, &str)> {
    let (model, rest) = name.to_str()?.rsplit_once(INFIX)?;
    let (whose, digest) = rest.rsplit_once('-')?;
    Some((model, whose, digest))
}

/// Whether `name` is that of a file left by a process of this computer that is gone.
pub(crate) fn is_left_over(folder: &Path, name: &OsStr) -> bool {
    parts(name).is_some_and(|(_, whose, _)| temporary::is_gone(whose, &folder.join(name)))
}

/// What a killed process left under such a name goes where a backup has the same, or where it was made here. Else it becomes a
/// further backup of its model: which.
pub(crate) fn settle(left: &Path) -> Option<PathBuf> {
    let (model, _, of_successor) = parts(left.file_name()?)?;
    let bytes = file_access::read_ordinary(left).ok()?;
    let model = left.with_file_name(model);
    if digest(&[&bytes]) == of_successor {
        // A user who may not remove it may not write here either, and gets that error.
        drop(std::fs::remove_file(left));
        return None;
    }
    let mut backups = backup_names(&model).take_while(|backup| backup.symlink_metadata().is_ok());
    if let Some(same) = backups.find(|backup| is(backup, &[&bytes])) {
        become_backup(left, &same);
        return None;
    }
    let mut left = TempPath::try_from_path(left).ok()?;
    left.disable_cleanup(true);
    kept(left, &model)
}

/// A file becomes the backup that has the same bytes: what a program that has it open still writes into it is there, too. A file with
/// other names goes: who changes it under these would change the backup.
pub(super) fn become_backup(file: &Path, backup: &Path) {
    let linked = std::fs::metadata(file).is_ok_and(|metadata| names_of(&metadata) > 1);
    if linked || std::fs::rename(file, backup).is_err() {
        drop(std::fs::remove_file(file));
    }
}

/// Gives a file that is somebody's work the name of a further backup of `target`; `None` if that is not possible.
pub(super) fn kept(mut file: TempPath, target: &Path) -> Option<PathBuf> {
    for name in backup_names(target) {
        match file.persist_noclobber(&name) {
            Ok(()) => return Some(name),
            Err(error) if error.error.kind() == ErrorKind::AlreadyExists => file = error.path,
            Err(mut error) => {
                error.path.disable_cleanup(true);
                return None;
            }
        }
    }
    None
}

/// Whether the file has these bytes, which may be in several places.
pub(super) fn is(path: &Path, parts: &[&[u8]]) -> bool {
    let Ok(bytes) = file_access::read_ordinary(path) else { return false };
    let mut rest = bytes.as_slice();
    parts.iter().all(|part| {
        let begins = rest.strip_prefix(*part);
        rest = begins.unwrap_or_default();
        begins.is_some()
    }) && rest.is_empty()
}

/// How many names a file has.
#[cfg(unix)]
pub(super) fn names_of(metadata: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::nlink(metadata)
}

/// Not known without opening it.
#[cfg(not(unix))]
pub(super) fn names_of(_metadata: &Metadata) -> u64 {
    1
}
