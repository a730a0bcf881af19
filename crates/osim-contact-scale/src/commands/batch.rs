//! `batch`: a verb per row of a table.
//!
//! All rows are read before the first file is written, and everything wrong is reported at once.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use anyhow::{Context, Result, bail};
use osim_library::run::{Inside, JobSettings, RunRequest, Task};
use osim_library::{Disk, OrdinaryFiles, Source, folder_of};
use osim_model::files::{Failure, Files};
use osim_model::wording::Input;
use osim_report::json::{FailureRecord, line};
use osim_requests::options::OutputOptions;
use osim_requests::{BatchRequest, RowFault, RowRequest, Table};

use super::run;
use crate::session::Session;
use crate::terminal::Exit;

/// Rows that are wrong are reported one by one up to this number, then counted.
const REPORTED: usize = 20;

/// Rows that only differ in model and output share what is to be done.
type Known = HashMap<String, Arc<JobSettings>>;

/// Does all rows of the table.
///
/// # Errors
/// It cannot be read, or is not a table with a column `model`.
pub(super) fn run(request: &BatchRequest, session: &mut Session) -> Result<Exit> {
    let Some(manifest) = &request.manifest else { bail!("no manifest given") };
    let shown = manifest.display().to_string();
    let words = session.words;
    if request.output.output.is_some() || request.output.geometry_output.is_some() {
        bail!(
            "{} is for one model: give the rows a column 'output', or write all into a folder with {} DIR",
            words.input(Input::Output, None),
            words.input(Input::OutputDir, None)
        );
    }
    let bytes = Disk.read(manifest).with_context(|| shown.clone())?;
    let from_stdin = manifest.as_os_str() == "-";
    let folder = if from_stdin { Path::new("") } else { folder_of(manifest) };
    // `.` in front of every path would only be in the way.
    let folder = if folder == Path::new(".") { Path::new("") } else { folder };
    let table = Table::read(&bytes, folder)
        .map_err(|message| anyhow::anyhow!(message.spelled(words)))
        .with_context(|| shown.clone())?
        .answering(request.answers.yes.clone());
    let inside = Inside::of(request.output.output_dir.as_deref().unwrap_or(folder));
    let inside = Some((inside, &request.output)).filter(|_| !request.allow_outside);
    let (mut tasks, mut wrong, mut known) = (Vec::new(), Vec::new(), Known::new());
    for (row, read) in table.requests(&request.output, &OrdinaryFiles) {
        match read.and_then(|read| task(&table, &read, inside.as_ref(), &mut known)) {
            Ok(task) => tasks.push(task),
            Err(fault) => wrong.push(table.failure(&shown, row, &fault)),
        }
    }
    if !wrong.is_empty() {
        return report(&wrong, &shown, request.run.is_json(), session);
    }
    if tasks.is_empty() {
        bail!("{shown}: no rows below the first one, which names the columns");
    }
    let rows = RunRequest::of_rows("batch", tasks, manifest.clone(), request.output.force);
    run::run(rows, &request.run, session)
}

fn task(
    table: &Table,
    row: &RowRequest,
    inside: Option<&(Inside, &OutputOptions)>,
    known: &mut Known,
) -> Result<Task, RowFault> {
    let column = table.model_column();
    if row.model.is_dir() {
        return Err(RowFault::of(column, "a folder, expected one model per row"));
    }
    if !row.model.is_file() {
        let why = if row.model.exists() { "this is not an ordinary file" } else { "there is no such file" };
        let message = format!("{why}: {}", row.model.display());
        return Err(RowFault::of(column, message));
    }
    let settings = settings(table, row, known)?;
    let task =
        Task::new(Source::in_table(&row.model), &row.output, settings).with_remarks(row.remarks.clone());
    if let Some(Err((input, message))) = inside.map(|(inside, call)| inside.check(&task, &row.output, call)) {
        return Err(RowFault::of(table.header_of(input).unwrap_or(column), message));
    }
    Ok(match usize::try_from(row.line) {
        Ok(line) => task.of_row(line),
        Err(_) => task,
    })
}

fn settings(table: &Table, row: &RowRequest, known: &mut Known) -> Result<Arc<JobSettings>, RowFault> {
    let key = row.settings();
    if let Some(settings) = known.get(&key) {
        return Ok(Arc::clone(settings));
    }
    let change = table.prepare(row, &OrdinaryFiles)?;
    let settings = Arc::new(JobSettings::new(change.planner, change.set_files, &row.output));
    known.insert(key, Arc::clone(&settings));
    Ok(settings)
}

fn report(wrong: &[Failure], shown: &str, json: bool, session: &mut Session) -> Result<Exit> {
    for failure in wrong.iter().filter(|_| json) {
        session.terminal.print(&line(&FailureRecord::new(failure, session.words)))?;
    }
    for failure in wrong.iter().take(REPORTED) {
        let message = failure.message.spelled(session.words);
        session.terminal.error_line(&format!("{}: {message}", failure.model));
    }
    let more = wrong.len().saturating_sub(REPORTED);
    let more = if more > 0 { format!(", {more} of them not shown") } else { String::new() };
    let rows = if wrong.len() == 1 { "1 row is".to_owned() } else { format!("{} rows are", wrong.len()) };
    session.terminal.error_line(&format!("{shown}: {rows} wrong{more}: nothing was written"));
    Ok(Exit::Usage)
}
