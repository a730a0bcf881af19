//! Changes a model in place so that a file which another program saves at the same time is never lost.
//!
//! Another program may save the model after this program read it and before this program replaces it. So the new version (the
//! replacement) and the model exchange their names in one step, and then the bytes of the displaced file are compared with the bytes
//! that were read. If they differ, the displaced file is put back: the save of the other program stays, and the run reports the model
//! as changed. This second exchange should displace the replacement. If the other program saved once more, its newer save is put back
//! in the same way. A displaced file that is neither the old model nor the replacement becomes a further backup in the end. Whenever
//! the process is killed, the save of the other program has the name of the model, of a backup, or of [`replaced`].
//!
//! Where files cannot be exchanged (Windows, some network and FAT disks) the model is read once more right before it is replaced. To
//! undo the change, the bytes that were read are written again.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use osim_model::Finding;
use osim_planning::rules::hard_linked;
use tempfile::NamedTempFile;

use crate::write::exchange::{
    self, EXCHANGE_IS_KNOWN, ExchangeOutcome, become_backup, exchange, has_bytes, keep_as_backup, link_count,
};
use crate::write::replace::{PendingFile, WriteMode, sync_folder_of};
use crate::{LibraryFault, Result, file_access, resolved};

/// How often a file that another program saves during an exchange is put back, before it is kept as a backup instead.
const MOST_TRIES_TO_PUT_BACK: usize = 8;

/// The new file of a model, with the bytes that show whether the model changed since it was read.
pub(crate) struct ReplacementFile<'b> {
    pub(crate) prepared: PendingFile,
    /// The model's bytes when it was read.
    pub(crate) read_bytes: &'b [u8],
    /// The new bytes of the file, in several parts.
    pub(crate) written_bytes: Vec<&'b [u8]>,
    /// Path of the backup of the old model, if one is kept.
    pub(crate) backup: Option<PathBuf>,
}

/// A model that has just been replaced by its new file; the old file is still there to undo it.
pub(crate) struct ExchangedModel<'b> {
    /// The displaced old file; `None` if it is gone, because this system cannot exchange files.
    displaced: Option<NamedTempFile>,
    target: PathBuf,
    shown: PathBuf,
    read_bytes: &'b [u8],
    written_bytes: Vec<&'b [u8]>,
    backup: Option<PathBuf>,
}

/// Result of undoing a change in place.
pub(crate) enum UndoOutcome {
    /// The old model has its name again.
    Restored,
    /// The old model has its name again; what another program saved in the meantime is kept in this backup file.
    Kept(PathBuf),
    /// The old model could not be restored, for this reason.
    NotRestored(String),
}

impl UndoOutcome {
    /// A remark on what happened while the change was undone; `None` if all is as before.
    pub(crate) fn remark(&self) -> Option<String> {
        match self {
            Self::Restored => None,
            Self::Kept(path) => Some(format!("what another program saved in between is {}", path.display())),
            Self::NotRestored(why) => Some(why.clone()),
        }
    }
}

impl<'b> ReplacementFile<'b> {
    /// Replaces the model by the new file, if the model still has the bytes that were read.
    ///
    /// # Errors
    /// The model was changed or removed by another program, so that nothing was written; or the folder cannot be changed.
    pub(crate) fn replace_model(self) -> Result<ExchangedModel<'b>> {
        let Self { prepared, read_bytes, written_bytes, backup } = self;
        let (mut replacement, target, shown) = prepared.into_parts();
        let cannot = |error: std::io::Error| {
            LibraryFault::system(format!("cannot write {}", shown.display()), file_access::reason(&error))
        };
        if EXCHANGE_IS_KNOWN {
            replacement =
                exchange::rename_for_exchange(replacement, &target, &written_bytes).map_err(cannot)?;
        }
        let exchanged = exchange(replacement.path(), &target);
        if let ExchangeOutcome::Done = exchanged {
            let displaced = Some(replacement);
            return ExchangedModel { displaced, target, shown, read_bytes, written_bytes, backup }
                .keep_if_unchanged();
        }
        // The replacement is removed unless another program has written into it.
        replacement.disable_cleanup(!has_bytes(replacement.path(), &written_bytes));
        if let ExchangeOutcome::Failed(error) = exchanged {
            let gone = format!("{} is no longer there, so nothing was written", shown.display());
            let is_gone = error.kind() == ErrorKind::NotFound;
            return Err(if is_gone { LibraryFault::new(gone) } else { cannot(error) });
        }
        if !has_bytes(&target, &[read_bytes]) {
            return Err(fault_of_changed_model(&shown, &UndoOutcome::Restored, &backup));
        }
        replacement.persist(&target).map_err(|error| cannot(error.error))?;
        sync_folder_of(&target);
        Ok(ExchangedModel { displaced: None, target, shown, read_bytes, written_bytes, backup })
    }
}

impl ExchangedModel<'_> {
    /// Puts the displaced file back, if it does not have the bytes that were read.
    fn keep_if_unchanged(self) -> Result<Self> {
        if self.displaced.as_ref().is_some_and(|displaced| has_bytes(displaced.path(), &[self.read_bytes])) {
            sync_folder_of(&self.target);
            return Ok(self);
        }
        let (shown, backup) = (self.shown.clone(), self.backup.clone());
        Err(fault_of_changed_model(&shown, &self.put_back(), &backup))
    }

    /// Removes the displaced old file, or makes it the backup, which so keeps bytes that another program still writes into the old file.
    pub(crate) fn finish(self) {
        let Some(mut displaced) = self.displaced else { return };
        match self.backup {
            Some(backup) => become_backup(displaced.path(), &backup),
            None => displaced.disable_cleanup(false),
        }
    }

    /// Puts the displaced file back. If this displaces a file of another program, that file is put back in the same way, or kept as a
    /// backup.
    pub(crate) fn put_back(self) -> UndoOutcome {
        let Some(mut displaced) = self.displaced else { return self.write_old_bytes() };
        let (mut went_in, mut is_back): (Option<Vec<u8>>, bool) = (None, false);
        for _ in 0..MOST_TRIES_TO_PUT_BACK {
            let going_in = file_access::read_ordinary(displaced.path()).ok();
            if !matches!(exchange(displaced.path(), &self.target), ExchangeOutcome::Done) {
                break;
            }
            is_back = true;
            if has_bytes(displaced.path(), &self.written_bytes) {
                displaced.disable_cleanup(false);
                sync_folder_of(&self.target);
                return UndoOutcome::Restored;
            }
            if went_in.as_deref().is_some_and(|went_in| has_bytes(displaced.path(), &[went_in])) {
                break;
            }
            went_in = going_in;
        }
        let path = displaced.path().to_owned();
        let kept = keep_as_backup(displaced.into_temp_path(), &self.target).unwrap_or(path);
        if is_back {
            return UndoOutcome::Kept(kept);
        }
        UndoOutcome::NotRestored(format!(
            "{} is changed and could not be put back: it is {}",
            self.shown.display(),
            kept.display()
        ))
    }

    /// Writes the old bytes of the model again, on a system that cannot exchange files.
    fn write_old_bytes(self) -> UndoOutcome {
        let Self { target, shown, read_bytes, written_bytes, backup, .. } = self;
        let (shown, read) = (shown.display(), backup_in_words(&backup));
        if !has_bytes(&target, &written_bytes) {
            return UndoOutcome::NotRestored(format!(
                "{shown} was changed, and then another program saved it{read}"
            ));
        }
        let written = PendingFile::new(&target, read_bytes, None, WriteMode::InPlace)
            .and_then(|prepared| prepared.sync().and_then(|()| prepared.commit()));
        match written {
            Ok(()) => UndoOutcome::Restored,
            Err(fault) => UndoOutcome::NotRestored(format!(
                "{shown} is changed and could not be put back ({fault}){read}"
            )),
        }
    }
}

/// The fault that another program changed the model meanwhile, with what happened to the files.
fn fault_of_changed_model(shown: &Path, undone: &UndoOutcome, backup: &Option<PathBuf>) -> LibraryFault {
    let mut message = format!(
        "another program changed {} while it was being worked on, so nothing was written: run again",
        shown.display()
    );
    match undone {
        UndoOutcome::Restored => {}
        UndoOutcome::Kept(kept) => message
            .push_str(&format!("; it saved more than once: what came in between is {}", kept.display())),
        UndoOutcome::NotRestored(why) => {
            message =
                format!("another program changed {} while it was being worked on: {why}", shown.display());
        }
    }
    message.push_str(&backup_in_words(backup));
    LibraryFault::new(message)
}

fn backup_in_words(backup: &Option<PathBuf>) -> String {
    backup.as_ref().map_or_else(String::new, |backup| format!(" (as it was read: {})", backup.display()))
}

/// The finding that a model has other names (hard links), under which the old model stays.
pub(crate) fn hard_link_finding(path: &Path) -> Option<Finding> {
    let others =
        link_count(&std::fs::metadata(resolved(path)).ok()?).checked_sub(1).filter(|&others| others > 0)?;
    Some(hard_linked(path, others))
}

#[cfg(test)]
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
mod tests {
    use super::*;
    use crate::write::prepare_backup;

    const BYTES_READ: &[u8] = b"as it was read";
    const REPLACEMENT: &[u8] = b"the replacement of it";

    /// A model that was read, its backup and its replacement.
    fn prepare_file(folder: &Path) -> (PathBuf, ReplacementFile<'static>) {
        let target = folder.join("model.osim");
        std::fs::write(&target, BYTES_READ).unwrap();
        let (copy, kept) = prepare_backup(&target, BYTES_READ).unwrap();
        copy.unwrap().commit().unwrap();
        let prepared = PendingFile::new(&target, REPLACEMENT, None, WriteMode::InPlace).unwrap();
        let replacement = ReplacementFile {
            prepared,
            read_bytes: BYTES_READ,
            written_bytes: vec![b"the replacement", b" of it"],
            backup: Some(kept),
        };
        (target, replacement)
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
        let (target, replacement) = prepare_file(folder.path());
        // A program that has the model open, and saves late.
        let mut open = std::fs::File::options().append(true).open(&target).unwrap();
        replacement.replace_model().unwrap().finish();
        std::io::Write::write_all(&mut open, b" and saved late").unwrap();
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
        assert_eq!(read(folder.path(), "model.osim"), REPLACEMENT);
        assert_eq!(read(folder.path(), "model.osim.bak"), b"as it was read and saved late");
    }

    #[test]
    fn a_file_saved_before_the_exchange_stays() {
        let folder = tempfile::tempdir().unwrap();
        let (target, replacement) = prepare_file(folder.path());
        std::fs::write(&target, "saved").unwrap();
        let fault = replacement.replace_model().err().unwrap().to_string();
        assert!(fault.contains("another program changed") && fault.contains("model.osim.bak"), "{fault}");
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
        assert_eq!(read(folder.path(), "model.osim"), b"saved");
        assert_eq!(read(folder.path(), "model.osim.bak"), BYTES_READ);
    }

    /// The newest save of the other program keeps the model's name; the save before it becomes a further backup.
    #[test]
    fn a_file_saved_after_the_exchange_stays() {
        let folder = tempfile::tempdir().unwrap();
        let (target, replacement) = prepare_file(folder.path());
        let in_place = replacement.replace_model().unwrap();
        let displaced = in_place.displaced.as_ref().unwrap().path().to_owned();
        std::fs::write(&displaced, "saved first").unwrap();
        std::fs::write(folder.path().join("new"), "saved second").unwrap();
        std::fs::rename(folder.path().join("new"), &target).unwrap();
        let kept = in_place.put_back();
        let expected = target.with_file_name("model.osim.bak2");
        assert!(matches!(kept, UndoOutcome::Kept(kept) if kept == expected));
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak", "model.osim.bak2"]);
        assert_eq!(read(folder.path(), "model.osim"), b"saved second");
        assert_eq!(read(folder.path(), "model.osim.bak2"), b"saved first");
    }

    /// Leaves the displaced file on the disk, as a killed process does, and returns its path.
    fn kept_path(in_place: ExchangedModel<'_>) -> PathBuf {
        let path = in_place.displaced.as_ref().unwrap().path().to_owned();
        let name = path.file_name().unwrap().to_str().unwrap();
        assert!(name.starts_with("model.osim.replaced-"), "{name}");
        std::mem::forget(in_place);
        path
    }

    #[test]
    fn a_file_displaced_by_a_killed_run_becomes_a_backup() {
        for (saved, kept) in
            [(BYTES_READ, None), (b"saved".as_slice(), Some("model.osim.bak2")), (REPLACEMENT, None)]
        {
            let folder = tempfile::tempdir().unwrap();
            let (_, replacement) = prepare_file(folder.path());
            let left = kept_path(replacement.replace_model().unwrap());
            std::fs::write(&left, saved).unwrap();
            let expected = kept.map(|name| folder.path().join(name));
            assert_eq!(exchange::settle_leftover(&left), expected);
            let all: Vec<&str> = ["model.osim", "model.osim.bak"].into_iter().chain(kept).collect();
            assert_eq!(names(folder.path()), all);
            assert_eq!(read(folder.path(), "model.osim.bak"), BYTES_READ);
            assert!(kept.is_none_or(|name| read(folder.path(), name) == saved));
        }
    }

    #[test]
    fn a_model_with_a_very_long_name_is_changed_too() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join(format!("{}.osim", "\u{fc}".repeat(122)));
        std::fs::write(&target, BYTES_READ).unwrap();
        let prepared = PendingFile::new(&target, REPLACEMENT, None, WriteMode::InPlace).unwrap();
        let replacement = ReplacementFile {
            prepared,
            read_bytes: BYTES_READ,
            written_bytes: vec![REPLACEMENT],
            backup: None,
        };
        replacement.replace_model().unwrap().finish();
        assert_eq!(names(folder.path()).len(), 1);
        assert_eq!(std::fs::read(&target).unwrap(), REPLACEMENT);
    }

    /// The files are treated as on systems that cannot exchange them.
    #[test]
    fn old_bytes_are_written_again_where_files_cannot_be_exchanged() {
        for (saved, whole) in [(None, true), (Some("saved"), false)] {
            let folder = tempfile::tempdir().unwrap();
            let (target, replacement) = prepare_file(folder.path());
            let mut in_place = replacement.replace_model().unwrap();
            std::fs::remove_file(in_place.displaced.take().unwrap().path()).unwrap();
            if let Some(saved) = saved {
                std::fs::write(&target, saved).unwrap();
            }
            let undone = in_place.put_back();
            assert_eq!(undone.remark().is_none(), whole);
            assert!(undone.remark().is_none_or(|remark| remark.contains("model.osim.bak")));
            assert_eq!(read(folder.path(), "model.osim"), saved.map_or(BYTES_READ, str::as_bytes));
            assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
        }
    }

    #[test]
    fn a_model_that_is_gone_or_became_a_folder_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let (target, replacement) = prepare_file(folder.path());
        std::fs::remove_file(&target).unwrap();
        assert!(replacement.replace_model().err().unwrap().to_string().contains("no longer there"));
        assert_eq!(names(folder.path()), ["model.osim.bak"]);
        let folder = tempfile::tempdir().unwrap();
        let (target, replacement) = prepare_file(folder.path());
        std::fs::remove_file(&target).unwrap();
        std::fs::create_dir(&target).unwrap();
        assert!(replacement.replace_model().err().unwrap().to_string().contains("another program changed"));
        assert!(target.is_dir());
        assert_eq!(names(folder.path()), ["model.osim", "model.osim.bak"]);
    }

    #[test]
    fn bytes_in_several_parts_are_compared_as_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        std::fs::write(&path, "abc").unwrap();
        assert!(has_bytes(&path, &[b"a", b"", b"bc"]) && has_bytes(&path, &[b"abc"]));
        assert!(
            !has_bytes(&path, &[b"ab"])
                && !has_bytes(&path, &[b"abcd"])
                && !has_bytes(&path, &[b"abc", b"d"])
        );
        assert!(!has_bytes(&folder.path().join("b"), &[]));
    }
}
