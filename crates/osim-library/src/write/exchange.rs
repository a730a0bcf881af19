//! Exchanges the names of two files in one step, so that a name is never without a file, and the replaced file can still be read.
//!
//! The new version of a model is written under the name `NAME.replaced-HOST-PROCESS-XXXXXX-DIGEST`, beside the model. Then both files
//! exchange their names, and the file of this name is the old model, which may be another program's work. So it is not a temporary
//! file: if the process is killed, the file stays until a later run reads it. `DIGEST` is the digest of the new version: a file with
//! this digest was made by this program and is removed. A file that is equal to a backup is removed, too; any other file becomes a
//! further backup.

use std::ffi::{OsStr, OsString};
use std::fs::Metadata;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use crate::file_access::{self, sha256_of_parts};
use crate::write::replace::backup_names;
use crate::write::temporary;

/// The result of exchanging two files.
#[cfg_attr(
    not(any(target_os = "linux", target_vendor = "apple")),
    expect(dead_code, reason = "other systems cannot do it, and say only that")
)]
pub(super) enum ExchangeOutcome {
    Done,
    /// The operating system, or the file system, cannot exchange files.
    NotPossible,
    Failed(std::io::Error),
}

/// Whether this system can exchange files on some of its file systems.
pub(super) const EXCHANGE_IS_KNOWN: bool = cfg!(any(target_os = "linux", target_vendor = "apple"));

/// Exchanges two files of one folder: `renameat2` with `RENAME_EXCHANGE` on Linux, `renameatx_np` with `RENAME_SWAP` on macOS.
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
pub(super) fn exchange(one: &Path, other: &Path) -> ExchangeOutcome {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    const ERRORS_WITHOUT_EXCHANGE: [Errno; 4] = [Errno::INVAL, Errno::NOSYS, Errno::NOTSUP, Errno::OPNOTSUPP];
    match renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE) {
        Ok(()) => ExchangeOutcome::Done,
        Err(errno) if ERRORS_WITHOUT_EXCHANGE.contains(&errno) => ExchangeOutcome::NotPossible,
        Err(errno) => ExchangeOutcome::Failed(errno.into()),
    }
}

/// Windows cannot exchange files: `ReplaceFileW` renames twice, and between the two renames no file has the name.
#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
pub(super) fn exchange(_one: &Path, _other: &Path) -> ExchangeOutcome {
    ExchangeOutcome::NotPossible
}

/// The text in the name of a file that an exchange displaced, before host, process and digest.
const INFIX_OF_REPLACED: &str = ".replaced-";

/// The longest name that most file systems allow, in bytes.
const LONGEST_FILE_NAME_BYTES: usize = 255;

/// Renames the complete new version of `target` for the exchange. Afterwards this file is not removed automatically.
pub(super) fn rename_for_exchange(
    replacement: NamedTempFile,
    target: &Path,
    after: &[&[u8]],
) -> std::io::Result<NamedTempFile> {
    let owner =
        temporary::host_and_process(replacement.path().file_name().unwrap_or_default()).unwrap_or_default();
    let end = format!("{INFIX_OF_REPLACED}{owner}-{}", short_digest(after));
    let mut name =
        shortened(target.file_name().unwrap_or_default(), LONGEST_FILE_NAME_BYTES.saturating_sub(end.len()));
    name.push(end);
    let name = target.with_file_name(name);
    if name.symlink_metadata().is_ok() {
        return Err(ErrorKind::AlreadyExists.into());
    }
    let (file, path) = replacement.into_parts();
    path.persist(&name).map_err(|error| error.error)?;
    let mut path = TempPath::try_from_path(name)?;
    path.disable_cleanup(true);
    Ok(NamedTempFile::from_parts(file, path))
}

/// The first `most` bytes of a name.
fn shortened(name: &OsStr, most: usize) -> OsString {
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

/// The first 16 digits of the SHA-256 of the parts.
fn short_digest(parts: &[&[u8]]) -> String {
    sha256_of_parts(parts.iter().copied()).chars().take(16).collect()
}

/// Splits a name with `.replaced-` into the name of the model, the host and process, and the digest of the new version.
fn parts_of_name(name: &OsStr) -> Option<(&str, &str, &str)> {
    let (model, rest) = name.to_str()?.rsplit_once(INFIX_OF_REPLACED)?;
    let (owner, digest) = rest.rsplit_once('-')?;
    Some((model, owner, digest))
}

/// Whether a process of this computer that no longer runs left the file `name` after an exchange.
pub(crate) fn is_left_over(folder: &Path, name: &OsStr) -> bool {
    parts_of_name(name).is_some_and(|(_, owner, _)| temporary::has_dead_owner(owner, &folder.join(name)))
}

/// Removes a file that a killed process left after an exchange, or keeps it as a further backup and returns the path of this backup.
pub(crate) fn settle_leftover(leftover: &Path) -> Option<PathBuf> {
    let (model, _, replacement_digest) = parts_of_name(leftover.file_name()?)?;
    let bytes = file_access::read_ordinary(leftover).ok()?;
    let model = leftover.with_file_name(model);
    if short_digest(&[&bytes]) == replacement_digest {
        // If the file may not be removed, the folder may not be written, and the user gets that error later.
        drop(std::fs::remove_file(leftover));
        return None;
    }
    let mut backups = backup_names(&model).take_while(|backup| backup.symlink_metadata().is_ok());
    if let Some(same) = backups.find(|backup| has_bytes(backup, &[&bytes])) {
        become_backup(leftover, &same);
        return None;
    }
    let mut leftover = TempPath::try_from_path(leftover).ok()?;
    leftover.disable_cleanup(true);
    keep_as_backup(leftover, &model)
}

/// Moves a file over the backup that has the same bytes, so that the backup keeps bytes which another program still writes into the
/// file. A file with hard links is removed instead, because a change under its other names would change the backup.
pub(super) fn become_backup(file: &Path, backup: &Path) {
    let linked = std::fs::metadata(file).is_ok_and(|metadata| link_count(&metadata) > 1);
    if linked || std::fs::rename(file, backup).is_err() {
        drop(std::fs::remove_file(file));
    }
}

/// Renames a file of another program to a further backup of `target`; `None` if the renaming fails.
pub(super) fn keep_as_backup(mut file: TempPath, target: &Path) -> Option<PathBuf> {
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

/// Whether the file has exactly the bytes of `parts`, one after the other.
pub(crate) fn has_bytes(path: &Path, parts: &[&[u8]]) -> bool {
    let Ok(bytes) = file_access::read_ordinary(path) else { return false };
    let mut rest = bytes.as_slice();
    parts.iter().all(|part| {
        let begins = rest.strip_prefix(*part);
        rest = begins.unwrap_or_default();
        begins.is_some()
    }) && rest.is_empty()
}

/// The number of names (hard links) of a file.
#[cfg(unix)]
pub(super) fn link_count(metadata: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::nlink(metadata)
}

/// The number of names of a file: taken for 1, because it is not known without opening the file.
#[cfg(not(unix))]
pub(super) fn link_count(_metadata: &Metadata) -> u64 {
    1
}
