//! `check` with `fix`: makes the changes that a check proposes for a model, checks the result and writes it.

use std::sync::Arc;

use osim_inspect::{CheckResult, Counts};
use osim_model::FileId;
use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_model::messages::{Input, counted, phrase};
use osim_patch::Patch;
use osim_planning::{Inspector, PreparedChange, prepare};
use osim_requests::options::{OutputOptions, RunOptions};
use osim_requests::{Request, RequestError};

use crate::run::request::RunRequest;
use crate::run::task::{JobSettings, ResultDestination, Task};
use crate::run::writing::{PreparedFiles, ResultBytes};
use crate::{Disk, LibraryFault, ModelOrigin, ModelSource, OutputFolders, WriteMode, require_folder_of};

/// How the sentence about a model begins that needs no change, or for which no change is known.
pub(crate) const NOTHING_WRITTEN: &str = "nothing written";

/// A model with its check, before the changes that the check proposes.
pub(crate) struct ModelToFix<'m> {
    pub(crate) source: &'m ModelSource,
    /// The model's files; the bytes of the model itself are not needed.
    pub(crate) files: ModelFiles,
    pub(crate) opened: &'m OpenModel,
    pub(crate) origin: &'m ModelOrigin,
    pub(crate) checked: CheckResult,
}

impl ModelToFix<'_> {
    /// Makes the changes that the check proposes, and writes the result. Returns the check of the result, and a sentence about the
    /// written file. If nothing is proposed, returns the check of the unchanged model.
    ///
    /// # Errors
    /// A proposed change is refused or needs an answer, or the result cannot be written. Nothing is written in these cases.
    pub(crate) fn fix(
        self,
        inspector: &Inspector,
        output: &OutputOptions,
    ) -> Result<(CheckResult, String), Failure> {
        let Some(first) = self.checked.steps.first() else {
            let why = match self.checked.counts.error + self.checked.counts.warning {
                0 => "there is nothing to correct",
                _ if self.checked.model == "-" => "standard input is read only once: name a file",
                _ => "no command corrects this",
            };
            return Ok((self.checked, format!("{NOTHING_WRITTEN}: {why}")));
        };
        let refused = |fault: LibraryFault| fault.into_failure(self.opened.name(), "output");
        let change = Arc::new(change_of_step(first, self.opened)?);
        let verb = change.verb;
        let task = Task::new(self.source.clone(), output, Arc::new(JobSettings::new(change, output)));
        let request = RunRequest::new(verb, vec![task]);
        request.check_paths(&RunOptions::default()).map_err(refused)?;
        output.output.as_deref().map_or(Ok(()), |path| require_folder_of(path, None)).map_err(refused)?;
        let task = request
            .tasks
            .first()
            .filter(|task| task.destination != ResultDestination::Stdout && task.geometry_output.is_none());
        let Some((task, path)) = task.and_then(|task| Some((task, task.output()?))) else {
            let why = phrase![
                Input::Fix,
                " writes one file for each model, and neither standalone sets nor standard output"
            ];
            return Err(refused(LibraryFault::new(why)));
        };
        let mut done: Option<(Vec<u8>, OpenModel)> = None;
        for step in &self.checked.steps {
            let current = done.as_ref().map_or(self.opened, |(_, opened)| opened);
            let plan = change_of_step(step, current)?.plan(current, &Disk)?;
            let new = plan.patched(&current.model, FileId::MAIN);
            let new = new.map_err(|fault| current.failure(fault))?;
            let opened = self.files.with_bytes(new.clone()).with_name(path.display().to_string()).open()?;
            done = Some((new, opened));
        }
        let Some((bytes, result)) = done else { return Ok((self.checked, String::new())) };
        let inspection = inspector.inspect(&result)?;
        let folders = OutputFolders::list(std::iter::once(path), false);
        let compiled = folders.compiled_model_beside_output(path);
        let judged = inspector.check(&result.model, &inspection, compiled.as_ref(), &Disk);
        let model = Patch::new(&bytes, Vec::new()).map_err(|fault| self.opened.failure(fault))?;
        let results = ResultBytes { model, geometry: None };
        let mode = if output.force { WriteMode::Replace } else { WriteMode::New };
        let files = PreparedFiles::new(task, self.opened, self.origin, &results, mode);
        let written = files.and_then(|files| files.commit(&results)).map_err(refused)?;
        let steps = counted(self.checked.steps.len(), "command");
        let before = Counts { remark: 0, ..self.checked.counts }.describe("no finding");
        Ok((judged, format!("{}; before: {before}; {steps} done", written.describe())))
    }
}

/// The change that one proposal of a check asks for.
fn change_of_step(step: &Request, opened: &OpenModel) -> Result<PreparedChange, Failure> {
    prepare(step.clone(), &Disk).map_err(|error| match error {
        RequestError::Failure(failure) => failure,
        RequestError::Fault(fault) => Failure::outside(opened.name().clone(), "internal", fault.phrase()),
    })
}
