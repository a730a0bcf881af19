//! What verbs without a change print and write in the end.

use std::path::Path;

use anyhow::Result;
use osim_inspect::unmatched_patterns;
use osim_library::Disk;
use osim_library::page::ReportPage;
use osim_model::files::Beside;
use osim_planning::open_with;
use osim_requests::options::{ForceOptions, MassOptions};
use osim_requests::spell::shell_quoted;

use crate::exit::Exit;
use crate::session::Session;

/// Ends the page, if there is one; what cannot be written is reported.
pub(super) fn end_page(page: Option<ReportPage>, session: &mut Session) -> Exit {
    match page.map_or(Ok(()), ReportPage::finish) {
        Ok(()) => Exit::Done,
        Err(fault) => {
            let why = session.refused(&fault);
            session.terminal.error_line(&format!("the report: {why:#}"));
            Exit::Failed
        }
    }
}

// The call as it was typed, for reports.

/// The command line, each word quoted where a shell asks for it.
pub(super) fn asked() -> String {
    let words = std::env::args_os().skip(1).map(|word| shell_quoted(&word.to_string_lossy()));
    std::iter::once("osim-contact-scale".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

// Choices of forces or bodies that fit nothing, for verbs whose results do not say it.

/// Notes each of them for the models at `paths`. What cannot be read is named by the verb itself.
///
/// # Errors
/// Standard error is closed.
pub(super) fn note_unmatched<'p>(
    paths: impl IntoIterator<Item = &'p Path>,
    beside: Beside<'_>,
    choice: &ForceOptions,
    masses: &MassOptions,
    session: &mut Session,
) -> Result<()> {
    let (selection, masses) = (choice.selection(), masses.request());
    if selection.select.is_empty() && selection.exclude.is_empty() && masses.exclude_bodies.is_empty() {
        return Ok(());
    }
    // Standard input was read already.
    for path in paths.into_iter().filter(|path| path.as_os_str() != "-") {
        let Ok(open) = open_with(path, beside, &Disk) else { continue };
        for message in unmatched_patterns(&selection, &masses, &open.model) {
            session.terminal.note_line(&message.spelled(session.words))?;
        }
    }
    Ok(())
}
