//! `design`, `drop-test` and `fit`: verbs that compute and change no file.

use std::io::IsTerminal;

use anyhow::{Result, bail};
use osim_library::Disk;
use osim_model::messages::Verb;
use osim_planning::{design_sheet, run_drop_test, run_fit};
use osim_requests::{DesignRequest, DropTestRequest, FitRequest, RequestError, SeriesFormat};
use osim_view::report::json::{FailureRecord, line};
use osim_view::report::messages::mass_mismatch;
use osim_view::report::results::{
    DropRecord, FitRecord, design_sheet_text, drop_chart, drop_csv, drop_text, fit_text,
};

use crate::exit::Exit;
use crate::session::Session;

/// Calculates and prints.
///
/// # Errors
/// Too little is known, or it contradicts itself.
pub(super) fn design(request: &DesignRequest, session: &mut Session) -> Result<Exit> {
    let sheet = design_sheet(request).map_err(|fault| session.usage(&fault))?;
    let json = request.run.is_json();
    let text = if json { line(&sheet) } else { design_sheet_text(&sheet) };
    session.terminal.print_as(&text, json)?;
    Ok(Exit::Done)
}

// `drop-test`: what contacts do when their body falls on them.

/// Lets it fall.
///
/// # Errors
/// Wrong usage: numbers that are missing or contradict a model.
pub(super) fn drop_test(request: &DropTestRequest, session: &mut Session) -> Result<Exit> {
    if let Some(folder) = request.subject.iter().chain(&request.compare).find(|path| path.is_dir()) {
        bail!("{}", of_folder(&folder.display().to_string(), session));
    }
    let drop = match run_drop_test(request, &Disk) {
        Ok(drop) => drop,
        Err(error) => return session.refuse(error, request.format == SeriesFormat::Json),
    };
    let text = match request.format {
        SeriesFormat::Json => line(&DropRecord::from(&drop)),
        SeriesFormat::Csv => drop_csv(&drop)?,
        // A terminal can draw.
        _ if std::io::stdout().is_terminal() => format!("{}{}", drop_text(&drop), drop_chart(&drop)),
        _ => drop_text(&drop),
    };
    let is_for_programs = matches!(request.format, SeriesFormat::Json | SeriesFormat::Csv);
    session.terminal.print_as(&text, is_for_programs)?;
    for (name, mismatch) in &drop.mismatches {
        session.terminal.note(&mass_mismatch(name, mismatch, session.words))?;
    }
    Ok(Exit::Done)
}

/// A folder has many models, and each falls for itself.
fn of_folder(folder: &str, session: &Session) -> String {
    format!(
        "'{folder}' is a folder, and one body falls at a time: name a model in it. `{} {}` has \
         indentation, stiffness and restitution of all its models",
        session.words.command(&Verb::Inspect.call()),
        session.words.word(folder)
    )
}

// `fit`: contact parameters from a measured indentation and force; a fit to recordings is a change of a model.

/// Fits and reports.
///
/// # Errors
/// Wrong usage.
pub(super) fn fit(request: &FitRequest, session: &mut Session) -> Result<Exit> {
    let json = request.run.is_json();
    match run_fit(request, &Disk) {
        Ok(fit) => {
            let text = if json { line(&FitRecord::from(&fit)) } else { fit_text(&fit, session.words) };
            session.terminal.print_as(&text, json)?;
            Ok(Exit::Done)
        }
        Err(RequestError::Fault(fault)) => Err(session.usage(&fault)),
        Err(RequestError::Failure(failure)) => {
            if json {
                session.terminal.print_records(&line(&FailureRecord::new(&failure, session.words)))?;
            }
            // The message begins with the name of the file.
            session.terminal.error_line(&failure.message.spelled(session.words));
            Ok(Exit::Failed)
        }
    }
}
