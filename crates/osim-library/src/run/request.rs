//! The request of a run, and the trait of front ends that start a run.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use osim_model::files::{Failure, OpenModel};
use osim_model::messages::{Input, Verb, phrase};
use osim_patch::Plan;
use osim_planning::{BeforeAfter, PreparedChange};
use osim_requests::options::{OutputOptions, RunFormat, RunOptions};
use osim_requests::spell::FrontEnd;

use crate::paths::refuse_file_as_folder;
use crate::run::task::{JobSettings, PathConflicts, PathOwner, Task};
use crate::run::{Record, ResultBytes, WrittenOutput};
use crate::{LibraryFault, ModelSource, Result, Sources, folder_of, require_folder_of};

/// A request for one run: its tasks, and the models that could not be listed.
pub struct RunRequest {
    pub verb: Verb,
    /// One task for each model of the run.
    pub tasks: Vec<Task>,
    /// Models that could not be listed.
    pub failures: Vec<Failure>,
    /// Remarks for the user, reported before the first task.
    pub remarks: Vec<String>,
    /// Files that were read to find the tasks, such as a manifest.
    pub extra_files: Vec<PathBuf>,
    /// Whether an existing summary or report is replaced.
    pub force: bool,
    /// When the run, or the program that makes it, began.
    pub start: SystemTime,
    /// Whether the caller gave the bytes of the models. Then their names need not be names of files.
    pub(super) from_memory: bool,
}

impl RunRequest {
    /// A request with these tasks, without models that could not be listed.
    pub(super) fn new(verb: Verb, tasks: Vec<Task>) -> Self {
        Self {
            verb,
            tasks,
            failures: Vec::new(),
            remarks: Vec::new(),
            extra_files: Vec::new(),
            force: false,
            start: SystemTime::now(),
            from_memory: false,
        }
    }

    /// A request with a task for each file of `change` and each model in its folders.
    ///
    /// # Errors
    /// An option makes sense for one model only, and there are several models.
    pub fn for_change(mut change: PreparedChange, run: &RunOptions) -> Result<Self> {
        let sources = Sources::find(&change.models, change.output.output_dir.as_deref());
        change.is_for_several = sources.models.len() > 1;
        let change = Arc::new(change);
        let output = &change.output;
        check_options(&change.models, &sources, output, run)?;
        if change.set_files.geometry.is_some() && change.is_for_several {
            return Err(LibraryFault::new(phrase![
                Input::Geometry,
                " belongs to one ForceSet: change several in runs of their own",
            ]));
        }
        let settings = Arc::new(JobSettings::new(Arc::clone(&change), output));
        let task = |source: ModelSource| Task::new(source, output, Arc::clone(&settings));
        let tasks = sources.models.into_iter().map(task).collect();
        Ok(Self {
            failures: sources.failures,
            remarks: sources.remarks,
            force: output.force,
            ..Self::new(change.verb, tasks)
        })
    }

    /// Refuses to write a file that is read, to write a file twice, or to write beside the results into a folder that is not there.
    pub(super) fn check_paths(&self, run: &RunOptions) -> Result<()> {
        let mut conflicts = PathConflicts::default();
        self.extra_files.iter().for_each(|path| conflicts.add_input(path.as_path()));
        let mut checked_settings: Option<&Arc<JobSettings>> = None;
        for task in &self.tasks {
            // The name of a model from memory need not be the name of a file.
            if !(self.from_memory && task.source.path.symlink_metadata().is_err()) {
                conflicts.add_input_of_model(task.source.path.as_path());
            }
            // The files of settings are checked once for all of their models.
            if !checked_settings.is_some_and(|settings| Arc::ptr_eq(settings, &task.settings)) {
                // A reference is read before the first model, so a run over a folder may change it; a run over rows may not.
                task.settings.change.extra_files().for_each(|path| {
                    let path = path.as_path();
                    if task.row.is_some() {
                        conflicts.add_input_of_model(path);
                    } else {
                        conflicts.add_input(path);
                    }
                });
                checked_settings = Some(&task.settings);
            }
        }
        for task in &self.tasks {
            let owner = PathOwner::Model(&task.source.path, task.row);
            match task.output() {
                Some(path) if task.settings.in_place => conflicts.add_changed_in_place(path, owner)?,
                Some(path) => conflicts.add_output(path, owner)?,
                None => {}
            }
            match (&task.settings.change.set_files.geometry, &task.geometry_output) {
                (Some(_), Some(path)) if task.settings.in_place => {
                    conflicts.add_changed_in_place(path, owner)?;
                }
                (Some(geometry), Some(path)) => {
                    conflicts.add_output(path, PathOwner::Model(geometry, None))?;
                }
                _ => {}
            }
        }
        for (path, owner) in [(&run.report, "the report"), (&run.summary, "the summary")] {
            let Some(path) = path else { continue };
            require_folder_of(path, self.tasks.iter().filter_map(Task::output))?;
            conflicts.add_output(path, owner)?;
        }
        Ok(())
    }
}

/// Refuses options that do not go together, such as several models for one output.
fn check_options(named: &[PathBuf], found: &Sources, output: &OutputOptions, run: &RunOptions) -> Result<()> {
    let from_stdin = named.iter().any(|path| path.as_os_str() == "-");
    let to_stdout = output.output.as_deref() == Some(Path::new("-"))
        || (from_stdin && output.output.is_none() && output.output_dir.is_none());
    let to_stdout = to_stdout && !run.dry_run;
    let several = named.len() > 1 || found.models.len() > 1 || named.iter().any(|path| path.is_dir());
    let refused = |message| Err(LibraryFault::new(message));
    if output.output.is_some() && several {
        return refused(phrase![
            "{} is for one model: write several into a folder with {}";
            Input::Output, Input::OutputDir.with_placeholder("DIR")
        ]);
    }
    let is_file = |path: &&Path| path.as_os_str() != "-";
    let ends_folder = |path: &Path| path.to_string_lossy().ends_with(std::path::is_separator);
    let folder = |path| if ends_folder(path) { path } else { folder_of(path) };
    let folder = output.output.as_deref().filter(is_file).map(folder);
    folder.into_iter().chain(output.output_dir.as_deref()).try_for_each(refuse_file_as_folder)?;
    if let Some(folder) = folder
        && !folder.is_dir()
    {
        return refused(phrase![
            "the folder {} is not there: make it, or write with {}, which makes it";
            folder.display().to_string(), Input::OutputDir.with_placeholder("DIR")
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
            "the model goes to standard output: leave out {} and {}, or write it to a file with {}";
            Input::Diff, Input::Format.with_value("json"), Input::Output
        ]);
    }
    if output.in_place && from_stdin {
        return refused(phrase![Input::InPlace, " needs a file, standard input has none"]);
    }
    Ok(())
}

/// Details of each model that a front end needs besides the plan of its change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModelDetail {
    /// The front end gets only the new model.
    ResultOnly,
    /// Inspections and checks of the model before and after the change, perhaps with the feet.
    BeforeAfter { feet: bool },
}

/// A front end that starts a run. Threads of the run call its methods.
pub trait RunFrontEnd: Sync {
    /// Data of a model that the front end keeps until it is the model's turn to be shown.
    type Shown: Send;

    /// How the front end spells options in messages.
    fn dialect(&self) -> &dyn FrontEnd;

    /// Which details of each model the front end needs.
    fn detail(&self) -> ModelDetail;

    /// What the front end shows of a changed model.
    fn show(&self, changed: ChangedModel<'_>) -> Self::Shown;

    /// Whether no further model should be started.
    fn is_interrupted(&self) -> bool;

    /// Is called after each model of the run, for a progress bar; `failed` says whether the model failed.
    fn task_done(&self, failed: bool);
}

/// A changed model, with its plan, its new bytes and its line in the summary.
pub struct ChangedModel<'c> {
    pub task: &'c Task,
    pub opened: &'c OpenModel,
    /// SHA-256 of each file of the model, in order; empty if neither a summary nor details are wanted.
    pub inputs: &'c [String],
    pub plan: &'c Plan,
    pub results: &'c ResultBytes<'c>,
    pub written: &'c WrittenOutput,
    /// Line of the model in a summary.
    pub record: &'c Record,
    /// The model before and after the change, if the front end wants them.
    pub before_after: Option<BeforeAfter>,
    /// Whether an earlier run changed the model, so that this run wrote nothing.
    pub earlier: bool,
}
