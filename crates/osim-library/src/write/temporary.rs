//! Names of files that are being written, and what is left of them when a process is killed.
//!
//! `.osim-contact-scale-HOST-PROCESS-XXXXXX.tmp`: a later run on the same computer knows whose file it is. If that
//! process is gone, nobody will ever finish the file, and it is removed. No other program's work ever has such a name: files that
//! are exchanged have names of [`replaced`](super::replaced) before.
//!
//! On Windows a file shows by itself whether its writer is there: from the moment it is made until it has its final
//! name, nobody else can open it for writing.

use std::ffi::OsStr;
use std::fs::{File, Metadata, OpenOptions};
use std::path::Path;
use std::sync::OnceLock;

use tempfile::NamedTempFile;

use crate::file_access;

const PREFIX: &str = ".osim-contact-scale-";
const SUFFIX: &str = ".tmp";

/// A new file in `folder` that only this process writes, with the mode bits of `like`.
///
/// It is locked as long as it is open, so that under this name it counts as alive also where processes of several containers share a
/// folder and a host name, and cannot see each other.
pub(crate) fn file(folder: &Path, like: Option<&Metadata>) -> std::io::Result<NamedTempFile> {
    let prefix = format!("{PREFIX}{}-{}-", host(), std::process::id());
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix).suffix(SUFFIX);
    let temporary = made(&mut builder, folder, like)?;
    // Some network file systems know no locks: the process in the name has to do there.
    drop(temporary.as_file().try_lock());
    Ok(temporary)
}

/// Whether `name` is that of a file left by a process of this computer that is gone.
pub(crate) fn is_left_over(folder: &Path, name: &OsStr) -> bool {
    whose(name).is_some_and(|whose| is_gone(whose, &folder.join(name)))
}

/// `HOST-PROCESS-XXXXXX` of the name of a temporary file.
pub(super) fn whose(name: &OsStr) -> Option<&str> {
    name.to_str()?.strip_prefix(PREFIX)?.strip_suffix(SUFFIX)
}

/// Whether `path` is that of a process of this computer that is gone.
pub(super) fn is_gone(whose: &str, path: &Path) -> bool {
    let Some(process) = process_of(whose) else { return false };
    process != std::process::id() && !is_alive(process) && nobody_has_open(path)
}

/// The process of this computer in `HOST-PROCESS-XXXXXX`.
fn process_of(whose: &str) -> Option<u32> {
    let rest = whose.strip_prefix(host())?.strip_prefix('-')?;
    let (process, random) = rest.split_once('-')?;
    process.parse().ok().filter(|_| !random.is_empty() && !random.contains('-'))
}

#[cfg(unix)]
fn is_alive(process: u32) -> bool {
    use rustix::{io::Errno, process};
    let process = i32::try_from(process).ok().and_then(process::Pid::from_raw);
    // Somebody else's process may not be sent anything, but it is there.
    process.is_some_and(|process| process::test_kill_process(process) != Err(Errno::SRCH))
}

/// Whether the process is alive. Windows need not be asked: a process that is alive has the file open, which
/// [`nobody_has_open`] finds.
#[cfg(windows)]
fn is_alive(_process: u32) -> bool {
    false
}

/// Whether nobody has the file open. What is not an ordinary file was not made here: it stays.
fn nobody_has_open(path: &Path) -> bool {
    file_access::open_to_lock(path).is_ok_and(|file| file.try_lock().is_ok())
}

/// The computer's name, of letters that every file system takes.
fn host() -> &'static str {
    static HOST: OnceLock<String> = OnceLock::new();
    HOST.get_or_init(|| {
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

fn made(
    builder: &mut tempfile::Builder<'_, '_>,
    folder: &Path,
    like: Option<&Metadata>,
) -> std::io::Result<NamedTempFile> {
    builder.make_in(folder, |path| file_access::create_new(path, &mut options(like)))
}

#[cfg(unix)]
fn options(like: Option<&Metadata>) -> OpenOptions {
    use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
    let mut options = File::options();
    // Without a file to be like, what any new file gets; the process's mask still applies.
    options.mode(like.map_or(0o666, |metadata| metadata.permissions().mode() & 0o777));
    options
}

/// Others may read, rename and remove the file while it is open, but not write it.
#[cfg(windows)]
fn options(_like: Option<&Metadata>) -> OpenOptions {
    use std::os::windows::fs::OpenOptionsExt;
    const FILE_SHARE_READ: u32 = 1;
    // Without it not even this process could give the file its final name.
    const FILE_SHARE_DELETE: u32 = 4;
    let mut options = File::options();
    options.share_mode(FILE_SHARE_READ | FILE_SHARE_DELETE);
    options
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_tells_whose_file_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let file = file(folder.path(), None).unwrap();
        let name = file.path().file_name().unwrap();
        assert_eq!(process_of(whose(name).unwrap()), Some(std::process::id()));
        assert!(!is_left_over(folder.path(), name));
        assert!(!nobody_has_open(file.path()));
        assert_eq!(process_of(&format!("not.{}-1-abcdef", host())), None);
        assert_eq!(process_of(&format!("{}-x-abcdef", host())), None);
    }

    /// Before it is locked, too: another run may look at any moment.
    #[cfg(windows)]
    #[test]
    fn a_file_is_its_writers_from_the_beginning_to_its_final_name() {
        let folder = tempfile::tempdir().unwrap();
        let mut builder = tempfile::Builder::new();
        let file = made(builder.prefix(PREFIX).suffix(SUFFIX), folder.path(), None).unwrap();
        let path = file.path().to_owned();
        assert!(!nobody_has_open(&path));
        let target = folder.path().join("model.osim");
        std::fs::write(&target, "before").unwrap();
        let file = file.persist(&target).unwrap();
        assert!(!path.exists() && !nobody_has_open(&target));
        drop(file);
        assert!(nobody_has_open(&target));
    }

    #[test]
    fn only_a_file_of_a_dead_process_that_nobody_has_open_is_left_over() {
        let folder = tempfile::tempdir().unwrap();
        let mut child = std::process::Command::new(std::env::current_exe().unwrap())
            .arg("--list")
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let dead = child.id();
        child.wait().unwrap();
        let name = |process: u32| format!("{PREFIX}{}-{process}-abcdef{SUFFIX}", host());
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
