//! A model that is changed itself: what another program saves at the same time is never lost.
//!
//! Between a look at the model and a rename over it another program may save. So the successor and the model exchange their
//! names in one step, and then what came out is compared with what was read. If it is something else, it is put back: the
//! save of the other program stays, and the run reports the model as changed. What comes out when it is put back should be
//! the successor; if the other program saved once more, that newer save goes back in the same way. What is then left over
//! and is not ours becomes a further backup. Whenever the process is killed, that save has the name of the model, of a backup, or of
//! [`replaced`].
//!
//! Where files cannot be exchanged (Windows, some network and FAT disks) the model is read once more right before the rename, and
//! to undo that, what was read is written again.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use osim_model::Finding;
use osim_planning::rules::hard_linked;
use tempfile::NamedTempFile;

use crate::fault::LibraryFault;
use crate::file_access;
use crate::paths::resolved;
use crate::write::exchange::{
    self, EXCHANGE_IS_KNOWN, Exchange, become_backup, exchange, is, kept, names_of,
};
use crate::write::replace::{PendingFile, WriteMode, sync_folder_of};

/// How often a save that comes in between is put back before it is kept as a backup instead.
const PUT_BACK: usize = 8;

/// A model's successor, with what it takes to know whether the model is still as it was read.
pub(crate) struct Successor<'b> {
    /// The successor itself.
    pub(crate) prepared: PendingFile,
    /// What was read.
    pub(crate) before: &'b [u8],
    /// What was written.
    pub(crate) after: Vec<&'b [u8]>,
    /// Where what was read is kept.
    pub(crate) backup: Option<PathBuf>,
}

pub(crate) struct InPlace<'b> {
    /// Under its name is what it displaced; `None` if that is gone, because files cannot be exchanged here.
    displaced: Option<NamedTempFile>,
    target: PathBuf,
    shown: PathBuf,
    before: &'b [u8],
    after: Vec<&'b [u8]>,
    backup: Option<PathBuf>,
}

/// What is left of a change that was undone.
pub(crate) enum Undone {
    /// Nothing.
    Whole,
    /// What another program saved in between, as a further backup.
    Kept(PathBuf),
    /// The model is not what it was, and why.
    Not(String),
}

impl Undone {
    pub(crate) fn remark(&self) -> Option<String> {
        match self {
            Self::Whole => None,
            Self::Kept(path) => Some(format!("what another program saved in between is {}", path.display())),
            Self::Not(why) => Some(why.clone()),
        }
    }
}

impl<'b> Successor<'b> {
    /// Takes the model's place, if the model is what was read.
    ///
    /// # Errors
    /// It is something else by now, or is gone: nothing was written. Or the folder cannot be changed.
    pub(crate) fn take_place(self) -> Result<InPlace<'b>, LibraryFault> {
        let Self { prepared, before, after, backup } = self;
        let (mut successor, target, shown) = prepared.into_parts();
        let cannot = |error: std::io::Error| {
            LibraryFault::system(format!("cannot write {}", shown.display()), file_access::reason(&error))
        };
        if EXCHANGE_IS_KNOWN {
            successor = exchange::renamed(successor, &target, &after).map_err(cannot)?;
        }
        let exchanged = exchange(successor.path(), &target);
        if let Exchange::Done = exchanged {
            let in_place = InPlace { displaced: Some(successor), target, shown, before, after, backup };
            return in_place.if_unchanged();
        }
        // As it should be, it is still our own file.
        successor.disable_cleanup(!is(successor.path(), &after));
        if let Exchange::Failed(error) = exchanged {
            return Err(if error.kind() == ErrorKind::NotFound { gone(&shown) } else { cannot(error) });
        }
        if !is(&target, &[before]) {
            return Err(changed(&shown, &Undone::Whole, &backup));
        }
        successor.persist(&target).map_err(|error| cannot(error.error))?;
        sync_folder_of(&target);
        Ok(InPlace { displaced: None, target, shown, before, after, backup })
    }
}

impl InPlace<'_> {
    /// Puts back what was displaced, if that is not what was read.
    fn if_unchanged(self) -> Result<Self, LibraryFault> {
        if self.displaced.as_ref().is_some_and(|displaced| is(displaced.path(), &[self.before])) {
            sync_folder_of(&self.target);
            return Ok(self);
        }
        let (shown, backup) = (self.shown.clone(), self.backup.clone());
        Err(changed(&shown, &self.put_back(), &backup))
    }

    /// What was displaced goes: it is the model that was read. Where a backup is kept, the displaced file itself becomes the
    /// backup: what a program that has it open still writes into it is there, too.
    pub(crate) fn settle(self) {
        let Some(mut displaced) = self.displaced else { return };
        match self.backup {
            Some(backup) => become_backup(displaced.path(), &backup),
            None => displaced.disable_cleanup(false),
        }
    }

    /// Puts what was displaced back into its place; what was displaced by that and is not ours is kept.
    pub(crate) fn put_back(self) -> Undone {
        let Some(mut displaced) = self.displaced else { return self.write_back() };
        let (mut went_in, mut is_back): (Option<Vec<u8>>, bool) = (None, false);
        for _ in 0..PUT_BACK {
            let going_in = file_access::read_ordinary(displaced.path()).ok();
            if !matches!(exchange(displaced.path(), &self.target), Exchange::Done) {
                break;
            }
            is_back = true;
            if is(displaced.path(), &self.after) {
                displaced.disable_cleanup(false);
                sync_folder_of(&self.target);
                return Undone::Whole;
            }
            if went_in.as_deref().is_some_and(|went_in| is(displaced.path(), &[went_in])) {
                break;
            }
            went_in = going_in;
        }
        let path = displaced.path().to_owned();
        let kept = kept(displaced.into_temp_path(), &self.target).unwrap_or(path);
        if is_back {
            return Undone::Kept(kept);
        }
        Undone::Not(format!(
            "{} is changed and could not be put back: it is {}",
            self.shown.display(),
            kept.display()
        ))
    }

    /// Where files cannot be exchanged: what was read takes the place of the successor again.
    fn write_back(self) -> Undone {
        let Self { target, shown, before, after, backup, .. } = self;
        let (shown, read) = (shown.display(), as_read(&backup));
        if !is(&target, &after) {
            return Undone::Not(format!("{shown} was changed, and then another program saved it{read}"));
        }
        let written = PendingFile::new(&target, before, None, WriteMode::InPlace)
            .and_then(|prepared| prepared.sync().and_then(|()| prepared.commit()));
        match written {
            Ok(()) => Undone::Whole,
            Err(fault) => {
                Undone::Not(format!("{shown} is changed and could not be put back ({fault}){read}"))
            }
        }
    }
}

fn gone(shown: &Path) -> LibraryFault {
    LibraryFault::new(format!("{} is no longer there, so nothing was written", shown.display()))
}

fn changed(shown: &Path, undone: &Undone, backup: &Option<PathBuf>) -> LibraryFault {
    let mut message = format!(
        "another program changed {} while it was being worked on, so nothing was written: run again",
        shown.display()
    );
    match undone {
        Undone::Whole => {}
        Undone::Kept(kept) => message
            .push_str(&format!("; it saved more than once: what came in between is {}", kept.display())),
        Undone::Not(why) => {
            message =
                format!("another program changed {} while it was being worked on: {why}", shown.display());
        }
    }
    message.push_str(&as_read(backup));
    LibraryFault::new(message)
}

fn as_read(backup: &Option<PathBuf>) -> String {
    backup.as_ref().map_or_else(String::new, |backup| format!(" (as it was read: {})", backup.display()))
}

/// A finding about a model that has other names, too: each would keep the old model.
pub(crate) fn other_names(path: &Path) -> Option<Finding> {
    let others =
        names_of(&std::fs::metadata(resolved(path)).ok()?).checked_sub(1).filter(|&others| others > 0)?;
    Some(hard_linked(path, others))
}

#[cfg(test)]
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
mod tests {
    use super::*;
    use crate::write::backup;

    const READ: &[u8] = b"as it was read";
    const SUCCESSOR: &[u8] = b"the successor of it";

    /// A model that was read, its backup and its successor.
    fn ready(folder: &Path) -> (PathBuf, Successor<'static>) {
        let target = folder.join("model.osim");
        std::fs::write(&target, READ).unwrap();
        let (copy, kept) = backup(&target, READ).unwrap();
        copy.unwrap().commit().unwrap();
        let prepared = PendingFile::new(&target, SUCCESSOR, None, WriteMode::InPlace).unwrap();
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
        let kept = in_place.put_back();
        let expected = target.with_file_name("model.osim.bak2");
        assert!(matches!(kept, Undone::Kept(kept) if kept == expected));
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak", "model.osim.bak2"]);
        assert_eq!(read(folder.path(), "model.osim"), b"saved second");
        assert_eq!(read(folder.path(), "model.osim.bak2"), b"saved first");
    }

    /// What a process leaves that is killed at this moment, under a name of a process that is gone.
    fn left(in_place: InPlace<'_>) -> PathBuf {
        let path = in_place.displaced.as_ref().unwrap().path().to_owned();
        let name = path.file_name().unwrap().to_str().unwrap();
        assert!(name.starts_with("model.osim.replaced-"), "{name}");
        std::mem::forget(in_place);
        path
    }

    #[test]
    fn what_a_killed_run_displaced_is_a_backup_afterwards() {
        for (saved, kept) in [(READ, None), (b"saved".as_slice(), Some("model.osim.bak2")), (SUCCESSOR, None)]
        {
            let folder = tempfile::tempdir().unwrap();
            let (_, successor) = ready(folder.path());
            let left = left(successor.take_place().unwrap());
            std::fs::write(&left, saved).unwrap();
            let expected = kept.map(|name| folder.path().join(name));
            assert_eq!(exchange::settle(&left), expected);
            let all: Vec<&str> = ["model.osim", "model.osim.bak"].into_iter().chain(kept).collect();
            assert_eq!(names(folder.path()), all);
            assert_eq!(read(folder.path(), "model.osim.bak"), READ);
            assert!(kept.is_none_or(|name| read(folder.path(), name) == saved));
        }
    }

    #[test]
    fn a_model_with_a_very_long_name_is_changed_too() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join(format!("{}.osim", "\u{fc}".repeat(122)));
        std::fs::write(&target, READ).unwrap();
        let prepared = PendingFile::new(&target, SUCCESSOR, None, WriteMode::InPlace).unwrap();
        let successor = Successor { prepared, before: READ, after: vec![SUCCESSOR], backup: None };
        successor.take_place().unwrap().settle();
        assert_eq!(names(folder.path()).len(), 1);
        assert_eq!(std::fs::read(&target).unwrap(), SUCCESSOR);
    }

    /// As on systems that cannot exchange files.
    #[test]
    fn what_was_read_is_written_again_where_nothing_is_displaced() {
        for (saved, whole) in [(None, true), (Some("saved"), false)] {
            let folder = tempfile::tempdir().unwrap();
            let (target, successor) = ready(folder.path());
            let mut in_place = successor.take_place().unwrap();
            std::fs::remove_file(in_place.displaced.take().unwrap().path()).unwrap();
            if let Some(saved) = saved {
                std::fs::write(&target, saved).unwrap();
            }
            let undone = in_place.put_back();
            assert_eq!(undone.remark().is_none(), whole);
            assert!(undone.remark().is_none_or(|remark| remark.contains("model.osim.bak")));
            assert_eq!(read(folder.path(), "model.osim"), saved.map_or(READ, str::as_bytes));
            assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
        }
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
