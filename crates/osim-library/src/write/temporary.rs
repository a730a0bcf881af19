//! Temporary names of files that are being written. They show whether a killed process left a file.
//!
//! `.osim-contact-scale-HOST-PROCESS-XXXXXX.tmp`: a later run on the same computer knows which process wrote the file. If this
//! process no longer runs, nobody will finish the file, and it is removed. No other program's work ever has a temporary name: files
//! that are exchanged get names of [`replaced`](super::replaced) before.
//!
//! On Windows nobody else can open a file for writing from the moment it is made until it has its final name. So a file that can be
//! opened has no writer any more.

use std::ffi::OsStr;
use std::fs::{File, Metadata, OpenOptions};
use std::path::Path;
use std::sync::OnceLock;

use tempfile::NamedTempFile;

use crate::file_access;

/// The beginning of the name of a temporary file; host and process follow.
const TEMPORARY_PREFIX: &str = ".osim-contact-scale-";
/// The end of the name of a temporary file.
const TEMPORARY_SUFFIX: &str = ".tmp";

/// A new file in `folder` that only this process writes, with the mode bits of `like`.
///
/// The file is locked while it is open, so that other processes see that it is in use, even if they run in another container with the
/// same host name and cannot see this process.
pub(crate) fn new_file(folder: &Path, like: Option<&Metadata>) -> std::io::Result<NamedTempFile> {
    let prefix = format!("{TEMPORARY_PREFIX}{}-{}-", host_in_names(), std::process::id());
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix).suffix(TEMPORARY_SUFFIX);
    let temporary = create_in(&mut builder, folder, like)?;
    // Some network file systems have no locks: there, only the process in the name shows whether the file is in use.
    drop(temporary.as_file().try_lock());
    Ok(temporary)
}

/// Whether a process of this computer that no longer runs left the temporary file `name`.
pub(crate) fn is_left_over(folder: &Path, name: &OsStr) -> bool {
    host_and_process(name).is_some_and(|owner| has_dead_owner(owner, &folder.join(name)))
}

/// `HOST_NAME-PROCESS-XXXXXX` of the name of a temporary file.
pub(super) fn host_and_process(name: &OsStr) -> Option<&str> {
    name.to_str()?.strip_prefix(TEMPORARY_PREFIX)?.strip_suffix(TEMPORARY_SUFFIX)
}

/// Whether the `owner` of the file at `path` (host and process) is a process of this computer that no longer runs.
pub(super) fn has_dead_owner(owner: &str, path: &Path) -> bool {
    let Some(process) = process_of_owner(owner) else { return false };
    process != std::process::id() && !is_alive(process) && is_open_nowhere(path)
}

/// The process of this computer in `HOST_NAME-PROCESS-XXXXXX`.
fn process_of_owner(owner: &str) -> Option<u32> {
    let rest = owner.strip_prefix(host_in_names())?.strip_prefix('-')?;
    let (process, random) = rest.split_once('-')?;
    process.parse().ok().filter(|_| !random.is_empty() && !random.contains('-'))
}

#[cfg(unix)]
fn is_alive(process: u32) -> bool {
    use rustix::{io::Errno, process};
    let process = i32::try_from(process).ok().and_then(process::Pid::from_raw);
    // A process of another user cannot be signalled, but it exists.
    process.is_some_and(|process| process::test_kill_process(process) != Err(Errno::SRCH))
}

/// Always false on Windows, where [`is_open_nowhere`] finds whether a running process has the file open.
#[cfg(windows)]
fn is_alive(_process: u32) -> bool {
    false
}

/// Whether no process has the file open; `false` for anything else than an ordinary file.
fn is_open_nowhere(path: &Path) -> bool {
    file_access::open_to_lock(path).is_ok_and(|file| file.try_lock().is_ok())
}

/// The computer's name, with only those letters that every file system allows.
fn host_in_names() -> &'static str {
    static HOST_NAME: OnceLock<String> = OnceLock::new();
    HOST_NAME.get_or_init(|| {
        let name = host_name();
        let plain = |c: char| if c.is_ascii_alphanumeric() || c == '.' || c == '_' { c } else { '_' };
        let name: String = name.chars().take(64).map(plain).collect();
        if name.is_empty() { "unnamed".to_owned() } else { name }
    })
}

#[cfg(unix)]
fn host_name() -> String {
    rustix::system::uname().nodename().to_string_lossy().into_owned()
}

#[cfg(windows)]
fn host_name() -> String {
    gethostname::gethostname().to_string_lossy().into_owned()
}

fn create_in(
    builder: &mut tempfile::Builder<'_, '_>,
    folder: &Path,
    like: Option<&Metadata>,
) -> std::io::Result<NamedTempFile> {
    builder.make_in(folder, |path| file_access::create_new(path, &mut open_options(like)))
}

#[cfg(unix)]
fn open_options(like: Option<&Metadata>) -> OpenOptions {
    use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
    let mut options = File::options();
    // Without a file to be like, what any new file gets; the process's mask still applies.
    options.mode(like.map_or(0o666, |metadata| metadata.permissions().mode() & 0o777));
    options
}

/// With these options other processes may read, rename and remove the open file, but not write it.
#[cfg(windows)]
fn open_options(_like: Option<&Metadata>) -> OpenOptions {
    use std::os::windows::fs::OpenOptionsExt;
    const FILE_SHARE_READ: u32 = 1;
    // Without it not even this process could give the file its final name.
    const FILE_SHARE_DELETE: u32 = 4;
    let mut options = File::open_options();
    options.share_mode(FILE_SHARE_READ | FILE_SHARE_DELETE);
    options
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_the_host_and_process_of_its_file() {
        let folder = tempfile::tempdir().unwrap();
        let file = new_file(folder.path(), None).unwrap();
        let name = file.path().file_name().unwrap();
        assert_eq!(process_of_owner(host_and_process(name).unwrap()), Some(std::process::id()));
        assert!(!is_left_over(folder.path(), name));
        assert!(!is_open_nowhere(file.path()));
        assert_eq!(process_of_owner(&format!("not.{}-1-abcdef", host_in_names())), None);
        assert_eq!(process_of_owner(&format!("{}-x-abcdef", host_in_names())), None);
    }

    /// This holds before the file is locked, too, because another run may look at any moment.
    #[cfg(windows)]
    #[test]
    fn no_other_process_can_write_a_file_until_it_has_its_final_name() {
        let folder = tempfile::tempdir().unwrap();
        let mut builder = tempfile::Builder::new();
        let file = create_in(builder.prefix(TEMPORARY_PREFIX).suffix(TEMPORARY_SUFFIX), folder.path(), None)
            .unwrap();
        let path = file.path().to_owned();
        assert!(!is_open_nowhere(&path));
        let target = folder.path().join("model.osim");
        std::fs::write(&target, "before").unwrap();
        let file = file.persist(&target).unwrap();
        assert!(!path.exists() && !is_open_nowhere(&target));
        drop(file);
        assert!(is_open_nowhere(&target));
    }

    #[test]
    fn only_a_closed_file_of_a_dead_process_is_left_over() {
        let folder = tempfile::tempdir().unwrap();
        let mut child = std::process::Command::new(std::env::current_exe().unwrap())
            .arg("--list")
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let dead = child.id();
        child.wait().unwrap();
        let name = |process: u32| {
            format!("{TEMPORARY_PREFIX}{}-{process}-abcdef{TEMPORARY_SUFFIX}", host_in_names())
        };
        let of_dead = folder.path().join(name(dead));
        let held = File::create(&of_dead).unwrap();
        held.lock().unwrap();
        assert!(!is_left_over(folder.path(), name(dead).as_ref()), "somebody has it open");
        drop(held);
        assert!(is_left_over(folder.path(), name(dead).as_ref()));
        #[cfg(unix)]
        {
            let alive = std::os::unix::process::parent_id();
            std::fs::write(folder.path().join(name(alive)), "").unwrap();
            assert!(!is_left_over(folder.path(), name(alive).as_ref()));
        }
    }
}
