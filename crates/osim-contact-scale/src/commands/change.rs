//! Runs the verbs that change models, shows each model's result, and reports the run in the end.

use std::path::Path;

use anyhow::{Context, Result, bail};
use osim_library::report_page::{ReportPage, Words, entry_of_change, entry_of_record};
use osim_library::run::{
    ChangedModel, CheckedRows, ModelDetail, ModelOutcome, OutcomeCounts, RowReader, Run, RunFrontEnd,
    RunRequest, Status, Task, WrittenOutput,
};
use osim_library::{Disk, folder_of};
use osim_model::files::{Failure, Files};
use osim_model::messages::{Call, Input, Phrase, Verb, listed, one_line, phrase};
use osim_model::{FileId, Severity};
use osim_planning::{PreparedChange, may_be_file, prepare};
use osim_requests::options::{InspectionOptions, RunFormat, RunOptions, SheetFormat};
use osim_requests::spell::FrontEnd;
use osim_requests::{BatchRequest, InspectRequest, Request, RequestError, RescaleRequest};
use osim_view::html::{DetailLevel, Entry};
use osim_view::report::json::{FailureRecord, PlanRecord, line};
use osim_view::report::plan;

use crate::commands::survey;
use crate::exit::{self, Exit};
use crate::one_call::{Session, end_page, typed_command_line};
use crate::suggestions::suggest;
use crate::terminal::Progress;

/// Makes a prepared change in all models that it names.
///
/// # Errors
/// Wrong usage.
pub(crate) fn change(change: PreparedChange, options: &RunOptions, session: &mut Session) -> Result<Exit> {
    let named = change.output.output.clone();
    let unusual = named.filter(|path| path.extension().is_none() && path.as_os_str() != "-");
    let request = RunRequest::for_change(change, options).map_err(|fault| session.file_error(&fault))?;
    if let Some(path) = unusual {
        let folder = session.words.input(Input::OutputDir, None);
        let text = format!("the name of a model ends in .osim; to write into a folder, say {folder}");
        session.terminal.print_to_stderr(&format!("warning: {}: {text}\n", path.display()))?;
    }
    run(request, options, session)
}

/// Runs a verb that changes models.
///
/// # Errors
/// Wrong usage.
pub(crate) fn change_models(request: Request, session: &mut Session) -> Result<Exit> {
    let options = request.run_options().cloned().unwrap_or_default();
    let prepared = prepare(request, &Disk).map_err(|error| session.refuse(error, options.is_json()))?;
    change(prepared, &options, session)
}

// `rescale`, and a model alone.

/// Rescales models. With `may_inspect` (no verb was typed), a model without options is only inspected.
///
/// # Errors
/// Wrong usage.
pub(crate) fn rescale(request: RescaleRequest, may_inspect: bool, session: &mut Session) -> Result<Exit> {
    // If there is a file of that name, it is a model; a name that was split at its blanks is another failure.
    let is_odd = request.models.iter().any(|path| !Disk.exists(path) && path.as_os_str() != "-");
    if is_odd && let Some(text) = suggest(&request.models, request.target_mass.is_none(), session.words) {
        bail!("{text} (see --help)");
    }
    if let Some(word) = request.models.iter().find(|path| !may_be_file(path, &Disk)).filter(|_| may_inspect) {
        bail!("'{}' is neither a verb nor a file (see --help)", word.display());
    }
    if request.target_mass.is_some() || !may_inspect || request.asks_for_change() {
        let missing = request.target_mass.is_none();
        let run = request.run.clone();
        return match prepare(request, &Disk) {
            Ok(prepared) => change(prepared, &run, session),
            Err(RequestError::Fault(fault)) if missing => {
                bail!("{}{}", fault.spelled(session.words), session.words.see_also())
            }
            Err(error) => Err(session.refuse(error, run.is_json())),
        };
    }
    // A model alone, perhaps dropped on the program: show something useful.
    let format = if request.run.is_json() { SheetFormat::Json } else { SheetFormat::Table };
    let mut inspect = InspectRequest { format, models: request.models, ..InspectRequest::default() };
    inspect.report.report = request.run.report;
    inspect.report.force = request.output.force;
    let mass = request.masses.mass.map(|kg| kg.to_string());
    let RescaleRequest { masses, choice, set_files, answers, .. } = request;
    inspect.options =
        InspectionOptions { masses, choice, set_files, answers, ..InspectionOptions::default() };
    let exit = survey::inspect(&inspect, true, session)?;
    if let Some(kg) = mass {
        let text: Phrase = phrase![
            "nothing was scaled: {} is what the model weighs; to scale its contacts, say {}";
            Input::Mass.with_value(kg.as_str()), Input::TargetMass.with_value(kg.as_str())
        ];
        session.terminal.remark(&text.spelled(session.words))?;
    }
    Ok(exit)
}

// One run of a changing verb: what is reported of it, and in which order.

/// Most models whose changes are shown in tables by default; each of more models gets only one line.
const MOST_MODELS_IN_TABLES: usize = 10;

/// Changes all models of `request`.
///
/// # Errors
/// Wrong usage: found before anything is written.
pub(crate) fn run(mut request: RunRequest, options: &RunOptions, session: &mut Session) -> Result<Exit> {
    request.start = session.start;
    let mut run = Run::new(request, options).map_err(|fault| session.file_error(&fault))?;
    let tasks = run.request.tasks.len();
    let several = tasks + run.request.failures.len() > 1;
    let few = if tasks > MOST_MODELS_IN_TABLES { RunFormat::Lines } else { RunFormat::Table };
    let format = options.format.unwrap_or(few);
    let mut exit = Exit::Done;
    for failure in &run.request.failures {
        let reported = session.report_failure(failure, format == RunFormat::Json);
        exit = exit.plus(reported.unwrap_or(Exit::Failed));
    }
    for remark in &run.request.remarks {
        session.terminal.remark(remark)?;
    }
    run.read_previous().map_err(|fault| session.file_error(&fault))?;
    let mut page = ReportPage::for_run(&run, options, typed_command_line(), session.words)
        .map_err(|fault| session.file_error(&fault))?;
    run.begin().map_err(|fault| session.file_error(&fault))?;
    for kept in &run.kept_files {
        // Also with `--quiet`: these files are somebody's work.
        session.terminal.error(&format!("remark: {}\n", one_line(kept.clone())));
    }
    let end = do_tasks(&run, options, format, &mut page, session)?;
    if let Err(fault) = run.finish() {
        session.terminal.error_line(&fault.spelled(session.words));
        exit = exit.plus(Exit::Failed);
    }
    exit = exit.plus(end_page(page, session));
    let RunEnd { counts, not_printed, worst, failed, skipped } = end;
    if options.deny.is_some_and(|deny| worst >= Some(deny.severity())) {
        exit = exit.plus(Exit::Failed);
    }
    if several {
        session.terminal.print_to_stderr(&last_line_of_run(&counts, options, session.words))?;
        for (what, names) in
            [("failed", failed), ("skipped", skipped)].iter().filter(|(_, names)| !names.is_empty())
        {
            session.terminal.remark(&format!("{what}: {}", listed(names, MOST_REPEATED_NAMES)))?;
        }
    } else if counts.interrupted() {
        session.terminal.print_to_stderr("stopped\n")?;
    }
    Ok(exit.plus(exit_of(&counts, not_printed)))
}

/// How a run of changes ended: the numbers of its models by outcome, the models that failed, and the worst finding.
struct RunEnd {
    counts: OutcomeCounts,
    /// Whether a result could not be printed.
    not_printed: bool,
    /// The severity of the worst finding in the results.
    worst: Option<Severity>,
    /// The names of the models that failed.
    failed: Vec<String>,
    /// The names of the models that were skipped.
    skipped: Vec<String>,
}

/// Does all tasks and reports each model in order.
fn do_tasks(
    run: &Run<'_>,
    options: &RunOptions,
    format: RunFormat,
    page: &mut Option<ReportPage>,
    session: &mut Session,
) -> Result<RunEnd> {
    let tasks = run.request.tasks.len();
    if tasks > 1 {
        exit::listen_for_stop_signals();
    }
    let printer = ResultPrinter {
        words: session.words,
        options,
        format,
        columns: session.terminal.columns(),
        detail: DetailLevel::for_models(tasks + run.request.failures.len()),
        progress: Progress::begin(tasks, options.quiet),
    };
    let (mut not_printed, mut worst) = (false, None);
    let mut failed: Vec<String> =
        run.request.failures.iter().map(|failure| failure.model.to_string()).collect();
    let mut skipped = Vec::new();
    let report = |_: &Task, outcome: ModelOutcome<Shown>| {
        let ModelOutcome { record, earlier, shown, failure, .. } = outcome;
        let Shown { outputs, entry, worst: worst_of_model } = shown.unwrap_or_default();
        worst = worst.max(worst_of_model);
        let row = record.row.map(|row| format!(" (row {row})")).unwrap_or_default();
        match record.status {
            Status::Failed => failed.push(format!("{}{row}", record.model)),
            Status::NoContacts => skipped.push(format!("{}{row}", record.model)),
            _ => {}
        }
        if let Some(page) = page {
            page.add(entry.unwrap_or_else(|| entry_of_record(&record, earlier)));
        }
        // Results that cannot be shown are no reason to leave the other models undone.
        let reported = printer.progress.suspended(|| match &failure {
            Some(failure) => session.report_failure(failure, format == RunFormat::Json).map(drop),
            None => print_outputs(&outputs, session),
        });
        if let Err(error) = reported {
            session.terminal.error_line(&format!("cannot write to standard output: {error:#}"));
            not_printed = true;
        }
    };
    let counts = run.do_tasks(&printer, report);
    printer.progress.end();
    let counts = counts.map_err(|fault| session.file_error(&fault))?;
    Ok(RunEnd { counts, not_printed, worst, failed, skipped })
}

/// Prints what there is to print about one model, on standard output or standard error.
fn print_outputs(all: &[Output], session: &mut Session) -> Result<()> {
    for output in all {
        match output {
            Output::Result(text) => session.terminal.print(text)?,
            Output::Record(text) => session.terminal.print_records(text)?,
            Output::Diff(text) => session.terminal.print_diff(text)?,
            Output::Model(bytes) => session.terminal.write_bytes(bytes)?,
            Output::Remark(text) => session.terminal.print_to_stderr(text)?,
            Output::UnbrokenRemark(text) => session.terminal.print_to_stderr_unbroken(text)?,
        }
    }
    Ok(())
}

/// The exit status of a run with these outcomes; `not_printed` says that a result could not be printed.
fn exit_of(counts: &OutcomeCounts, not_printed: bool) -> Exit {
    match (counts.interrupted(), counts.failed) {
        (true, _) => Exit::Interrupted,
        (false, 0) if !not_printed => Exit::Done,
        (false, _) => Exit::Failed,
    }
}

/// The last line of a run over several models.
fn last_line_of_run(counts: &OutcomeCounts, options: &RunOptions, words: Words) -> String {
    let parts = [
        (counts.written, "written"),
        (counts.dry, "planned (dry run)"),
        (counts.unchanged, "unchanged"),
        (counts.earlier, "done before"),
        (counts.no_contacts, "skipped (no contacts)"),
        (counts.failed, "failed"),
        (counts.not_begun, "not begun"),
    ];
    let all: usize = parts.iter().map(|(count, _)| count).sum();
    let parts: Vec<String> =
        parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    let stopped = match (counts.interrupted(), &options.summary) {
        (false, _) => String::new(),
        (true, Some(_)) => {
            format!("; stopped: to continue, repeat the command with {}", words.input(Input::Resume, None))
        }
        (true, None) => "; stopped".to_owned(),
    };
    let parts = if parts.is_empty() { "none done".to_owned() } else { parts.join(", ") };
    let models = if all == 1 { "model" } else { "models" };
    format!("remark: {all} {models}: {parts}{stopped}\n")
}

/// Most models whose names are repeated at the end of a run.
const MOST_REPEATED_NAMES: usize = 10;

// What is shown of a model that was changed, made on the thread that changed it.

/// What the command prints about one changed model.
#[derive(Default)]
pub(crate) struct Shown {
    pub outputs: Vec<Output>,
    /// The model's entry on the report page; `None` without a page.
    pub entry: Option<Entry>,
    /// The severity of the worst finding about the result.
    pub worst: Option<Severity>,
}

/// A text or model to print, with the stream and the form for it.
pub(crate) enum Output {
    /// A text for people, on standard output.
    Result(String),
    /// A record for programs, on standard output.
    Record(String),
    /// A diff for programs, on standard output with unbroken lines.
    Diff(String),
    /// A model, byte for byte on standard output.
    Model(Vec<u8>),
    /// A remark for people, on standard error.
    Remark(String),
    /// A remark with unbroken lines for programs, on standard error.
    UnbrokenRemark(String),
}

/// Makes the output about each model of a run.
pub(crate) struct ResultPrinter<'s> {
    pub words: Words,
    pub options: &'s RunOptions,
    pub format: RunFormat,
    /// Columns of the terminal; `None` if lines are not broken.
    pub columns: Option<usize>,
    /// How many details of each model the report page shows.
    pub detail: DetailLevel,
    pub progress: Progress,
}

impl RunFrontEnd for ResultPrinter<'_> {
    type Shown = Shown;

    fn dialect(&self) -> &dyn FrontEnd {
        // A front end's words are words for remedies, too.
        self.words
    }

    fn detail(&self) -> ModelDetail {
        match self.options.report {
            Some(_) => ModelDetail::BeforeAfter { feet: self.detail.has_feet() },
            None => ModelDetail::ResultOnly,
        }
    }

    fn show(&self, mut changed: ChangedModel<'_>) -> Shown {
        let both = changed.before_after.take();
        let entry = both.map(|both| entry_of_change(&changed, &both, self.detail, self.words));
        let outputs = if changed.earlier { Vec::new() } else { self.outputs(&changed) };
        let worst = changed.plan.findings.iter().map(|finding| finding.severity).max();
        Shown { outputs, entry, worst }
    }

    fn is_interrupted(&self) -> bool {
        exit::stop_is_requested()
    }

    fn task_done(&self, failed: bool) {
        self.progress.count_model(failed);
    }
}

impl ResultPrinter<'_> {
    fn outputs(&self, changed: &ChangedModel<'_>) -> Vec<Output> {
        let mut outputs = Vec::new();
        let to_stdout = matches!(changed.written, WrittenOutput::Stdout);
        if let Some(text) = self.text(changed) {
            outputs.push(match (to_stdout, self.format) {
                (true, RunFormat::Json) => Output::UnbrokenRemark(text),
                (true, _) => Output::Remark(text),
                (false, RunFormat::Json) => Output::Record(text),
                (false, _) => Output::Result(text),
            });
        }
        if self.options.diff {
            let text = diff_of_changed_files(changed);
            // With JSON on standard output, the diff would not be JSON.
            let aside = self.format == RunFormat::Json;
            outputs.push(if aside { Output::UnbrokenRemark(text) } else { Output::Diff(text) });
        }
        if to_stdout {
            outputs.push(Output::Model(changed.results.model.to_vec()));
        }
        outputs
    }

    /// The text about the changes of a model; `None` if the run reports only errors.
    fn text(&self, changed: &ChangedModel<'_>) -> Option<String> {
        let ChangedModel { plan, task, opened, written, .. } = changed;
        if self.format == RunFormat::Json {
            let mut paths = written.paths().iter().map(std::path::PathBuf::as_path);
            let (output, geometry) = (paths.next(), paths.next());
            return Some(line(&PlanRecord::new(plan, &opened.model, &task.source.path, output, geometry)));
        }
        if self.options.quiet {
            return None;
        }
        let (shown, result) = (opened.name(), written.describe());
        Some(match self.format {
            RunFormat::Lines => plan::line(plan, shown, &result),
            _ => plan::text(plan, shown, &result, self.columns),
        })
    }
}

/// The diff of all files of a model that change.
fn diff_of_changed_files(changed: &ChangedModel<'_>) -> String {
    let ChangedModel { task, opened, results, .. } = changed;
    let shown = opened.name();
    let target = task.output().map_or_else(|| shown.to_string(), |path| path.display().to_string());
    let bytes = |file: FileId| opened.model.file(file).bytes();
    let mut text = plan::unified_diff(bytes(FileId::MAIN), &results.model.to_vec(), shown, &target);
    if let Some(geometry) = &results.geometry {
        let name = opened.name_of(geometry.file);
        text.push_str(&plan::unified_diff(bytes(geometry.file), &geometry.patch.to_vec(), name, name));
    }
    text
}

// `batch`: a verb per row of a table.

/// Most wrong rows that are reported one by one; further wrong rows are only counted.
const MOST_REPORTED_ROWS: usize = 20;

/// Changes a model for each row of the table.
///
/// # Errors
/// The file cannot be read, or is not a table with a column `model`.
pub(crate) fn run_batch(request: &BatchRequest, session: &mut Session) -> Result<Exit> {
    let Some(manifest) = &request.manifest else { bail!("no table given") };
    let shown = manifest.display().to_string();
    if manifest.is_dir() {
        let call = Verb::Rescale.call_with_model().with_placeholder(Input::TargetMass, "KG");
        let call = call.with_placeholder(Input::OutputDir, "RESULTS");
        let call = session.words.command(&Call { files: vec![shown.clone()], ..call });
        bail!("'{shown}' is a folder, expected a table (.csv or .xlsx); its models go with '{call}'");
    }
    let reader = RowReader::new(request).map_err(|fault| session.file_error(&fault))?;
    let bytes = Disk.read(manifest).with_context(|| shown.clone())?;
    let from_stdin = manifest.as_os_str() == "-";
    let folder = if from_stdin { Path::new("") } else { folder_of(manifest) };
    match reader.read(&bytes, &shown, folder).map_err(|fault| session.file_error(&fault))? {
        CheckedRows::Run(rows) => run(rows, &request.run, session),
        CheckedRows::Invalid(wrong) => report_wrong_rows(&wrong, &shown, request.run.is_json(), session),
    }
}

/// Reports the wrong rows of a table, after which nothing is changed.
fn report_wrong_rows(wrong: &[Failure], shown: &str, json: bool, session: &mut Session) -> Result<Exit> {
    for failure in wrong.iter().filter(|_| json) {
        session.terminal.print_records(&line(&FailureRecord::new(failure, session.words)))?;
    }
    for failure in wrong.iter().take(MOST_REPORTED_ROWS) {
        let message = failure.message.spelled(session.words);
        session.terminal.error_line(&format!("{}: {message}", failure.model));
    }
    let more = wrong.len().saturating_sub(MOST_REPORTED_ROWS);
    let more = if more > 0 { format!(", {more} of them not shown") } else { String::new() };
    let rows = if wrong.len() == 1 { "1 row is".to_owned() } else { format!("{} rows are", wrong.len()) };
    session.terminal.error_line(&format!("{shown}: {rows} wrong{more}: nothing was written"));
    Ok(Exit::Usage)
}
