//! `presets`: published contacts, and the user's own.

use anyhow::Result;
use osim_library::Disk;
use osim_planning::find_presets;
use osim_requests::PresetsRequest;
use osim_requests::options::Format;
use osim_view::report::json::line;
use osim_view::report::results::{PresetRecord, preset_text};

use crate::exit::Exit;
use crate::session::Session;

/// Lists presets, or shows one.
///
/// # Errors
/// A file of presets that cannot be read, or an unknown name.
pub(super) fn run(request: &PresetsRequest, session: &mut Session) -> Result<Exit> {
    let presets = find_presets(request, &Disk).map_err(|fault| session.usage(&fault))?;
    for (index, preset) in presets.iter().enumerate() {
        let text = match request.format {
            Format::Json => line(&PresetRecord::from(preset)),
            _ if index == 0 => preset_text(preset),
            _ => format!("\n{}", preset_text(preset)),
        };
        session.terminal.print_as(&text, request.format == Format::Json)?;
    }
    Ok(Exit::Done)
}
