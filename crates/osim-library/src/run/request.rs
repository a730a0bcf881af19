//! Everything that one run is to do, and who asks for it: what that wants of each model, and in whose words messages are.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Input, Verb, phrase};
use osim_patch::Plan;
use osim_planning::{BeforeAfter, Change};
use osim_requests::options::{OutputOptions, RunFormat, RunOptions};
use osim_requests::spell::Speller;

use crate::fault::LibraryFault;
use crate::run::record::Record;
use crate::run::task::{JobSettings, PathConflicts, PathOwner, Task};
use crate::run::writing::{Results, Written};
use crate::source::{Source, Sources};

/// What is to be done in one run.
pub struct RunRequest {
    /// What is done.
    pub verb: Verb,
    /// The models.
    pub tasks: Vec<Task>,
    /// What could not even be listed.
    pub failures: Vec<Failure>,
    /// Things to report before anything else.
    pub remarks: Vec<String>,
    /// Files that were read to know the tasks, such as a manifest.
    pub reads: Vec<PathBuf>,
    /// Whether an existing summary or report is replaced.
    pub force: bool,
    /// Whether the bytes of its models were given: then their names need not be those of files.
    pub(super) from_memory: bool,
}

impl RunRequest {
    /// These tasks, and nothing to report before them.
    pub(super) fn new(verb: Verb, tasks: Vec<Task>) -> Self {
        Self {
            verb,
            tasks,
            failures: Vec::new(),
            remarks: Vec::new(),
            reads: Vec::new(),
            force: false,
            from_memory: false,
        }
    }

    /// The tasks of one change: its files, and the models in its folders.
    ///
    /// # Errors
    /// What is asked for several models makes sense for one only.
    pub fn of_change(mut change: Change, run: &RunOptions) -> Result<Self, LibraryFault> {
        let sources = Sources::find(&change.models, change.output.output_dir.as_deref());
        change.is_for_several = sources.models.len() > 1;
        let change = Arc::new(change);
        let output = &change.output;
        check_usage(&change.models, &sources, output, run)?;
        if change.set_files.geometry.is_some() && change.is_for_several {
            return Err(LibraryFault::new(phrase![
                Input::Geometry,
                " belongs to one ForceSet: change several in runs of their own",
            ]));
        }
        let settings = Arc::new(JobSettings::new(Arc::clone(&change), output));
        let task = |source: Source| Task::new(source, output, Arc::clone(&settings));
        let tasks = sources.models.into_iter().map(task).collect();
        Ok(Self {
            failures: sources.failures,
            remarks: sources.remarks,
            force: output.force,
            ..Self::new(change.verb, tasks)
        })
    }

    /// Whether the run is about one model.
    pub fn is_one(&self) -> bool {
        self.tasks.len() + self.failures.len() == 1
    }

    /// Checks that nothing is written over what is read, and no file twice.
    pub(super) fn check_files(&self, run: &RunOptions) -> Result<(), LibraryFault> {
        let mut conflicts = PathConflicts::default();
        self.reads.iter().for_each(|path| conflicts.read(path.as_path()));
        let mut known: Option<&Arc<JobSettings>> = None;
        for task in &self.tasks {
            // The name of a model that came from memory need not be that of a file.
            if !(self.from_memory && task.source.path.symlink_metadata().is_err()) {
                conflicts.read_again(task.source.path.as_path());
            }
            // The files of settings are compared once for all of their models.
            if !known.is_some_and(|settings| Arc::ptr_eq(settings, &task.settings)) {
                // A reference is read before the first model, so a folder's run may change it; rows may not rely on that.
                task.settings.change.reads().for_each(|path| {
                    let path = path.as_path();
                    if task.row.is_some() { conflicts.read_again(path) } else { conflicts.read(path) }
                });
                known = Some(&task.settings);
            }
        }
        for task in &self.tasks {
            let owner = task.owner();
            match task.output() {
                Some(path) if task.settings.in_place => conflicts.change(path, owner)?,
                Some(path) => conflicts.write(path, owner)?,
                None => {}
            }
            match (&task.settings.change.set_files.geometry, &task.geometry_output) {
                (Some(_), Some(path)) if task.settings.in_place => conflicts.change(path, owner)?,
                (Some(geometry), Some(path)) => conflicts.write(path, PathOwner::Model(geometry, None))?,
                _ => {}
            }
        }
        if let Some(path) = &run.report {
            conflicts.write(path, "the report")?;
        }
        run.summary.as_ref().map_or(Ok(()), |path| conflicts.write(path, "the summary"))
    }
}

fn check_usage(
    named: &[PathBuf],
    sources: &Sources,
    output: &OutputOptions,
    run: &RunOptions,
) -> Result<(), LibraryFault> {
    let from_stdin = named.iter().any(|path| path.as_os_str() == "-");
    let to_stdout = output.output.as_deref() == Some(Path::new("-"))
        || (from_stdin && output.output.is_none() && output.output_dir.is_none());
    let to_stdout = to_stdout && !run.dry_run;
    let several = named.len() > 1 || sources.models.len() > 1 || named.iter().any(|path| path.is_dir());
    let refused = |message| Err(LibraryFault::new(message));
    if output.output.is_some() && several {
        return refused(phrase![
            Input::Output,
            " is for one model: write several into a folder with ",
            Input::OutputDir.with_placeholder("DIR"),
        ]);
    }
    if to_stdout && several {
        return refused(phrase![
            "one model goes to standard output: name it alone, or write several into a folder with ",
            Input::OutputDir.with_placeholder("DIR"),
        ]);
    }
    if to_stdout && (run.diff || run.format == Some(RunFormat::Json)) {
        return refused(phrase![
            "the model goes to standard output: leave out ",
            Input::Diff,
            " and ",
            Input::Format.with_value("json"),
            ", or write it to a file with ",
            Input::Output,
        ]);
    }
    if output.in_place && from_stdin {
        return refused(phrase![Input::InPlace, " needs a file, standard input has none"]);
    }
    Ok(())
}

/// What is wanted of a model beside its result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Detail {
    Result,
    /// Figures and findings of both states.
    BeforeAfter {
        /// Whether with the feet of both.
        feet: bool,
    },
}

/// The caller of a run. Its methods are called on the threads that do the work.
pub trait FrontEnd: Sync {
    /// What is kept of a model until its turn to be shown.
    type Shown: Send;

    /// The words of all messages.
    fn dialect(&self) -> &dyn Speller;

    /// What is wanted of each model.
    fn detail(&self) -> Detail;

    fn show(&self, changed: ChangedModel<'_>) -> Self::Shown;

    /// Whether no further model should be started.
    fn is_interrupted(&self) -> bool;

    /// One more model is done.
    fn done(&self, failed: bool);
}

/// A model that was changed, with everything about it.
pub struct ChangedModel<'c> {
    /// The model and where its result goes.
    pub task: &'c Task,
    pub opened: &'c OpenModel,
    /// SHA-256 of each of its files, in order; empty where neither a summary nor details are wanted.
    pub inputs: &'c [String],
    pub plan: &'c Plan,
    pub results: &'c Results<'c>,
    pub written: &'c Written,
    /// Its line in a summary.
    pub record: &'c Record,
    /// Both states, where they were wanted.
    pub before_after: Option<BeforeAfter>,
    /// Whether it was done by an earlier run: then nothing was written now.
    pub earlier: bool,
}
