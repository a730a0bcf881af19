//! `explain`: what an equation says, and what a warning or an error means.

use anyhow::{Result, anyhow};
use osim_requests::ExplainRequest;
use osim_requests::options::Format;
use osim_view::report::explain::{Letters, answer};

use crate::exit::Exit;
use crate::session::Session;
use crate::terminal::Terminal;

/// Explains what is named; alone, lists everything.
///
/// # Errors
/// Something that is neither an equation nor a code.
pub(super) fn run(request: &ExplainRequest, session: &mut Session) -> Result<Exit> {
    let words = session.words;
    let letters = if Terminal::shows_unicode() { Letters::Unicode } else { Letters::Ascii };
    let shown = answer(request, letters, words).map_err(|unknown| anyhow!(unknown.message(words)))?;
    session.terminal.print_as(&shown, request.format == Format::Json)?;
    Ok(Exit::Done)
}
