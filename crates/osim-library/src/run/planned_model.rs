//! A model whose change is planned now and may be written later.

use std::path::Path;
use std::sync::Arc;

use osim_model::FileId;
use osim_model::files::{Failure, Files, ModelFiles, OpenModel};
use osim_model::messages::{Input, phrase};
use osim_patch::Plan;
use osim_planning::{BeforeAfter, PreparedChange};
use osim_requests::options::{OutputOptions, RunOptions};
use osim_requests::spell::Speller;

use crate::fault::{Context, LibraryFault};
use crate::run::model_job::changed_files;
use crate::run::task::{JobSettings, ResultDestination, Task};
use crate::run::writing::{PreparedFiles, ResultBytes, WrittenOutput};
use crate::run::{ChangedModel, Record, RunRequest, Status};
use crate::write::{OutputFolders, WriteMode, hard_link_finding};
use crate::{LoadedModel, ModelOrigin, ModelSource, file_access, sha256};

/// A model with the change that is planned for it, before anything is written.
pub struct PlannedModel {
    source: ModelSource,
    /// The files that belong to the model, without the bytes of the model itself.
    files: ModelFiles,
    pub opened: OpenModel,
    origin: ModelOrigin,
    pub plan: Plan,
    change: Arc<PreparedChange>,
}

impl PlannedModel {
    /// Plans `change` for the `loaded` model at `path`; `files` has the files beside the model. `dialect` spells messages of the plan.
    ///
    /// # Errors
    /// Those of [`PreparedChange::plan`].
    pub fn new(
        path: &Path,
        loaded: LoadedModel,
        change: PreparedChange,
        files: &dyn Files,
        dialect: &dyn Speller,
    ) -> Result<Self, Failure> {
        let LoadedModel { files: model, origin } = loaded;
        let kept = model.with_bytes(Vec::new());
        let opened = model.open()?;
        let mut plan = change.plan(&opened, files)?;
        plan.spell(dialect);
        let (source, change) = (ModelSource::file(path), Arc::new(change));
        Ok(Self { source, files: kept, opened, origin, plan, change })
    }

    /// The new bytes of each file that changes, the model first.
    ///
    /// # Errors
    /// Edits overlap, which is a defect of this program.
    pub fn results(&self) -> Result<Vec<(FileId, Vec<u8>)>, Failure> {
        let model = &self.opened.model;
        let bytes = |file| Ok((file, self.plan.patched(model, file)?));
        let all: Result<_, _> = self.plan.files(model).map(bytes).collect();
        all.map_err(|fault| self.opened.failure(fault))
    }

    /// Calls `show` with the model before and after the change, as a dry run does; `with_feet` says whether feet are included.
    ///
    /// # Errors
    /// The new model cannot be read, which is a defect of this program.
    pub fn show<T>(
        &self,
        dialect: &dyn Speller,
        with_feet: bool,
        show: impl FnOnce(ChangedModel<'_>) -> T,
    ) -> Result<T, Failure> {
        let task = self.task_for(&OutputOptions::default());
        let results = ResultBytes::of_task(&task, &self.plan, &self.opened.model)
            .map_err(|fault| self.opened.failure(fault))?;
        let new = || changed_files(&task, &self.files, &results);
        let states = BeforeAfter::of_plan(&self.change, &self.opened, &self.plan, new, dialect, with_feet)?;
        let mut record = Record { status: Status::DryRun, ..Record::not_begun(&task) };
        record.add_plan(&self.plan);
        let inputs: Vec<String> = self.opened.files().map(|(_, bytes)| sha256(bytes)).collect();
        Ok(show(ChangedModel {
            task: &task,
            opened: &self.opened,
            inputs: &inputs,
            plan: &self.plan,
            results: &results,
            written: &WrittenOutput::Nothing("planned: nothing written yet"),
            record: &record,
            before_after: Some(states),
            earlier: false,
        }))
    }

    /// Writes the changed model to `output`. Writes nothing if nothing changes and the user named no output. Also returns remarks
    /// about files beside the output.
    ///
    /// # Errors
    /// The output is standard output or one of the inputs; a file exists that may not be replaced; the change is in place, and the model
    /// changed since it was planned; or the disk refuses. Nothing is written in these cases.
    pub fn write(&self, output: &OutputOptions) -> Result<(WrittenOutput, Vec<String>), LibraryFault> {
        let task = self.task_for(output);
        if task.destination == ResultDestination::Stdout {
            return Err(LibraryFault::new(phrase![
                "this model cannot go to standard output: name a file with ",
                Input::Output,
            ]));
        }
        let from_memory = self.is_from_memory();
        let request = RunRequest { from_memory, ..RunRequest::new(self.change.verb, vec![task]) };
        request.check_paths(&RunOptions::default())?;
        let nothing = WrittenOutput::Nothing("nothing written");
        let Some(task) = request.tasks.first() else { return Ok((nothing, Vec::new())) };
        let outputs = task.output().into_iter().chain(task.geometry_output.as_deref());
        let mut folders = OutputFolders::list(outputs, true);
        let mut remarks = folders.keep_displaced_files();
        if self.plan.is_empty() && !task.output_is_named {
            return Ok((nothing, remarks));
        }
        let compiled = task.output().and_then(|path| folders.compiled_model_beside_output(path));
        let linked = task.output().filter(|_| output.in_place).and_then(hard_link_finding);
        remarks.extend(compiled.into_iter().chain(linked).map(|finding| finding.message.to_string()));
        if output.in_place {
            self.check_unchanged()?;
        }
        let results = ResultBytes::of_task(task, &self.plan, &self.opened.model)
            .map_err(|fault| LibraryFault::new(self.opened.failure(fault).message))?;
        let mode = if output.force { WriteMode::Replace } else { WriteMode::New };
        let files = PreparedFiles::new(task, &self.opened, &self.origin, &results, mode)?;
        Ok((files.commit(&results)?, remarks))
    }

    /// Whether the caller gave the bytes of the model, so that no file was read.
    fn is_from_memory(&self) -> bool {
        self.origin.stamp_of(FileId::MAIN).is_none()
    }

    /// Refuses a change in place of a model whose file changed after the change was planned.
    fn check_unchanged(&self) -> Result<(), LibraryFault> {
        if self.is_from_memory() && !self.source.path.exists() {
            return Err(LibraryFault::new(phrase![
                "this model came from memory, and has no file that could be changed: name a new one with ",
                Input::Output,
            ]));
        }
        let model = (FileId::MAIN, self.source.path.as_path());
        let geometry = self.change.set_files.geometry.as_deref();
        let geometry = geometry.and_then(|path| Some((self.origin.file_at(path)?, path)));
        std::iter::once(model).chain(geometry).try_for_each(|(file, path)| {
            let existing = file_access::read_ordinary(path).context(|| path.display())?;
            if existing == self.opened.model.file(file).bytes() {
                return Ok(());
            }
            if self.is_from_memory() {
                return Err(LibraryFault::new(phrase![
                    "this change was planned for a model in memory, and {} holds another one: write a new file with \
                    {}";
                    path.display().to_string(), Input::Output
                ]));
            }
            Err(LibraryFault::new(format!(
                "{} is not what it was when this change was planned, so nothing was written: plan again",
                path.display()
            )))
        })
    }

    /// The task that writes this model as the output options say.
    fn task_for(&self, output: &OutputOptions) -> Task {
        let settings = JobSettings::new(Arc::clone(&self.change), output);
        Task::new(self.source.clone(), output, Arc::new(settings))
    }
}
