//! One run of a verb that changes models: compare the paths of all models, then load, plan, write and report each model.
//!
//! A [`Task`] is one model with its `JobSettings`; tasks are independent of each other, so threads share them. What a task
//! did is an [`ModelOutcome`], reported in the order in which the models were named.

mod fix;
mod model_job;
mod record;
mod request;
mod resume;
mod rows;
mod summary;
mod summary_lines;
mod task;
mod writing;

use std::path::Path;

use osim_model::messages::{Input, phrase};
use osim_requests::options::RunOptions;

use crate::fault::{LibraryFault, Result};
use crate::run::model_job::{ModelJob, RunContext};
use crate::run::resume::PreviousRun;
use crate::run::summary::SummaryWriter;
use crate::workers::{thread_count, work_in_order};
use crate::write::{OutputFolders, WriteMode};

pub(crate) use fix::{ModelToFix, NOTHING_WRITTEN};
pub use model_job::{ModelOutcome, OutcomeCounts, PlannedModel};
pub use record::{JsonRecord, Record, Status};
pub use request::{ChangedModel, ModelDetail, RunFrontEnd, RunRequest};
pub use rows::{CheckedRows, RowReader};
pub use task::{PathConflicts, PathOwner, ResultDestination, Task};
pub use writing::{GeometryResult, ResultBytes, WrittenOutput};

/// A run over models whose paths were compared: no two tasks write the same file.
pub struct Run<'r> {
    pub request: RunRequest,
    context: RunContext<'r>,
    /// Sentences about files that a killed run in place left, and that this run kept as backups.
    pub kept_files: Vec<String>,
}

impl<'r> Run<'r> {
    /// Compares all paths of a run before anything is written. If several computers share the run, keeps only the tasks of this one's
    /// shard.
    ///
    /// # Errors
    /// A file would be written that is also read, or that is written for another model.
    pub fn new(mut request: RunRequest, run: &'r RunOptions) -> Result<Self> {
        request.check_paths(run)?;
        if let Some(shard) = run.shard {
            request.tasks.retain(|task| match task.row {
                // A row of a manifest belongs to the shard of its number.
                Some(row) => shard.has_number(row as u64),
                None => shard.has_name(task.source.below_folder()),
            });
        }
        let (folders, previous) = (OutputFolders::default(), PreviousRun::default());
        let context = RunContext { run, folders, summary: None, previous, start: request.start };
        Ok(Self { request, context, kept_files: Vec::new() })
    }

    /// Reads the summary of an earlier run, if this run resumes it.
    pub fn read_previous(&mut self) -> Result<()> {
        // All rows of a table have the same columns. They are not known if the shard has no row.
        let column_names =
            |task: &Task| task.user_columns.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
        let column_names = self.request.tasks.first().map(column_names);
        self.context.previous = PreviousRun::read(self.context.run, column_names.as_deref())?;
        Ok(())
    }

    /// Whether the run resumes an earlier one.
    pub fn is_resumed(&self) -> bool {
        !self.context.previous.is_empty()
    }

    /// Begins the summary, if the options name one, and lists the folders that the run writes into.
    ///
    /// # Errors
    /// Several results exist already; or the summary cannot be written, or exists already.
    pub fn begin(&mut self) -> Result<()> {
        self.refuse_existing_results()?;
        self.context.summary = SummaryWriter::begin(self.context.run, self.request.force)?;
        // Another run that wrote the same summary may have ended since it was read.
        self.read_previous()?;
        self.context.folders = self.list_folders();
        self.kept_files = self.context.folders.keep_displaced_files();
        if let Some(summary) = &self.context.summary {
            self.request.failures.iter().for_each(|failure| summary.add_model(&Record::of_failure(failure)));
        }
        Ok(())
    }

    /// Refuses the whole run if several of its results exist already and may not be replaced.
    fn refuse_existing_results(&self) -> Result<()> {
        let RunOptions { dry_run, resume, .. } = *self.context.run;
        let is_new =
            |task: &&Task| matches!(task.destination, ResultDestination::File(_)) && !task.settings.force;
        let results = self.request.tasks.iter().filter(|_| !dry_run && !resume).filter(is_new);
        let mode = WriteMode::NewSince(self.context.start);
        let stays = |path: &&Path| path.metadata().is_ok_and(|existing| !mode.is_of_other_run(&existing));
        let existing: Vec<&Path> = results.filter_map(Task::output).filter(stays).collect();
        let summary = Input::Summary.with_placeholder("FILE");
        let resume = phrase![summary, " ", Input::Resume, " with the FILE that it kept"];
        LibraryFault::refuse_existing(&existing, self.request.tasks.len(), Some(&resume))
    }

    /// Lists every folder that the run writes into.
    fn list_folders(&self) -> OutputFolders {
        let (tasks, run) = (&self.request.tasks, self.context.run);
        let models = tasks.iter().filter_map(Task::output);
        let geometry = tasks.iter().filter_map(|task| task.geometry_output.as_deref());
        let beside = [&run.summary, &run.report].into_iter().filter_map(|path| path.as_deref());
        OutputFolders::list(models.chain(geometry).chain(beside), !run.dry_run)
    }

    /// Does all tasks on several threads; `report` gets each outcome in the order of the tasks, on this thread.
    ///
    /// Every task is reported and has a line in the summary, also tasks that were not begun: so a stopped run can be resumed. A caller
    /// stops a run by [`RunFrontEnd::is_interrupted`].
    ///
    /// # Errors
    /// Threads cannot be started.
    pub fn do_tasks<F: RunFrontEnd>(
        &self,
        front_end: &F,
        mut report: impl FnMut(&Task, ModelOutcome<F::Shown>),
    ) -> Result<OutcomeCounts> {
        let tasks = &self.request.tasks;
        let indices: Vec<usize> = (0..tasks.len()).collect();
        let mut counts = OutcomeCounts { failed: self.request.failures.len(), ..OutcomeCounts::default() };
        let work = |&index: &usize| {
            let outcome = tasks.get(index).map(|task| self.do_task(front_end, task));
            let failed = outcome.as_ref().is_some_and(|outcome| outcome.record.status == Status::Failed);
            front_end.task_done(failed);
            outcome
        };
        let each = |&index: &usize, outcome: Option<ModelOutcome<F::Shown>>| {
            if let (Some(task), Some(outcome)) = (tasks.get(index), outcome) {
                counts.add(&outcome);
                if let Some(summary) = &self.context.summary {
                    summary.add_model(&outcome.record);
                }
                report(task, outcome);
            }
            Ok::<(), LibraryFault>(())
        };
        work_in_order(&indices, thread_count(self.context.run.jobs, tasks.len()), work, each)?;
        Ok(counts)
    }

    /// Does one task, unless the run is interrupted.
    fn do_task<F: RunFrontEnd>(&self, front_end: &F, task: &Task) -> ModelOutcome<F::Shown> {
        if front_end.is_interrupted() {
            let mut outcome = ModelOutcome::not_begun(task);
            self.context.previous.keep_earlier_output(&mut outcome.record);
            return outcome;
        }
        ModelJob { context: &self.context, front_end, task }.run()
    }

    /// Completes the summary, if the options name one.
    pub fn finish(self) -> Result<()> {
        let RunContext { summary, previous, .. } = self.context;
        summary.map_or(Ok(()), |summary| summary.finish(previous, &self.request.tasks))
    }

    pub fn report(&self) -> Option<&Path> {
        self.context.run.report.as_deref()
    }
}
