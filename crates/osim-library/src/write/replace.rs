//! Replaces a file safely: the new file is completed under a temporary name in the target's folder, then gets the target's name.

use std::fs::{File, Metadata};
use std::io::{ErrorKind, IoSlice, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use osim_model::messages::{Input, phrase};
use tempfile::NamedTempFile;

use super::temporary;
use crate::fault::{Context, LibraryFault, Result};
use crate::{file_access, folder_of, resolved};

/// A new file under its temporary name.
pub struct PendingFile {
    temporary: NamedTempFile,
    /// The target as the user named it.
    shown: PathBuf,
    /// The target itself, if `shown` is a link.
    target: PathBuf,
    replaces: bool,
    mode: WriteMode,
}

/// Whether a new file may replace an existing one, and whose owner and group it gets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WriteMode {
    /// Only a new file is written: nothing is replaced.
    New,
    /// Only a new file is written; but a file with the same bytes that another run has written since this time is as good.
    NewSince(SystemTime),
    /// Replace an existing file, and keep its owner and group if the system allows it.
    Replace,
    /// Replace an existing file that is changed in place, and keep its owner and group; refuse if that is not possible.
    InPlace,
}

impl WriteMode {
    /// Whether the existing file may be what another run of the same call has just written. Then its bytes decide.
    pub(crate) fn is_of_other_run(self, existing: &Metadata) -> bool {
        matches!(self, Self::NewSince(start) if existing.modified().is_ok_and(|written| written >= start))
    }
}

/// Adds bytes to the file that [`commit`](PendingFile::commit) completes.
impl Write for PendingFile {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.temporary.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.temporary.flush()
    }
}

impl PendingFile {
    /// Writes `bytes` under a temporary name beside `target`. The new file has the permissions of the replaced file, or of `like` if
    /// no file is replaced.
    ///
    /// # Errors
    /// The target exists and may not be replaced, or the folder cannot be written.
    pub fn new(target: &Path, bytes: &[u8], like: Option<&Metadata>, mode: WriteMode) -> Result<Self> {
        Self::with_parts(target, std::iter::once(bytes), like, mode)
    }

    /// Writes a new file as [`new`](Self::new) does, with the bytes in several parts.
    pub(crate) fn with_parts<'p>(
        target: &Path,
        parts: impl Iterator<Item = &'p [u8]>,
        like: Option<&Metadata>,
        mode: WriteMode,
    ) -> Result<Self> {
        let mut prepared = Self::begin(target, like, mode)?;
        let mut slices: Vec<IoSlice<'_>> = parts.filter(|part| !part.is_empty()).map(IoSlice::new).collect();
        write_all(prepared.temporary.as_file_mut(), &mut slices).context(|| prepared.cannot_write())?;
        Ok(prepared)
    }

    /// Begins an empty new file that will get the name `target`; `add_bytes` fills it.
    pub fn begin(target: &Path, like: Option<&Metadata>, mode: WriteMode) -> Result<Self> {
        let (target, shown) = (real_target(target)?, target.to_owned());
        let existing = std::fs::metadata(&target).ok();
        if existing.as_ref().is_some_and(Metadata::is_dir) {
            let message = format!("cannot write {}: a folder has that name", shown.display());
            return Err(LibraryFault::new(message));
        }
        if existing.as_ref().is_some_and(|metadata| !metadata.is_file()) {
            let message = format!("{} is not an ordinary file: write to another name", shown.display());
            return Err(LibraryFault::new(message));
        }
        let existing = existing.filter(|existing| !mode.is_of_other_run(existing));
        if existing.is_some() && matches!(mode, WriteMode::New | WriteMode::NewSince(_)) {
            let name = shown.display().to_string();
            return Err(LibraryFault::new(match mode {
                WriteMode::NewSince(_) => phrase![
                    "{} exists already: choose another name ({}) or folder ({}), or replace it with {}";
                    name, Input::Output, Input::OutputDir, Input::Force
                ],
                // Figures, motions and tables have options of their own.
                _ => {
                    phrase!["{} exists already: choose another name, or replace it with {}"; name, Input::Force]
                }
            }));
        }
        let cannot = || format!("cannot write into {}", folder_of(&shown).display());
        let like = existing.as_ref().or(like);
        let temporary = temporary::new_file(folder_of(&target), like)
            .map_err(|error| file_access::reason(&error))
            .context(cannot)?;
        if let Some(existing) = &existing
            && !keep_owner(&temporary, existing).context(cannot)?
            && mode == WriteMode::InPlace
        {
            return Err(LibraryFault::new(phrase![
                "{} belongs to another user or group, and the changed file would belong to you: let its owner change \
                it, or write to another name with {}";
                shown.display().to_string(), Input::Output
            ]));
        }
        #[cfg(target_os = "linux")]
        if existing.is_some() {
            super::access_list::keep_access_list(&temporary, &target);
        }
        keep_permissions(&temporary, like, existing.is_some()).context(cannot)?;
        Ok(Self { temporary, shown, target, replaces: existing.is_some(), mode })
    }

    /// Adds bytes to the new file.
    ///
    /// # Errors
    /// The disk is full, or the folder was removed.
    pub(crate) fn add_bytes(&mut self, bytes: &[u8]) -> Result<()> {
        let written = self.temporary.write_all(bytes);
        written.context(|| self.cannot_write())
    }

    /// The file under its temporary name, its target, and the target as the user knows it.
    pub(super) fn into_parts(self) -> (NamedTempFile, PathBuf, PathBuf) {
        (self.temporary, self.target, self.shown)
    }

    fn cannot_write(&self) -> String {
        format!("cannot write {}", self.shown.display())
    }

    /// Whether the new file replaces an existing one.
    pub fn replaces(&self) -> bool {
        self.replaces
    }

    /// Waits until the bytes are on the disk.
    pub fn sync(&self) -> Result<()> {
        self.temporary.as_file().sync_all().context(|| self.cannot_write())
    }

    /// Gives the new file the name of its target, in one step. If another run wrote the same bytes in the meantime, nothing has to be done.
    ///
    /// # Errors
    /// Another program made a file of this name in the meantime, which may not be replaced, or the folder cannot be changed.
    pub fn commit(self) -> Result<()> {
        // The system dates files by a clock that is some ms late: the file would seem older than a run that began just before.
        let _ = self.temporary.as_file().set_modified(SystemTime::now());
        let (target, shown) = (self.target, self.shown.display());
        let result = if self.replaces {
            self.temporary.persist(&target)
        } else {
            self.temporary.persist_noclobber(&target)
        };
        let Err(refused) = result else {
            if self.replaces {
                sync_folder_of(&target);
            }
            return Ok(());
        };
        let (error, file) = (refused.error, refused.file);
        if error.kind() != ErrorKind::AlreadyExists {
            return Err(LibraryFault::system(format!("cannot write {shown}"), error));
        }
        if self.mode == WriteMode::Replace {
            file.as_file().sync_all().context(|| format!("cannot write {shown}"))?;
            return file.persist(&target).map(drop).context(|| format!("cannot write {shown}"));
        }
        let bytes = file_access::read_ordinary;
        if bytes(file.path()).is_ok_and(|made| bytes(&target).is_ok_and(|there| made == there)) {
            return Ok(());
        }
        Err(LibraryFault::new(format!("{shown} appeared while it was being written: nothing was replaced")))
    }
}

/// The file that is replaced: if `target` is a symlink, the file that it leads to.
fn real_target(target: &Path) -> Result<PathBuf> {
    if !target.is_symlink() {
        return Ok(target.to_owned());
    }
    if !target.exists() {
        let message =
            format!("{} is a link that leads nowhere: remove it, or write to another name", target.display());
        return Err(LibraryFault::new(message));
    }
    Ok(resolved(target))
}

/// Writes many slices with few calls, also if the system takes only a part of the bytes at once.
fn write_all(file: &mut File, slices: &mut [IoSlice<'_>]) -> std::io::Result<()> {
    let mut left = slices;
    while !left.is_empty() {
        match file.write_vectored(left) {
            Ok(0) => return Err(ErrorKind::WriteZero.into()),
            Ok(written) => IoSlice::advance_slices(&mut left, written),
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

/// Gives a new file the owner and group of the replaced file. Returns whether the system allowed it.
#[cfg(unix)]
fn keep_owner(file: &NamedTempFile, like: &Metadata) -> std::io::Result<bool> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let own = file.as_file().metadata()?;
    if (own.uid(), own.gid()) == (like.uid(), like.gid()) {
        return Ok(true);
    }
    if fchown(file, Some(like.uid()), Some(like.gid())).is_ok() {
        return Ok(true);
    }
    // At least the group is kept, if the user belongs to it.
    drop(fchown(file, None, Some(like.gid())));
    Ok(false)
}

#[cfg(not(unix))]
fn keep_owner(_file: &NamedTempFile, _like: &Metadata) -> std::io::Result<bool> {
    Ok(true)
}

/// Gives a new file the permissions of the replaced or copied file, regardless of the process's mask. Set-user-ID and set-group-ID of
/// a replaced file are kept if the user or group is still the same.
#[cfg(unix)]
fn keep_permissions(file: &NamedTempFile, like: Option<&Metadata>, replaces: bool) -> std::io::Result<()> {
    use std::os::unix::fs::{MetadataExt, PermissionsExt};
    const SET_USER_ID: u32 = 0o4000;
    const SET_GROUP_ID: u32 = 0o2000;
    match like {
        Some(like) => {
            let own = file.as_file().metadata()?;
            let mut kept = if replaces { 0o1777 } else { 0o777 };
            kept |= if replaces && own.uid() == like.uid() { SET_USER_ID } else { 0 };
            kept |= if replaces && own.gid() == like.gid() { SET_GROUP_ID } else { 0 };
            file.as_file().set_permissions(std::fs::Permissions::from_mode(like.permissions().mode() & kept))
        }
        None => Ok(()),
    }
}

#[cfg(not(unix))]
fn keep_permissions(_file: &NamedTempFile, _like: Option<&Metadata>, _replaces: bool) -> std::io::Result<()> {
    Ok(())
}

/// Prepares a backup of `path`: `NAME.bak`, or `NAME.bak2` and so on if there are older backups. If a stopped run left a backup with
/// the same bytes, this backup is used.
pub(crate) fn prepare_backup(path: &Path, bytes: &[u8]) -> Result<(Option<PendingFile>, PathBuf)> {
    let path = resolved(path);
    let metadata = std::fs::metadata(&path).ok();
    for backup in backup_names(&path) {
        let Ok(there) = backup.symlink_metadata() else {
            return Ok((Some(PendingFile::new(&backup, bytes, metadata.as_ref(), WriteMode::New)?), backup));
        };
        let same_length = there.is_file() && there.len() == bytes.len() as u64;
        if same_length && file_access::read_ordinary(&backup).is_ok_and(|kept| kept == bytes) {
            return Ok((None, backup));
        }
    }
    Err(LibraryFault::new(format!("cannot keep a backup of {}", path.display())))
}

/// Names for backups: `NAME.bak`, `NAME.bak2`, ...
pub(super) fn backup_names(path: &Path) -> impl Iterator<Item = PathBuf> {
    (1_u32..).map(|count| {
        let mut name = path.file_name().unwrap_or_default().to_owned();
        name.push(if count == 1 { ".bak".to_owned() } else { format!(".bak{count}") });
        path.with_file_name(name)
    })
}

/// Makes the new name of a renamed file safe on the disk.
pub(super) fn sync_folder_of(path: &Path) {
    // Windows cannot open folders, and needs no synchronisation after a rename. A failure is harmless.
    if let Ok(folder) = file_access::open_folder(folder_of(path)) {
        let _ = folder.sync_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_of_another_run_if_it_was_written_since_the_start() {
        let dir = tempfile::tempdir().unwrap();
        for number in 0..100 {
            let path = dir.path().join(number.to_string());
            let start = SystemTime::now();
            PendingFile::new(&path, b"new", None, WriteMode::NewSince(start)).unwrap().commit().unwrap();
            let (later, written) = (SystemTime::now(), path.metadata().unwrap());
            assert!(WriteMode::NewSince(start).is_of_other_run(&written), "file {number}");
            assert!(!WriteMode::NewSince(later).is_of_other_run(&written), "file {number}");
        }
    }
}
