//! A model that is changed itself: what another program saves at the same time is never lost.
//!
//! Between a look at the model and a rename over it another program may save. So the successor and the model exchange their
//! names in one step, and then what came out is compared with what was read. If it is something else, it is put back: the
//! save of the other program stays, and the run reports the model as changed. What comes out when it is put back should be
//! the successor; if the other program saved once more, that newer save goes back in the same way. What is then left over
//! and is not ours becomes a further backup.
//!
//! Where files cannot be exchanged (Windows, some network and FAT disks) the model is read once more right before the rename.

use std::fs::Metadata;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use osim_model::{Finding, FindingCode};
use tempfile::{NamedTempFile, TempPath};

use super::exchange::{Exchange, exchange};
use super::prepared::{Prepared, backup_names, sync_folder_of};
use crate::door;
use crate::fault::LibraryFault;
use crate::paths::resolved;

/// How often a save that comes in between is put back before it is kept as a backup instead.
const PUT_BACK: usize = 8;

/// A model's successor, with what it takes to know whether the model is still as it was read.
pub(crate) struct Successor<'b> {
    /// The successor itself.
    pub(crate) prepared: Prepared,
    /// What was read.
    pub(crate) before: &'b [u8],
    /// What was written.
    pub(crate) after: Vec<&'b [u8]>,
    /// Where what was read is kept.
    pub(crate) backup: Option<PathBuf>,
}

/// A successor in its place.
pub(crate) struct InPlace<'b> {
    /// Under its name is what it displaced; none where that is gone.
    displaced: Option<NamedTempFile>,
    target: PathBuf,
    shown: PathBuf,
    after: Vec<&'b [u8]>,
    backup: Option<PathBuf>,
}

impl<'b> Successor<'b> {
    /// Takes the model's place, if the model is what was read.
    ///
    /// # Errors
    /// It is something else by now, or is gone: nothing was written. Or the folder cannot be changed.
    pub(crate) fn take_place(self) -> Result<InPlace<'b>, LibraryFault> {
        let Self { prepared, before, after, backup } = self;
        let (mut temporary, target, shown) = prepared.into_parts();
        let cannot = |error: std::io::Error| {
            LibraryFault::because(format!("cannot write {}", shown.display()), door::reason(&error))
        };
        // From here on the temporary name may be that of somebody's work.
        temporary.disable_cleanup(true);
        match exchange(temporary.path(), &target) {
            Exchange::Done => {}
            Exchange::NotPossible => {
                temporary.disable_cleanup(false);
                if !is(&target, &[before]) {
                    return Err(changed(&shown, None, &backup));
                }
                temporary.persist(&target).map_err(|error| cannot(error.error))?;
                sync_folder_of(&target);
                return Ok(InPlace { displaced: None, target, shown, after, backup });
            }
            Exchange::Failed(error) => {
                temporary.disable_cleanup(false);
                return Err(if error.kind() == ErrorKind::NotFound { gone(&shown) } else { cannot(error) });
            }
        }
        let in_place = InPlace { displaced: Some(temporary), target, shown, after, backup };
        if in_place.displaced.as_ref().is_some_and(|displaced| is(displaced.path(), &[before])) {
            sync_folder_of(&in_place.target);
            return Ok(in_place);
        }
        let (shown, backup) = (in_place.shown.clone(), in_place.backup.clone());
        let kept = in_place.put_back();
        Err(changed(&shown, kept.as_deref(), &backup))
    }
}

impl InPlace<'_> {
    /// What was displaced goes: it is the model that was read. Where a backup is kept, the displaced file itself becomes the
    /// backup: what a program that has it open still writes into it is there, too.
    pub(crate) fn settle(self) {
        let Some(mut displaced) = self.displaced else { return };
        let linked = std::fs::metadata(displaced.path()).is_ok_and(|metadata| names_of(&metadata) > 1);
        if let Some(backup) = self.backup.filter(|_| !linked)
            && std::fs::rename(displaced.path(), backup).is_ok()
        {
            return;
        }
        displaced.disable_cleanup(false);
    }

    /// Puts what was displaced back into its place; what was displaced by that and is not ours is kept: where.
    pub(crate) fn put_back(self) -> Option<PathBuf> {
        let mut displaced = self.displaced?;
        let mut went_in: Option<Vec<u8>> = None;
        for _ in 0..PUT_BACK {
            let going_in = door::ordinary(displaced.path()).ok();
            if !matches!(exchange(displaced.path(), &self.target), Exchange::Done) {
                break;
            }
            if is(displaced.path(), &self.after) {
                displaced.disable_cleanup(false);
                sync_folder_of(&self.target);
                return None;
            }
            if went_in.as_deref().is_some_and(|went_in| is(displaced.path(), &[went_in])) {
                break;
            }
            went_in = going_in;
        }
        Some(kept(displaced.into_temp_path(), &self.target))
    }
}

/// Gives a file that is somebody's work the name of a further backup.
fn kept(mut file: TempPath, target: &Path) -> PathBuf {
    for name in backup_names(target) {
        match file.persist_noclobber(&name) {
            Ok(()) => return name,
            Err(error) if error.error.kind() == ErrorKind::AlreadyExists => file = error.path,
            Err(mut error) => {
                error.path.disable_cleanup(true);
                return error.path.to_path_buf();
            }
        }
    }
    target.to_owned()
}

/// Whether the file has these bytes, which may lie in several places.
fn is(path: &Path, parts: &[&[u8]]) -> bool {
    let Ok(bytes) = door::ordinary(path) else { return false };
    let mut rest = bytes.as_slice();
    parts.iter().all(|part| {
        let begins = rest.strip_prefix(*part);
        rest = begins.unwrap_or_default();
        begins.is_some()
    }) && rest.is_empty()
}

fn gone(shown: &Path) -> LibraryFault {
    LibraryFault::new(format!("{} is no longer there, so nothing was written", shown.display()))
}

fn changed(shown: &Path, kept: Option<&Path>, backup: &Option<PathBuf>) -> LibraryFault {
    let mut message = format!(
        "another program changed {} while it was being worked on, so nothing was written: run again",
        shown.display()
    );
    if let Some(kept) = kept {
        message.push_str(&format!("; it saved more than once: what came in between is {}", kept.display()));
    }
    if let Some(backup) = backup {
        message.push_str(&format!(" (as it was read: {})", backup.display()));
    }
    LibraryFault::new(message)
}

/// A model that has other names too, of which each would keep the old model.
pub(crate) fn other_names(path: &Path) -> Option<Finding> {
    let others =
        names_of(&std::fs::metadata(resolved(path)).ok()?).checked_sub(1).filter(|&others| others > 0)?;
    let names = if others == 1 { "one more name".to_owned() } else { format!("{others} more names") };
    let text = format!("{} has {names} (hard links), under which the old model stays", path.display());
    Some(Finding::new(FindingCode::HardLinked, text))
}

/// How many names a file has.
#[cfg(unix)]
fn names_of(metadata: &Metadata) -> u64 {
    std::os::unix::fs::MetadataExt::nlink(metadata)
}

/// Not known without opening it.
#[cfg(not(unix))]
fn names_of(_metadata: &Metadata) -> u64 {
    1
}

#[cfg(test)]
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
mod tests {
    use super::*;
    use crate::write::{Mode, backup};

    const READ: &[u8] = b"as it was read";
    const SUCCESSOR: &[u8] = b"the successor of it";

    /// A model that was read, its backup and its successor.
    fn ready(folder: &Path) -> (PathBuf, Successor<'static>) {
        let target = folder.join("model.osim");
        std::fs::write(&target, READ).unwrap();
        let (copy, kept) = backup(&target, READ).unwrap();
        copy.unwrap().commit().unwrap();
        let prepared = Prepared::new(&target, SUCCESSOR, None, Mode::InPlace).unwrap();
        let successor = Successor {
            prepared,
            before: READ,
            after: vec![b"the successor", b" of it"],
            backup: Some(kept),
        };
        (target, successor)
    }

    fn names(folder: &Path) -> Vec<String> {
        let name =
            |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
        let mut names: Vec<String> = std::fs::read_dir(folder).unwrap().map(name).collect();
        names.sort();
        names
    }

    fn read(folder: &Path, name: &str) -> Vec<u8> {
        std::fs::read(folder.join(name)).unwrap()
    }

    #[test]
    fn the_model_itself_becomes_the_backup() {
        let folder = tempfile::tempdir().unwrap();
        let (target, successor) = ready(folder.path());
        // A program that has the model open, and saves late.
        let mut open = std::fs::File::options().append(true).open(&target).unwrap();
        successor.take_place().unwrap().settle();
        std::io::Write::write_all(&mut open, b" and saved late").unwrap();
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
        assert_eq!(read(folder.path(), "model.osim"), SUCCESSOR);
        assert_eq!(read(folder.path(), "model.osim.bak"), b"as it was read and saved late");
    }

    #[test]
    fn what_was_saved_before_the_exchange_stays() {
        let folder = tempfile::tempdir().unwrap();
        let (target, successor) = ready(folder.path());
        std::fs::write(&target, "saved").unwrap();
        let fault = successor.take_place().err().unwrap().to_string();
        assert!(fault.contains("another program changed") && fault.contains("model.osim.bak"), "{fault}");
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
        assert_eq!(read(folder.path(), "model.osim"), b"saved");
        assert_eq!(read(folder.path(), "model.osim.bak"), READ);
    }

    /// The newest save stays under the name, the one before it as a further backup.
    #[test]
    fn what_was_saved_after_the_exchange_stays_too() {
        let folder = tempfile::tempdir().unwrap();
        let (target, successor) = ready(folder.path());
        let in_place = successor.take_place().unwrap();
        let displaced = in_place.displaced.as_ref().unwrap().path().to_owned();
        std::fs::write(&displaced, "saved first").unwrap();
        std::fs::write(folder.path().join("new"), "saved second").unwrap();
        std::fs::rename(folder.path().join("new"), &target).unwrap();
        let kept = in_place.put_back().unwrap();
        assert_eq!(kept, target.with_file_name("model.osim.bak2"));
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak", "model.osim.bak2"]);
        assert_eq!(read(folder.path(), "model.osim"), b"saved second");
        assert_eq!(read(folder.path(), "model.osim.bak2"), b"saved first");
    }

    #[test]
    fn a_model_that_is_gone_or_a_folder_now_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let (target, successor) = ready(folder.path());
        std::fs::remove_file(&target).unwrap();
        assert!(successor.take_place().err().unwrap().to_string().contains("no longer there"));
        assert_eq!(names(folder.path()), ["model.osim.bak"]);
        let folder = tempfile::tempdir().unwrap();
        let (target, successor) = ready(folder.path());
        std::fs::remove_file(&target).unwrap();
        std::fs::create_dir(&target).unwrap();
        assert!(successor.take_place().err().unwrap().to_string().contains("another program changed"));
        assert!(target.is_dir());
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
    }

    #[test]
    fn bytes_in_several_places_are_compared_as_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::fs::write(&path, "abc").unwrap();
        assert!(is(&path, &[b"a", b"", b"bc"]) && is(&path, &[b"abc"]));
        assert!(!is(&path, &[b"ab"]) && !is(&path, &[b"abcd"]) && !is(&path, &[b"abc", b"d"]));
        assert!(!is(&folder.path().join("b"), &[]));
    }
}
