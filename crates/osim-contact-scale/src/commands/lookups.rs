//! `explain`, `presets` and `request`: verbs that say what is known and need no model.

use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use osim_library::Disk;
use osim_model::files::Files;
use osim_planning::find_presets;
use osim_requests::options::Format;
use osim_requests::{ExplainRequest, PresetsRequest, Request};
use osim_view::report::explain::{Letters, answer};
use osim_view::report::json::line;
use osim_view::report::results::{PresetRecord, preset_text};

use crate::args::RequestArgs;
use crate::exit::Exit;
use crate::session::{self, Language, Session};
use crate::terminal::Terminal;

/// Explains what is named; alone, lists everything.
///
/// # Errors
/// Something that is neither an equation nor a code.
pub(crate) fn explain(request: &ExplainRequest, session: &mut Session) -> Result<Exit> {
    let words = session.words;
    let letters = if Terminal::shows_unicode() { Letters::Unicode } else { Letters::Ascii };
    let shown = answer(request, letters, words).map_err(|unknown| anyhow!(unknown.message(words)))?;
    session.terminal.print_as(&shown, request.format == Format::Json)?;
    Ok(Exit::Done)
}

// `presets`: published contacts, and the user's own.

/// Lists presets, or shows one.
///
/// # Errors
/// A file of presets that cannot be read, or an unknown name.
pub(crate) fn presets(request: &PresetsRequest, session: &mut Session) -> Result<Exit> {
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

// `request`: a verb with its options, as JSON.

/// The name of standard input.
const STDIN: &str = "-";

/// Reads a request from a file or standard input. From now on the session names options as the caller does: as fields of
/// requests, or as arguments of the function that made the request.
///
/// # Errors
/// The file cannot be read, or holds no request that makes sense.
pub(crate) fn read_request(args: &RequestArgs, session: &mut Session) -> Result<Request> {
    session.words = session::of_request(args.words);
    session.terminal.never_break();
    let is_stdin = args.file == Path::new(STDIN);
    let shown = if is_stdin { "standard input".into() } else { args.file.to_string_lossy().into_owned() };
    let bytes = Disk.read(&args.file).with_context(|| shown.clone())?;
    let request = Request::from_json(&bytes).map_err(|fault| session.usage(&fault));
    // Who called a function knows of no file.
    let request = if args.words == Language::Matlab { request? } else { request.with_context(|| shown)? };
    if is_stdin && let Some(field) = request.option_that_reads(&args.file) {
        bail!("`{field}` is standard input, where the request itself was: put the request into a file");
    }
    Ok(request)
}
