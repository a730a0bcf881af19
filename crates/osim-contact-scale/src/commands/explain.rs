//! `explain`: what an equation says, and what a warning or an error means.

use anyhow::{Result, anyhow};
use osim_report::explain::{Letters, Topic, TopicRecord, list, text};
use osim_report::json::line;
use osim_requests::ExplainRequest;
use osim_requests::options::Format;

use crate::session::Session;
use crate::terminal::{Exit, Terminal};

/// Explains what is named; alone, lists everything.
///
/// # Errors
/// Something that is neither an equation nor a code.
pub(super) fn run(request: &ExplainRequest, session: &mut Session) -> Result<Exit> {
    let words = session.words;
    let named = request.topics.join(" ");
    let topics = match named.is_empty() {
        true => Topic::all(),
        false => Topic::find(&named).map_err(|unknown| anyhow!(unknown.message(words)))?,
    };
    let ascii = request.ascii || !Terminal::shows_unicode();
    let letters = if ascii { Letters::Ascii } else { Letters::Unicode };
    let shown = match request.format {
        Format::Json => topics.into_iter().map(|topic| line(&TopicRecord::new(topic, words))).collect(),
        _ if named.is_empty() => list(&topics, words, letters),
        _ => {
            let each: Vec<String> = topics.into_iter().map(|topic| text(topic, words, letters)).collect();
            each.join("\n")
        }
    };
    session.terminal.print(&shown)?;
    Ok(Exit::Done)
}
