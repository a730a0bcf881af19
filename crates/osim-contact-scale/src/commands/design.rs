//! `design` without a model: a calculator.

use anyhow::Result;
use osim_planning::design_sheet;
use osim_requests::DesignRequest;
use osim_view::report::json::line;
use osim_view::report::results::design_sheet_text;

use crate::exit::Exit;
use crate::session::Session;

/// Calculates and prints.
///
/// # Errors
/// Too little is known, or it contradicts itself.
pub(super) fn calculate(request: &DesignRequest, session: &mut Session) -> Result<Exit> {
    let sheet = design_sheet(request).map_err(|fault| session.usage(&fault))?;
    let json = request.run.is_json();
    let text = if json { line(&sheet) } else { design_sheet_text(&sheet) };
    session.terminal.print_as(&text, json)?;
    Ok(Exit::Done)
}
