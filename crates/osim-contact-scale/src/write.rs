//! Writing without ever leaving a file half written or losing one.
//!
//! A successor is complete under a temporary name in the target's folder before it takes the target's name.

use std::fs::{File, Metadata};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use tempfile::NamedTempFile;

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
        // A symlink stays one: its target is what is replaced.
        let target = target.canonicalize().unwrap_or_else(|_| target.to_owned());
        let existing = std::fs::metadata(&target).ok();
        if existing.as_ref().is_some_and(Metadata::is_dir) {
            bail!("cannot write {}: a folder has that name", target.display());
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
        Ok(Self { temporary, target, replaces: existing.is_some() })
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
        let target = self.target;
        let result = if self.replaces {
            self.temporary.persist(&target)
        } else {
            self.temporary.persist_noclobber(&target)
        };
        match result {
            Ok(_) => Ok(()),
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

/// Keeps the old `bytes` of `path` as `NAME.bak`; an older backup is never replaced, the next is `NAME.bak2`.
///
/// # Errors
/// The folder cannot be written.
pub(crate) fn back_up(path: &Path, bytes: &[u8]) -> Result<PathBuf> {
    let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let metadata = std::fs::metadata(&path).ok();
    for count in 1_u32.. {
        let mut name = path.file_name().unwrap_or_default().to_owned();
        name.push(if count == 1 { ".bak".to_owned() } else { format!(".bak{count}") });
        let backup = path.with_file_name(name);
        if backup.symlink_metadata().is_ok() {
            continue;
        }
        let prepared = Prepared::new(&backup, bytes, metadata.as_ref(), Mode::New)?;
        prepared.sync()?;
        prepared.commit()?;
        return Ok(backup);
    }
    bail!("cannot keep a backup of {}", path.display())
}

/// After a rename, the folder's entry itself has to reach the disk.
pub(crate) fn sync_folder_of(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // Windows cannot open folders; the rename is durable there by itself. A failure loses nothing but speed of certainty.
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}

/// `true` where both paths are one file, through links and spellings.
pub(crate) fn is_same_file(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => a == b,
    }
}
