//! `drop-test`: what contacts do when their body falls on them.

use std::io::IsTerminal;

use anyhow::{Result, bail};
use osim_library::Disk;
use osim_model::messages::Verb;
use osim_planning::run_drop_test;
use osim_requests::{DropTestRequest, SeriesFormat};
use osim_view::report::json::line;
use osim_view::report::messages::mass_mismatch;
use osim_view::report::results::{DropRecord, drop_chart, drop_csv, drop_text};

use crate::exit::Exit;
use crate::session::Session;

/// Lets it fall.
///
/// # Errors
/// Wrong usage: numbers that are missing or contradict a model.
pub(super) fn run(request: &DropTestRequest, session: &mut Session) -> Result<Exit> {
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
