//! A run, step by step: each step may refuse, and a front end reports between them.

use std::path::Path;

use osim_model::files::Failure;
use osim_requests::options::RunOptions;

use crate::fault::LibraryFault;
use crate::folders::Folders;
use crate::run::journal::{Journal, PreviousRun};
use crate::run::model_job::{Context, Counts, ModelJob, Outcome};
use crate::run::record::{Record, Status};
use crate::run::request::{FrontEnd, RunRequest};
use crate::run::task::Task;
use crate::workers::{in_order, threads};

/// A run that was checked: nothing is written yet.
pub struct Run<'r> {
    request: RunRequest,
    context: Context<'r>,
    /// Files of a run that was killed, which became backups.
    kept: Vec<String>,
}

impl<'r> Run<'r> {
    /// Compares all files of a run before anything is written, and takes the share of its models that is asked for.
    ///
    /// # Errors
    /// Something would be written over what is read, or twice.
    pub fn new(mut request: RunRequest, run: &'r RunOptions) -> Result<Self, LibraryFault> {
        request.check_files(run)?;
        if let Some(shard) = run.shard {
            request.tasks.retain(|task| match task.row {
                // A row of a manifest belongs to the share of its number.
                Some(row) => shard.has_number(row as u64),
                None => shard.has_name(task.source.below_folder()),
            });
        }
        let context =
            Context { run, folders: Folders::default(), journal: None, previous: PreviousRun::default() };
        Ok(Self { request, context, kept: Vec::new() })
    }

    pub fn request(&self) -> &RunRequest {
        &self.request
    }

    /// Reads what an earlier run did, if the run resumes it.
    pub fn read_previous(&mut self) -> Result<(), LibraryFault> {
        // All rows of a table have the same columns. A share without a model does not show them.
        let own = |task: &Task| task.remarks.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
        let own = self.request.tasks.first().map(own);
        self.context.previous = PreviousRun::read(self.context.run, own.as_deref())?;
        Ok(())
    }

    /// Whether the run resumes an earlier one.
    pub fn goes_on(&self) -> bool {
        !self.context.previous.is_empty()
    }

    /// Begins the summary, if one is asked for, and looks at the folders that are written into.
    ///
    /// # Errors
    /// The summary cannot be written, or is there already.
    pub fn begin(&mut self) -> Result<(), LibraryFault> {
        self.context.journal = Journal::begin(self.context.run, self.request.force)?;
        self.context.folders = self.folders();
        self.kept = self.context.folders.settle_replaced();
        if let Some(journal) = &self.context.journal {
            self.request.failures.iter().for_each(|failure| journal.add(&Record::of_failure(failure)));
        }
        Ok(())
    }

    /// Looks at every folder that the run writes into.
    fn folders(&self) -> Folders {
        let (tasks, run) = (&self.request.tasks, self.context.run);
        let models = tasks.iter().filter_map(Task::output);
        let geometry = tasks.iter().filter_map(|task| task.geometry_output.as_deref());
        let beside = [&run.summary, &run.report].into_iter().filter_map(|path| path.as_deref());
        Folders::list(models.chain(geometry).chain(beside), !run.dry_run)
    }

    /// Does all tasks on as many threads as there are processors; `report` gets each in the order of the tasks, on this thread.
    ///
    /// Every task is reported and has its line in the summary, also those that were not begun. A caller that wants to end a run
    /// early says so by [`FrontEnd::is_interrupted`]. So a run that was stopped can go on.
    ///
    /// # Errors
    /// Threads cannot be started.
    pub fn work_off<F: FrontEnd>(
        &self,
        front_end: &F,
        mut report: impl FnMut(&Task, Outcome<F::Shown>),
    ) -> Result<Counts, LibraryFault> {
        let tasks = &self.request.tasks;
        let indices: Vec<usize> = (0..tasks.len()).collect();
        let mut counts = Counts { failed: self.request.failures.len(), ..Counts::default() };
        let work = |&index: &usize| {
            let outcome = tasks.get(index).map(|task| self.one(front_end, task));
            let failed = outcome.as_ref().is_some_and(|outcome| outcome.record.status == Status::Failed);
            front_end.done(failed);
            outcome
        };
        let each = |&index: &usize, outcome: Option<Outcome<F::Shown>>| {
            if let (Some(task), Some(outcome)) = (tasks.get(index), outcome) {
                counts.add(&outcome);
                if let Some(journal) = &self.context.journal {
                    journal.add(&outcome.record);
                }
                report(task, outcome);
            }
            Ok::<(), LibraryFault>(())
        };
        in_order(&indices, threads(self.context.run.jobs, tasks.len()), work, each)?;
        Ok(counts)
    }

    fn one<F: FrontEnd>(&self, front_end: &F, task: &Task) -> Outcome<F::Shown> {
        if front_end.is_interrupted() {
            let mut outcome = Outcome::not_begun(task);
            self.context.previous.left_behind(&mut outcome.record);
            return outcome;
        }
        ModelJob { context: &self.context, front_end, task }.run()
    }

    /// Ends the summary, if one is asked for.
    pub fn finish(self) -> Result<(), LibraryFault> {
        let Context { journal, previous, .. } = self.context;
        journal.map_or(Ok(()), |journal| journal.finish(previous, &self.request.tasks))
    }

    /// What a run that was killed left of models that it changed themselves, if it had to be kept: a line for each.
    pub fn kept(&self) -> &[String] {
        &self.kept
    }

    /// What could not even be listed.
    pub fn failures(&self) -> &[Failure] {
        &self.request.failures
    }

    pub fn report(&self) -> Option<&Path> {
        self.context.run.report.as_deref()
    }
}
