//! Loads, plans and writes one model of a run, and returns its outcome. A model whose change is planned may be written later.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use osim_model::FileId;
use osim_model::files::{Failure, Files, ModelFiles, OpenModel};
use osim_model::messages::{Input, phrase};
use osim_patch::Plan;
use osim_planning::{BeforeAfter, PreparedChange};
use osim_requests::options::{OutputOptions, RunOptions};
use osim_requests::spell::FrontEnd;

use crate::fault::Context;
use crate::file_access::{self, sha256, sha256_of_parts};
use crate::run::resume::{PreviousOutcome, PreviousRun};
use crate::run::summary::SummaryWriter;
use crate::run::task::JobSettings;
use crate::run::writing::{PreparedFiles, ResultBytes, WrittenOutput};
use crate::run::{
    ChangedModel, ModelDetail, Record, ResultDestination, RunFrontEnd, RunRequest, Status, Task,
};
use crate::write::{OutputFolders, WriteMode, hard_link_finding};
use crate::{Disk, LibraryFault, LoadedModel, ModelOrigin, ModelSource, Result};

/// Data that all models of a run share.
pub(super) struct RunContext<'r> {
    pub(super) run: &'r RunOptions,
    pub(super) folders: OutputFolders,
    pub(super) summary: Option<SummaryWriter>,
    pub(super) previous: PreviousRun,
    pub(super) start: SystemTime,
}

/// The outcome for one model. `S` is the type of the front end's text about the model.
pub struct ModelOutcome<S> {
    /// The model's line in a summary.
    pub record: Record,
    /// Whether an earlier run has changed the model.
    pub earlier: bool,
    /// The front end's text about the model; `None` if there is only the record.
    pub shown: Option<S>,
    /// Why the model could not be done.
    pub failure: Option<Failure>,
}

impl<S> ModelOutcome<S> {
    /// The outcome of a task that was not begun.
    pub(super) fn not_begun(task: &Task) -> Self {
        Self { record: Record::not_begun(task), earlier: false, shown: None, failure: None }
    }

    /// The outcome for a model of a folder that has no contacts.
    fn without_contacts(mut record: Record) -> Self {
        record.status = Status::NoContacts;
        Self { record, earlier: false, shown: None, failure: None }
    }

    /// The outcome for a model that failed.
    pub(super) fn failed(failure: Failure, mut record: Record) -> Self {
        record.add_failure(&failure);
        Self { record, earlier: false, shown: None, failure: Some(failure) }
    }
}

/// Numbers of models by their outcome.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct OutcomeCounts {
    pub written: usize,
    /// The number of models in which nothing had to change.
    pub unchanged: usize,
    /// The number of models whose change was only planned, in a dry run.
    pub dry: usize,
    /// The number of models without contacts that were found in folders.
    pub no_contacts: usize,
    pub failed: usize,
    /// The number of models that were not begun, because the run was stopped.
    pub not_begun: usize,
    /// The number of models that an earlier run has changed.
    pub earlier: usize,
}

impl OutcomeCounts {
    /// Counts the outcome of one more model.
    pub(super) fn add<S>(&mut self, outcome: &ModelOutcome<S>) {
        if outcome.earlier {
            self.earlier += 1;
            return;
        }
        let count = match outcome.record.status {
            Status::Written => &mut self.written,
            Status::Unchanged => &mut self.unchanged,
            Status::DryRun => &mut self.dry,
            Status::NoContacts => &mut self.no_contacts,
            Status::Failed => &mut self.failed,
            Status::NotBegun => &mut self.not_begun,
        };
        *count += 1;
    }

    /// Whether the run ended before all of its models.
    pub fn interrupted(&self) -> bool {
        self.not_begun > 0
    }
}

/// The work on one model of a run: open it, plan its change, and write the result.
pub(super) struct ModelJob<'j, F> {
    pub(super) context: &'j RunContext<'j>,
    pub(super) front_end: &'j F,
    pub(super) task: &'j Task,
}

impl<F: RunFrontEnd> ModelJob<'_, F> {
    /// Loads, plans and writes the model. A failure is part of the outcome.
    pub(super) fn run(&self) -> ModelOutcome<F::Shown> {
        let mut record = Record::not_begun(self.task);
        match self.try_to_run(&mut record) {
            Ok(outcome) => outcome,
            Err(failure) if self.task.source.is_skipped(&failure) => ModelOutcome::without_contacts(record),
            Err(failure) => {
                let mut outcome = ModelOutcome::failed(self.with_row_and_words(failure), record);
                self.context.previous.keep_earlier_output(&mut outcome.record);
                outcome
            }
        }
    }

    /// Loads, plans and writes the model, and completes its record.
    fn try_to_run(&self, record: &mut Record) -> Result<ModelOutcome<F::Shown>, Failure> {
        let task = self.task;
        let detail = self.front_end.detail();
        let loaded = LoadedModel::read(&task.source, &task.settings.change.set_files)?;
        let mut force = task.settings.force;
        // A digest takes longer than a plan: each is made once, for the summary and for the page.
        let wanted = self.context.summary.is_some() || detail != ModelDetail::ResultOnly;
        let inputs = if wanted { loaded.digests() } else { Vec::new() };
        if let ([input, companions @ ..], Some(_)) = (inputs.as_slice(), &self.context.summary) {
            record.sha256_settings = Some(self.settings_digest(companions));
            if !self.context.previous.is_empty() {
                let name = loaded.files.name().clone();
                let refused = |fault: LibraryFault| fault.into_failure(name.clone(), "output");
                match self.context.previous.compare(task, input, record).map_err(refused)? {
                    PreviousOutcome::UpToDate(record) => {
                        let shown = self.show_earlier(loaded, &record, detail, &inputs);
                        return Ok(ModelOutcome { record: *record, earlier: true, shown, failure: None });
                    }
                    PreviousOutcome::Outdated => force = true,
                    PreviousOutcome::ModelChanged if !force => {
                        // A factor would be applied twice.
                        return Err(refused(LibraryFault::new(phrase![
                            "an earlier run changed this model by other options, and this change would come on top of \
                             that: bring back what it was before, or change it once more with ",
                            Input::Force,
                        ])));
                    }
                    PreviousOutcome::OutputEdited(path) if !force && !self.context.run.dry_run => {
                        return Err(refused(LibraryFault::output_edited(&path)));
                    }
                    PreviousOutcome::OutputEdited(_)
                    | PreviousOutcome::ModelChanged
                    | PreviousOutcome::Unknown => {}
                }
            }
        }
        record.sha256_input = inputs.first().cloned();
        let LoadedModel { files, origin } = loaded;
        // The changed files are read again only if details are wanted.
        let kept = (detail != ModelDetail::ResultOnly).then(|| files.with_bytes(Vec::new()));
        let opened = files.open()?;
        let plan = self.plan(&opened, record)?;
        let results =
            ResultBytes::of_task(task, &plan, &opened.model).map_err(|fault| opened.failure(fault))?;
        let before_after = self.before_after(kept.as_ref(), &opened, &plan, &results, detail)?;
        let written = self
            .write(&opened, &origin, &plan, &results, force, record)
            .map_err(|fault| fault.into_failure(opened.name(), "output"))?;
        let shown = self.front_end.show(ChangedModel {
            task,
            opened: &opened,
            inputs: &inputs,
            plan: &plan,
            results: &results,
            written: &written,
            record,
            before_after,
            earlier: false,
        });
        Ok(ModelOutcome { record: record.clone(), earlier: false, shown: Some(shown), failure: None })
    }

    /// Plans and shows the change of a model that an earlier run has changed, if the front end wants details. `None` if the model was
    /// changed in place, because the old model is gone.
    fn show_earlier(
        &self,
        loaded: LoadedModel,
        record: &Record,
        detail: ModelDetail,
        inputs: &[String],
    ) -> Option<F::Shown> {
        let task = self.task;
        if task.settings.in_place || detail == ModelDetail::ResultOnly {
            return None;
        }
        let kept = loaded.files.with_bytes(Vec::new());
        let opened = loaded.files.open().ok()?;
        let plan = self.plan(&opened, &mut record.clone()).ok()?;
        let results = ResultBytes::of_task(task, &plan, &opened.model).ok()?;
        let before_after = self.before_after(Some(&kept), &opened, &plan, &results, detail).ok()?;
        let outputs = [task.output(), task.geometry_output.as_deref()].into_iter().flatten();
        let wrote = record.status == Status::Written;
        let paths: Vec<PathBuf> = outputs.filter(|_| wrote).map(Path::to_owned).collect();
        Some(self.front_end.show(ChangedModel {
            task,
            opened: &opened,
            inputs,
            plan: &plan,
            results: &results,
            written: &WrittenOutput::Files { paths, kept: Vec::new() },
            record,
            before_after,
            earlier: true,
        }))
    }

    /// The model before and after the change, if the front end wants both.
    fn before_after(
        &self,
        files: Option<&ModelFiles>,
        opened: &OpenModel,
        plan: &Plan,
        results: &ResultBytes<'_>,
        detail: ModelDetail,
    ) -> Result<Option<BeforeAfter>, Failure> {
        match (files, detail) {
            (Some(files), ModelDetail::BeforeAfter { feet }) => {
                let (change, dialect) = (&self.task.settings.change, self.front_end.dialect());
                let changed = || changed_files(self.task, files, results);
                BeforeAfter::of_plan(change, opened, plan, changed, dialect, feet).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Digest of the settings and of the files that belong to the model, but not of the model itself. `companions` are the digests of
    /// these files.
    fn settings_digest(&self, companions: &[String]) -> String {
        let own = self.task.settings.digest();
        if companions.is_empty() {
            return own.to_owned();
        }
        let all: Vec<&str> = std::iter::once(own).chain(companions.iter().map(String::as_str)).collect();
        sha256(all.join("\n").as_bytes())
    }

    /// The failure with the model's row in the manifest, spelled as the front end spells options.
    fn with_row_and_words(&self, mut failure: Failure) -> Failure {
        if let Some(row) = self.task.row {
            failure.message.push(format!(" (row {row})"));
        }
        self.task.settings.change.keep_ways_out(&mut failure.message);
        failure.message.spell(self.front_end.dialect());
        failure
    }

    /// Plans the change of the opened model, and adds it to its record.
    fn plan(&self, opened: &OpenModel, record: &mut Record) -> Result<Plan, Failure> {
        let settings = &self.task.settings;
        let mut plan = settings.change.plan(opened, &Disk)?;
        let compiled =
            self.task.output().and_then(|path| self.context.folders.compiled_model_beside_output(path));
        plan.findings.extend(compiled);
        let linked = self.task.output().filter(|_| settings.in_place).and_then(hard_link_finding);
        plan.findings.extend(linked);
        plan.spell(self.front_end.dialect());
        record.add_plan(&plan);
        Ok(plan)
    }

    /// Writes the results, unless it is a dry run or nothing changes.
    fn write(
        &self,
        opened: &OpenModel,
        origin: &ModelOrigin,
        plan: &Plan,
        results: &ResultBytes<'_>,
        force: bool,
        record: &mut Record,
    ) -> Result<WrittenOutput> {
        if self.context.run.dry_run {
            record.status = Status::DryRun;
            self.context.previous.keep_digests(record);
            return Ok(WrittenOutput::Nothing("dry run: nothing written"));
        }
        let to_stdout = self.task.destination == ResultDestination::Stdout;
        if plan.is_empty() && !self.task.output_is_named && !to_stdout {
            record.status = Status::Unchanged;
            return Ok(WrittenOutput::Nothing("nothing written"));
        }
        record.status = Status::Written;
        let mode = if force { WriteMode::Replace } else { WriteMode::NewSince(self.context.start) };
        let files = PreparedFiles::new(self.task, opened, origin, results, mode)?;
        if self.context.summary.is_some() || self.context.run.report.is_some() {
            record.sha256_output = Some(sha256_of_parts(results.model.parts()));
            let geometry = results.geometry.as_ref();
            record.sha256_geometry_output = geometry.map(|geometry| sha256_of_parts(geometry.patch.parts()));
        }
        if let Some(summary) = self.context.summary.as_ref().filter(|_| !to_stdout) {
            summary.about_to_finish(record)?;
        }
        files.commit(results)
    }
}

/// The files of the changed model, with the changed geometry set if the change concerns it.
pub(super) fn changed_files(task: &Task, files: &ModelFiles, results: &ResultBytes<'_>) -> ModelFiles {
    let mut changed = files.with_bytes(results.model.to_vec());
    if let Some(path) = task.output() {
        changed = changed.with_name(path.display().to_string());
    }
    if let Some(geometry) = &results.geometry {
        changed.replace_companion(geometry.file, geometry.patch.to_vec());
    }
    changed
}

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
        dialect: &dyn FrontEnd,
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
        dialect: &dyn FrontEnd,
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
    pub fn write(&self, output: &OutputOptions) -> Result<(WrittenOutput, Vec<String>)> {
        let task = self.task_for(output);
        if task.destination == ResultDestination::Stdout {
            let why = phrase!["this model cannot go to standard output: name a file with ", Input::Output];
            return Err(LibraryFault::new(why));
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
    fn check_unchanged(&self) -> Result<()> {
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
