//! Writes the new bytes of models and geometry sets that a planned change makes.

use std::path::{Path, PathBuf};

use osim_model::files::OpenModel;
use osim_model::messages::{Input, phrase};
use osim_model::{Fault, FileId, Model};
use osim_patch::{Patch, Plan};

use crate::run::task::{ResultDestination, Task};
use crate::write::{ExchangedModel, PendingFile, ReplacementFile, WriteMode, prepare_backup};
use crate::{LibraryFault, ModelOrigin, Result, make_folder_of};

/// The new bytes of the files that a planned change affects.
pub struct ResultBytes<'m> {
    pub model: Patch<'m>,
    /// The geometry set that changes with a standalone force set.
    pub geometry: Option<GeometryResult<'m>>,
}

/// The changed bytes of a standalone geometry set.
pub struct GeometryResult<'m> {
    pub file: FileId,
    pub path: PathBuf,
    pub patch: Patch<'m>,
}

impl<'m> ResultBytes<'m> {
    /// The new bytes of the model, and of its geometry set if the task changes it.
    ///
    /// # Errors
    /// Edits overlap, which is a defect of this program.
    pub(super) fn of_task(task: &Task, plan: &'m Plan, model: &'m Model) -> Result<Self, Fault> {
        let changed = plan.files(model).find(|&file| file != FileId::MAIN);
        let geometry = match (&task.geometry_output, changed) {
            (Some(path), Some(file)) => {
                Some(GeometryResult { file, path: path.clone(), patch: plan.patch(model, file)? })
            }
            _ => None,
        };
        Ok(Self { model: plan.patch(model, FileId::MAIN)?, geometry })
    }

    /// The new bytes of one of the model's files.
    fn parts_of(&self, file: FileId) -> Vec<&[u8]> {
        let geometry = self.geometry.as_ref().filter(|geometry| geometry.file == file);
        geometry.map_or(&self.model, |geometry| &geometry.patch).parts().collect()
    }
}

/// What was written for one model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum WrittenOutput {
    /// No file was written, for this reason.
    Nothing(&'static str),
    /// The model was written to standard output.
    Stdout,
    /// The paths of the model and of its geometry set, if that was written, too; and their backups.
    Files { paths: Vec<PathBuf>, kept: Vec<PathBuf> },
}

impl WrittenOutput {
    /// A sentence about the written files.
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

    /// The written files; none if the model went to standard output.
    pub fn paths(&self) -> &[PathBuf] {
        match self {
            Self::Files { paths, .. } => paths,
            Self::Nothing(_) | Self::Stdout => &[],
        }
    }
}

/// The output files of a model, complete but still under temporary names.
pub(super) struct PreparedFiles<'w> {
    task: &'w Task,
    opened: &'w OpenModel,
    origin: &'w ModelOrigin,
    backups: Vec<PendingFile>,
    /// Each new file, and the backup of the old one.
    replacements: Vec<(FileId, PendingFile, Option<PathBuf>)>,
    paths: Vec<PathBuf>,
    backups_of_user: Vec<PathBuf>,
}

impl<'w> PreparedFiles<'w> {
    /// Prepares all outputs of a task; `mode` says how they are written, if not in place.
    ///
    /// # Errors
    /// A file exists that may not be replaced, or the disk is full.
    pub(super) fn new(
        task: &'w Task,
        opened: &'w OpenModel,
        origin: &'w ModelOrigin,
        results: &ResultBytes<'_>,
        mode: WriteMode,
    ) -> Result<Self> {
        let mut files = Self {
            task,
            opened,
            origin,
            backups: vec![],
            replacements: vec![],
            paths: vec![],
            backups_of_user: vec![],
        };
        if let Some(path) = task.output() {
            origin.refuse_output_without_includes(path)?;
            files.prepare_file(path, &results.model, FileId::MAIN, mode)?;
        }
        if let Some(geometry) = &results.geometry {
            files.prepare_file(&geometry.path, &geometry.patch, geometry.file, mode)?;
        }
        Ok(files)
    }

    /// Prepares the new file at `path`, which is made from one of the model's files.
    fn prepare_file(&mut self, path: &Path, patch: &Patch<'_>, file: FileId, mode: WriteMode) -> Result<()> {
        let settings = &self.task.settings;
        let mut backup = None;
        if settings.in_place {
            self.refuse_write_protected(path)?;
            if !settings.no_backup {
                let bytes = self.opened.model.file(file).bytes();
                let (prepared, backups_of_user) = prepare_backup(path, bytes).map_err(|fault| {
                    fault.with_context("the backup could not be kept, so nothing was changed")
                })?;
                self.backups.extend(prepared);
                backup = Some(backups_of_user.clone());
                // The backup is shown beside the name that the user gave, unless that is a link.
                let beside = backups_of_user.file_name().filter(|_| !path.is_symlink());
                self.backups_of_user
                    .push(beside.map(|name| path.with_file_name(name)).unwrap_or(backups_of_user));
            }
        }
        make_folder_of(path)?;
        let mode = if settings.in_place { WriteMode::InPlace } else { mode };
        let like = self.origin.stamp_of(file);
        self.replacements.push((file, PendingFile::with_parts(path, patch.parts(), like, mode)?, backup));
        self.paths.push(path.to_owned());
        Ok(())
    }

    /// Refuses to change a write-protected model in place without `force`.
    fn refuse_write_protected(&self, path: &Path) -> Result<()> {
        let protected = std::fs::metadata(path).is_ok_and(|metadata| metadata.permissions().readonly());
        if protected && !self.task.settings.force {
            return Err(LibraryFault::new(phrase![
                format!("{} is write-protected: change it all the same with ", path.display()),
                Input::Force,
            ]));
        }
        Ok(())
    }

    /// Gives all prepared files their final names.
    ///
    /// # Errors
    /// Another program changed the model in the meantime, or a folder cannot be changed.
    pub(super) fn commit(self, results: &ResultBytes<'_>) -> Result<WrittenOutput> {
        // Bytes reach the disk before names change, if two files belong together or a file is replaced.
        let replacements = || self.replacements.iter().map(|(_, prepared, _)| prepared);
        if self.replacements.len() > 1 || replacements().any(PendingFile::replaces) {
            self.backups.iter().chain(replacements()).try_for_each(PendingFile::sync)?;
        }
        if self.task.settings.in_place {
            let geometry = results.geometry.as_ref().map(|geometry| (geometry.file, geometry.path.as_path()));
            let model = (FileId::MAIN, self.task.source.path.as_path());
            for (file, path) in std::iter::once(model).chain(geometry) {
                self.origin.refuse_if_changed(file, path)?;
            }
        }
        for backup in self.backups {
            backup.commit()?;
        }
        if self.task.settings.in_place {
            let replacement =
                |(file, prepared, backup): (FileId, PendingFile, Option<PathBuf>)| ReplacementFile {
                    prepared,
                    read_bytes: self.opened.model.file(file).bytes(),
                    written_bytes: results.parts_of(file),
                    backup,
                };
            exchange_all(self.replacements.into_iter().map(replacement))?;
        } else {
            for (_, prepared, _) in self.replacements {
                prepared.commit()?;
            }
        }
        Ok(match self.task.destination {
            ResultDestination::Stdout => WrittenOutput::Stdout,
            _ => WrittenOutput::Files { paths: self.paths, kept: self.backups_of_user },
        })
    }
}

/// Exchanges all new files with the old files of the same names. If one exchange fails, the earlier exchanges are undone.
fn exchange_all<'b>(replacements: impl Iterator<Item = ReplacementFile<'b>>) -> Result<()> {
    let mut done: Vec<ExchangedModel<'b>> = Vec::new();
    for replacement in replacements {
        match replacement.replace_model() {
            Ok(in_place) => done.push(in_place),
            Err(fault) => {
                let remarks = done.into_iter().filter_map(|in_place| in_place.put_back().remark());
                return Err(remarks.fold(fault, LibraryFault::with_context));
            }
        }
    }
    done.into_iter().for_each(ExchangedModel::finish);
    Ok(())
}
