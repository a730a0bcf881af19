//! One model: load, plan, write; and its outcome, ready to be reported in its turn.

use std::path::{Path, PathBuf};

use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_patch::Plan;
use osim_planning::BeforeAfter;
use osim_requests::options::RunOptions;

use crate::digest::{sha256, sha256_of_parts};
use crate::fault::LibraryFault;
use crate::folders::Folders;
use crate::run::journal::{Journal, Previous, PreviousRun};
use crate::run::record::{Record, Status};
use crate::run::request::{ChangedModel, Detail, FrontEnd};
use crate::run::task::{Destination, Task};
use crate::run::writing::{PreparedFiles, Results, Written};
use crate::source::{Disk, Loaded, Origin};
use crate::write::other_names;

/// How a run goes about its work, the same for all models.
pub(super) struct Context<'r> {
    pub(super) run: &'r RunOptions,
    pub(super) folders: Folders,
    pub(super) journal: Option<Journal>,
    pub(super) previous: PreviousRun,
}

/// The outcome for one model; `S` is what a front end shows of it.
#[derive(Debug)]
pub struct Outcome<S> {
    /// Its line in a summary.
    pub record: Record,
    /// Whether it was done by an earlier run.
    pub earlier: bool,
    /// What the front end shows of it; `None` if there is only the record.
    pub shown: Option<S>,
    /// What went wrong.
    pub failure: Option<Failure>,
}

impl<S> Outcome<S> {
    pub(super) fn not_begun(task: &Task) -> Self {
        Self { record: Record::of_task(task), earlier: false, shown: None, failure: None }
    }

    fn without_contacts(mut record: Record) -> Self {
        record.status = Status::NoContacts;
        Self { record, earlier: false, shown: None, failure: None }
    }

    pub(super) fn failed(failure: Failure, mut record: Record) -> Self {
        record.failed(&failure);
        Self { record, earlier: false, shown: None, failure: Some(failure) }
    }
}

/// How many models ended how.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counts {
    /// New files.
    pub written: usize,
    /// Nothing had to change.
    pub unchanged: usize,
    /// Planned only.
    pub dry: usize,
    /// Models of folders without contacts.
    pub no_contacts: usize,
    /// Something went wrong.
    pub failed: usize,
    /// The run was stopped before their turn.
    pub not_begun: usize,
    /// Done by an earlier run.
    pub earlier: usize,
}

impl Counts {
    pub(super) fn add<S>(&mut self, outcome: &Outcome<S>) {
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

    /// Whether the run was stopped.
    pub fn interrupted(&self) -> bool {
        self.not_begun > 0
    }
}

/// Does one model after the other.
pub(super) struct ModelJob<'j, F> {
    pub(super) context: &'j Context<'j>,
    pub(super) front_end: &'j F,
    pub(super) task: &'j Task,
}

impl<F: FrontEnd> ModelJob<'_, F> {
    /// Does this model. Whatever goes wrong is in the outcome.
    pub(super) fn run(&self) -> Outcome<F::Shown> {
        let mut record = Record::of_task(self.task);
        match self.attempt(&mut record) {
            Ok(outcome) => outcome,
            Err(failure) if self.task.source.is_skipped(&failure) => Outcome::without_contacts(record),
            Err(failure) => {
                let mut outcome = Outcome::failed(self.located(failure), record);
                self.context.previous.left_behind(&mut outcome.record);
                outcome
            }
        }
    }

    fn attempt(&self, record: &mut Record) -> Result<Outcome<F::Shown>, Failure> {
        let task = self.task;
        let detail = self.front_end.detail();
        let loaded = Loaded::read(&task.source, &task.settings.change.set_files)?;
        let mut force = task.settings.force;
        // A digest costs more than a plan: each is made once, for the journal and for the page.
        let wanted = self.context.journal.is_some() || detail != Detail::Result;
        let inputs = if wanted { loaded.digests() } else { Vec::new() };
        if let (Some(input), Some(_)) = (inputs.first(), &self.context.journal) {
            record.sha256_settings = Some(self.settings_digest(&inputs));
            if !self.context.previous.is_empty() {
                let previous = self.context.previous.of(task, input, record);
                match previous.map_err(|fault| fault.of_model(loaded.files.name().clone(), "output"))? {
                    Previous::Holds(record) => {
                        let shown = self.show_again(loaded, &record, detail, &inputs);
                        return Ok(Outcome { record: *record, earlier: true, shown, failure: None });
                    }
                    Previous::Outdated => force = true,
                    Previous::Changed if !force => {
                        let fault = LibraryFault::changed_before();
                        return Err(fault.of_model(loaded.files.name().clone(), "output"));
                    }
                    Previous::Edited(path) if !force && !self.context.run.dry_run => {
                        let fault = LibraryFault::edited(&path);
                        return Err(fault.of_model(loaded.files.name().clone(), "output"));
                    }
                    Previous::Edited(_) | Previous::Changed | Previous::Unknown => {}
                }
            }
        }
        record.sha256_input = inputs.first().cloned();
        let Loaded { files, origin } = loaded;
        // The files are read once more as they will be, only if that is wanted. The model's own bytes will be others.
        let kept = (detail != Detail::Result).then(|| files.with_bytes(Vec::new()));
        let opened = files.open()?;
        let plan = self.plan(&opened, record)?;
        let results = Results::of(task, &plan, &opened.model).map_err(|fault| opened.failure(fault))?;
        let before_after = self.before_after(kept.as_ref(), &opened, &plan, &results, detail)?;
        let written = self
            .write(&opened, &origin, &plan, &results, force, record)
            .map_err(|fault| fault.of_model(opened.name(), "output"))?;
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
        Ok(Outcome { record: record.clone(), earlier: false, shown: Some(shown), failure: None })
    }

    /// A model that an earlier run has done, if details are wanted. `None` if it was changed itself: what it was before is gone.
    fn show_again(
        &self,
        loaded: Loaded,
        record: &Record,
        detail: Detail,
        inputs: &[String],
    ) -> Option<F::Shown> {
        let task = self.task;
        if task.settings.in_place || detail == Detail::Result {
            return None;
        }
        let kept = loaded.files.with_bytes(Vec::new());
        let opened = loaded.files.open().ok()?;
        let plan = self.plan(&opened, &mut record.clone()).ok()?;
        let results = Results::of(task, &plan, &opened.model).ok()?;
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
            written: &Written::Files { paths, kept: Vec::new() },
            record,
            before_after,
            earlier: true,
        }))
    }

    fn before_after(
        &self,
        files: Option<&ModelFiles>,
        opened: &OpenModel,
        plan: &Plan,
        results: &Results<'_>,
        detail: Detail,
    ) -> Result<Option<BeforeAfter>, Failure> {
        match (files, detail) {
            (Some(files), Detail::BeforeAfter { feet }) => {
                let (change, dialect) = (&self.task.settings.change, self.front_end.dialect());
                let changed = || changed(self.task, files, results);
                BeforeAfter::of(change, opened, plan, changed, dialect, feet).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Digest of everything the output follows from except the model, with the files that belong to it. `inputs` has the
    /// digests of all its files, the model first.
    fn settings_digest(&self, inputs: &[String]) -> String {
        let own = self.task.settings.digest();
        match inputs.get(1..) {
            Some(companions) if !companions.is_empty() => {
                let all: Vec<&str> =
                    std::iter::once(own).chain(companions.iter().map(String::as_str)).collect();
                sha256(all.join("\n").as_bytes())
            }
            _ => own.to_owned(),
        }
    }

    /// In a manifest, the row is what the user can fix.
    fn located(&self, mut failure: Failure) -> Failure {
        if let Some(row) = self.task.row {
            failure.message.push(format!(" (row {row})"));
        }
        self.task.settings.change.keep_ways_out(&mut failure.message);
        failure.message.spell(self.front_end.dialect());
        failure
    }

    fn plan(&self, opened: &OpenModel, record: &mut Record) -> Result<Plan, Failure> {
        let settings = &self.task.settings;
        let mut plan = settings.change.plan(opened, &Disk)?;
        let compiled = self.task.output().and_then(|path| self.context.folders.compiled_beside(path));
        plan.warnings.extend(compiled);
        let linked = self.task.output().filter(|_| settings.in_place).and_then(other_names);
        plan.warnings.extend(linked);
        plan.spell(self.front_end.dialect());
        record.planned(&plan);
        Ok(plan)
    }

    /// Writes what is to be written; where it went.
    fn write(
        &self,
        opened: &OpenModel,
        origin: &Origin,
        plan: &Plan,
        results: &Results<'_>,
        force: bool,
        record: &mut Record,
    ) -> Result<Written, LibraryFault> {
        if self.context.run.dry_run {
            record.status = Status::DryRun;
            self.context.previous.keep_digests(record);
            return Ok(Written::Nothing("dry run: nothing written"));
        }
        let to_stdout = self.task.destination == Destination::Stdout;
        if plan.is_empty() && !self.task.asked && !to_stdout {
            record.status = Status::Unchanged;
            return Ok(Written::Nothing("nothing written"));
        }
        record.status = Status::Written;
        let files = PreparedFiles::new(self.task, opened, origin, results, force)?;
        if self.context.journal.is_some() || self.context.run.report.is_some() {
            record.sha256_output = Some(sha256_of_parts(results.model.parts()));
            let geometry = results.geometry.as_ref();
            record.sha256_geometry_output = geometry.map(|geometry| sha256_of_parts(geometry.patch.parts()));
        }
        if let Some(journal) = self.context.journal.as_ref().filter(|_| !to_stdout) {
            journal.about_to_finish(record)?;
        }
        files.commit(results)
    }
}

/// The model as it will be, with the geometry set that goes with it.
pub(super) fn changed(task: &Task, files: &ModelFiles, results: &Results<'_>) -> ModelFiles {
    let mut changed = files.with_bytes(results.model.to_vec());
    if let Some(path) = task.output() {
        changed = changed.with_name(path.display().to_string());
    }
    if let Some(geometry) = &results.geometry {
        changed.replace_companion(geometry.file, geometry.patch.to_vec());
    }
    changed
}
