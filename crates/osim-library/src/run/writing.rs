//! The bytes that a plan makes, and what is written of them.

use std::path::{Path, PathBuf};

use osim_model::files::OpenModel;
use osim_model::messages::{Input, phrase};
use osim_model::{Fault, FileId, Model};
use osim_patch::{Patch, Plan};

use crate::fault::LibraryFault;
use crate::folders::make_folder_of;
use crate::run::task::{Destination, Task};
use crate::source::{Origin, Stamp};
use crate::write::{InPlace, PendingFile, Successor, WriteMode, backup};

/// The bytes that a plan makes.
#[derive(Debug)]
pub struct ResultBytes<'m> {
    pub model: Patch<'m>,
    /// Of the geometry set that changes with a standalone force set.
    pub geometry: Option<GeometryResult<'m>>,
}

/// The changed bytes of a standalone geometry set.
#[derive(Debug)]
pub struct GeometryResult<'m> {
    /// Which of the model's files.
    pub file: FileId,
    pub path: PathBuf,
    pub patch: Patch<'m>,
}

impl<'m> ResultBytes<'m> {
    /// # Errors
    /// Edits that overlap, which would be a defect.
    pub(super) fn of(task: &Task, plan: &'m Plan, model: &'m Model) -> Result<Self, Fault> {
        let changed = plan.files(model).find(|&file| file != FileId::MAIN);
        let geometry = match (&task.geometry_output, changed) {
            (Some(path), Some(file)) => {
                Some(GeometryResult { file, path: path.clone(), patch: plan.patch(model, file)? })
            }
            _ => None,
        };
        Ok(Self { model: plan.patch(model, FileId::MAIN)?, geometry })
    }

    /// The new bytes of one of the files.
    fn parts(&self, file: FileId) -> Vec<&[u8]> {
        let geometry = self.geometry.as_ref().filter(|geometry| geometry.file == file);
        geometry.map_or(&self.model, |geometry| &geometry.patch).parts().collect()
    }
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Written {
    Nothing(&'static str),
    /// The model goes to standard output.
    Stdout,
    /// The model, then its geometry set; and the backups of both.
    Files {
        paths: Vec<PathBuf>,
        kept: Vec<PathBuf>,
    },
}

impl Written {
    pub fn describe(&self) -> String {
        match self {
            Self::Nothing(why) => (*why).to_owned(),
            Self::Stdout => "model written to standard output".to_owned(),
            Self::Files { paths, kept } => {
                let listed = |paths: &[PathBuf]| {
                    paths.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ")
                };
                let kept = if kept.is_empty() { String::new() } else { format!(" (old: {})", listed(kept)) };
                format!("written: {}{kept}", listed(paths))
            }
        }
    }

    pub fn paths(&self) -> &[PathBuf] {
        match self {
            Self::Files { paths, .. } => paths,
            Self::Nothing(_) | Self::Stdout => &[],
        }
    }
}

/// Files that are complete under temporary names.
pub(super) struct PreparedFiles<'w> {
    task: &'w Task,
    opened: &'w OpenModel,
    origin: &'w Origin,
    backups: Vec<PendingFile>,
    successors: Vec<(FileId, PendingFile)>,
    /// Where each of the successors' models is kept, in the same order.
    backed_up: Vec<Option<PathBuf>>,
    paths: Vec<PathBuf>,
    kept: Vec<PathBuf>,
}

impl<'w> PreparedFiles<'w> {
    /// Complete successors of everything that is written; `force` replaces what is there.
    ///
    /// # Errors
    /// Something is there that may not be replaced, or the disk is full.
    pub(super) fn new(
        task: &'w Task,
        opened: &'w OpenModel,
        origin: &'w Origin,
        results: &ResultBytes<'_>,
        force: bool,
    ) -> Result<Self, LibraryFault> {
        let mut files = Self {
            task,
            opened,
            origin,
            backups: vec![],
            successors: vec![],
            backed_up: vec![],
            paths: vec![],
            kept: vec![],
        };
        if let Some(path) = task.output() {
            origin.find_included_from(path)?;
            files.prepare(path, &results.model, FileId::MAIN, force)?;
        }
        if let Some(geometry) = &results.geometry {
            files.prepare(&geometry.path, &geometry.patch, geometry.file, force)?;
        }
        Ok(files)
    }

    /// A complete successor of `path`, made from one of the model's files.
    fn prepare(
        &mut self,
        path: &Path,
        patch: &Patch<'_>,
        file: FileId,
        force: bool,
    ) -> Result<(), LibraryFault> {
        let settings = &self.task.settings;
        let mut backed_up = None;
        if settings.in_place {
            self.refuse_protected(path)?;
            if !settings.no_backup {
                let bytes = self.opened.model.file(file).bytes();
                let (prepared, kept) = backup(path, bytes)
                    .map_err(|fault| fault.within("the backup could not be kept, so nothing was changed"))?;
                self.backups.extend(prepared);
                backed_up = Some(kept.clone());
                // As the model was named; behind a link, the backup is where the model really is.
                let beside = kept.file_name().filter(|_| !path.is_symlink());
                self.kept.push(beside.map(|name| path.with_file_name(name)).unwrap_or(kept));
            }
        }
        make_folder_of(path)?;
        let mode = match (settings.in_place, force) {
            (true, _) => WriteMode::InPlace,
            (false, true) => WriteMode::Replace,
            (false, false) => WriteMode::New,
        };
        let like = self.origin.stamp_of(file).map(Stamp::metadata);
        self.successors.push((file, PendingFile::of_parts(path, patch.parts(), like, mode)?));
        self.backed_up.push(backed_up);
        self.paths.push(path.to_owned());
        Ok(())
    }

    /// A write-protected model is not changed unless the user asks for it.
    fn refuse_protected(&self, path: &Path) -> Result<(), LibraryFault> {
        let protected = std::fs::metadata(path).is_ok_and(|metadata| metadata.permissions().readonly());
        if protected && !self.task.settings.force {
            return Err(LibraryFault::new(phrase![
                format!("{} is write-protected: change it all the same with ", path.display()),
                Input::Force,
            ]));
        }
        Ok(())
    }

    /// Gives all files their names.
    ///
    /// # Errors
    /// Somebody else changed the model in the meantime, or a folder cannot be changed.
    pub(super) fn commit(self, results: &ResultBytes<'_>) -> Result<Written, LibraryFault> {
        // Two files that belong together, and a file whose old contents are about to go: all on the disk first.
        let successors = || self.successors.iter().map(|(_, prepared)| prepared);
        if self.successors.len() > 1 || successors().any(PendingFile::replaces) {
            self.backups.iter().chain(successors()).try_for_each(PendingFile::sync)?;
        }
        if self.task.settings.in_place {
            let geometry = results.geometry.as_ref().map(|geometry| (geometry.file, geometry.path.as_path()));
            let model = (FileId::MAIN, self.task.source.path.as_path());
            for (file, path) in std::iter::once(model).chain(geometry) {
                self.origin.stamp_of(file).map_or(Ok(()), |stamp| stamp.still_holds(path))?;
            }
        }
        for backup in self.backups {
            backup.commit()?;
        }
        if self.task.settings.in_place {
            let successor =
                |((file, prepared), backup): ((FileId, PendingFile), Option<PathBuf>)| Successor {
                    prepared,
                    before: self.opened.model.file(file).bytes(),
                    after: results.parts(file),
                    backup,
                };
            take_places(self.successors.into_iter().zip(self.backed_up).map(successor))?;
        } else {
            for (_, prepared) in self.successors {
                prepared.commit()?;
            }
        }
        let to_stdout = self.task.destination == Destination::Stdout;
        let (paths, kept) = (self.paths, self.kept);
        Ok(if to_stdout { Written::Stdout } else { Written::Files { paths, kept } })
    }
}

/// Puts all successors into their places, or none: what was done is undone where one of them cannot.
fn take_places<'b>(successors: impl Iterator<Item = Successor<'b>>) -> Result<(), LibraryFault> {
    let mut done: Vec<InPlace<'b>> = Vec::new();
    for successor in successors {
        match successor.take_place() {
            Ok(in_place) => done.push(in_place),
            Err(fault) => {
                let remarks = done.into_iter().filter_map(|in_place| in_place.put_back().remark());
                return Err(remarks.fold(fault, LibraryFault::within));
            }
        }
    }
    done.into_iter().for_each(InPlace::settle);
    Ok(())
}
