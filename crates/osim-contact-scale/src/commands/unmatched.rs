//! Choices of forces or bodies that fit nothing, for verbs whose results do not say it.

use std::path::Path;

use anyhow::Result;
use osim_inspect::unmatched_patterns;
use osim_library::Disk;
use osim_model::files::Beside;
use osim_planning::open_with;
use osim_requests::options::{ForceOptions, MassOptions};

use crate::session::Session;

/// Notes each of them for the models at `paths`. What cannot be read is named by the verb itself.
///
/// # Errors
/// Standard error is closed.
pub(super) fn note<'p>(
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
