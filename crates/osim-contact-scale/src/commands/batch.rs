//! `batch`: a verb per row of a table.

use std::path::Path;

use anyhow::{Context, Result, bail};
use osim_library::run::{RowReader, Rows};
use osim_library::{Disk, folder_of};
use osim_model::files::{Failure, Files};
use osim_requests::BatchRequest;
use osim_view::report::json::{FailureRecord, line};

use super::change;
use crate::exit::Exit;
use crate::session::Session;

/// Rows that are wrong are reported one by one up to this number, then counted.
const REPORTED: usize = 20;

/// Does all rows of the table.
///
/// # Errors
/// It cannot be read, or is not a table with a column `model`.
pub(super) fn run(request: &BatchRequest, session: &mut Session) -> Result<Exit> {
    let Some(manifest) = &request.manifest else { bail!("no manifest given") };
    let shown = manifest.display().to_string();
    let reader = RowReader::new(request).map_err(|fault| session.refused(&fault))?;
    let bytes = Disk.read(manifest).with_context(|| shown.clone())?;
    let from_stdin = manifest.as_os_str() == "-";
    let folder = if from_stdin { Path::new("") } else { folder_of(manifest) };
    match reader.read(&bytes, &shown, folder).map_err(|fault| session.refused(&fault))? {
        Rows::Run(rows) => change::run(rows, &request.run, session),
        Rows::Wrong(wrong) => report(&wrong, &shown, request.run.is_json(), session),
    }
}

fn report(wrong: &[Failure], shown: &str, json: bool, session: &mut Session) -> Result<Exit> {
    for failure in wrong.iter().filter(|_| json) {
        session.terminal.print_records(&line(&FailureRecord::new(failure, session.words)))?;
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
