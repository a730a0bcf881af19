//! `drop-test`: what contacts do when their body falls on them.

use std::io::IsTerminal;

use anyhow::Result;
use osim_library::Disk;
use osim_report::json::line;
use osim_report::messages::mass_mismatch;
use osim_report::results::{DropRecord, drop_chart, drop_csv, drop_text};
use osim_requests::{DropTestRequest, SeriesFormat};

use crate::session::Session;
use crate::terminal::Exit;

/// Lets it fall.
///
/// # Errors
/// Wrong usage: numbers that are missing or contradict a model.
pub(super) fn run(request: &DropTestRequest, session: &mut Session) -> Result<Exit> {
    let drop = match request.run(&Disk) {
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
    session.terminal.print(&text)?;
    for (name, mismatch) in &drop.mismatches {
        session.terminal.note(&mass_mismatch(name, mismatch, session.words))?;
    }
    Ok(Exit::Done)
}
