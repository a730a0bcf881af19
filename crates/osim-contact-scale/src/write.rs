//! Writing without ever leaving a file half written or losing one.
//!
//! A successor is complete under a temporary name in the target's folder before it takes the target's name.

use std::fs::{File, Metadata};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use tempfile::NamedTempFile;

use crate::paths::resolved;

/// A complete successor that does not have its name yet.
pub(crate) struct Prepared {
    temporary: NamedTempFile,
    target: PathBuf,
    replaces: bool,
}

/// How a file may be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mode {
    /// Refuse to replace anything.
    New,
    /// Replace what is there.
    Replace,
}

impl Prepared {
    /// Writes `bytes` under a temporary name beside `target`. Mode bits are those of the file that is replaced, else
    /// those of `like`.
    ///
    /// # Errors
    /// The target exists and may not be replaced, or the folder cannot be written.
    pub(crate) fn new(target: &Path, bytes: &[u8], like: Option<&Metadata>, mode: Mode) -> Result<Self> {
        if target.is_symlink() && !target.exists() {
            bail!("{} is a link that leads nowhere: remove it, or write to another name", target.display());
        }
        // A symlink stays one: what it leads to is replaced.
        let target = resolved(target);
        let existing = std::fs::metadata(&target).ok();
        if existing.as_ref().is_some_and(Metadata::is_dir) {
            bail!("cannot write {}: a folder has that name", target.display());
        }
        if existing.as_ref().is_some_and(|metadata| !metadata.is_file()) {
            bail!("{} is no ordinary file: write to another name", target.display());
        }
        if existing.is_some() && mode == Mode::New {
            bail!(
                "{} exists already: choose another name with -o, or replace it with --force",
                target.display()
            );
        }
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
            _ => PathBuf::from("."),
        };
        let cannot = || format!("cannot write into {}", folder.display());
        let mut temporary = builder(existing.as_ref().or(like))
            .tempfile_in(&folder)
            .map_err(|error| without_name(&error))
            .with_context(cannot)?;
        temporary.write_all(bytes).with_context(cannot)?;
        keep_permissions(&temporary, existing.as_ref().or(like)).with_context(cannot)?;
        Ok(Self { temporary, target, replaces: existing.is_some() })
    }

    /// Whether a file is there whose contents are about to go.
    pub(crate) fn replaces(&self) -> bool {
        self.replaces
    }

    /// Makes sure the bytes are on the disk, not only on their way there.
    pub(crate) fn sync(&self) -> Result<()> {
        self.temporary.as_file().sync_all().with_context(|| format!("cannot write {}", self.target.display()))
    }

    /// Gives the successor its name, in one step.
    ///
    /// # Errors
    /// Somebody else made a file of that name in the meantime, or the folder cannot be changed.
    pub(crate) fn commit(self) -> Result<()> {
        let durable = self.replaces;
        let target = self.target;
        let result = if self.replaces {
            self.temporary.persist(&target)
        } else {
            self.temporary.persist_noclobber(&target)
        };
        match result {
            Ok(_) => {
                if durable {
                    sync_folder_of(&target);
                }
                Ok(())
            }
            Err(error) if error.error.kind() == ErrorKind::AlreadyExists => {
                bail!("{} appeared while it was being written: nothing was replaced", target.display())
            }
            Err(error) => Err(anyhow!(error.error).context(format!("cannot write {}", target.display()))),
        }
    }
}

/// The reason alone: the temporary name that tempfile puts into its message says nothing to a user.
fn without_name(error: &std::io::Error) -> std::io::Error {
    let kind = error.kind();
    let inner = error.get_ref().and_then(std::error::Error::source).map(ToString::to_string);
    std::io::Error::new(kind, inner.unwrap_or_else(|| kind.to_string()))
}

#[cfg(unix)]
fn builder(like: Option<&Metadata>) -> tempfile::Builder<'static, 'static> {
    use std::os::unix::fs::PermissionsExt;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".osim-contact-scale-");
    // Without a file to be like, what any new file gets; the process's mask still applies.
    let mode = like.map_or(0o666, |metadata| metadata.permissions().mode() & 0o777);
    builder.permissions(std::fs::Permissions::from_mode(mode));
    builder
}

#[cfg(not(unix))]
fn builder(_like: Option<&Metadata>) -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".osim-contact-scale-");
    builder
}

/// The mode bits of the file that is replaced or copied, exactly: a process's mask takes nothing from them.
#[cfg(unix)]
fn keep_permissions(file: &NamedTempFile, like: Option<&Metadata>) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    match like {
        Some(like) => {
            let mode = std::fs::Permissions::from_mode(like.permissions().mode() & 0o777);
            file.as_file().set_permissions(mode)
        }
        None => Ok(()),
    }
}

#[cfg(not(unix))]
fn keep_permissions(_file: &NamedTempFile, _like: Option<&Metadata>) -> std::io::Result<()> {
    Ok(())
}

/// A backup of `path` as it is: `NAME.bak`; an older backup is never replaced, the next is `NAME.bak2`.
///
/// # Errors
/// The folder cannot be written.
pub(crate) fn backup(path: &Path, bytes: &[u8]) -> Result<(Prepared, PathBuf)> {
    let path = resolved(path);
    let metadata = std::fs::metadata(&path).ok();
    for count in 1_u32.. {
        let mut name = path.file_name().unwrap_or_default().to_owned();
        name.push(if count == 1 { ".bak".to_owned() } else { format!(".bak{count}") });
        let backup = path.with_file_name(name);
        if backup.symlink_metadata().is_err() {
            return Ok((Prepared::new(&backup, bytes, metadata.as_ref(), Mode::New)?, backup));
        }
    }
    bail!("cannot keep a backup of {}", path.display())
}

/// After a rename, the folder's entry itself has to reach the disk.
fn sync_folder_of(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // Windows cannot open folders; the rename is durable there by itself. A failure loses nothing but speed of certainty.
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}
