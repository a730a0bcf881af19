//! `motion`: contact forces along a recorded motion.

use anyhow::{Result, bail};
use osim_library::{Disk, MotionFiles};
use osim_planning::{NextModels, run_motion};
use osim_requests::{MotionFormat, MotionRequest};
use osim_view::report::json::line;
use osim_view::report::results::{MotionRecord, motion_csv, motion_text};

use crate::exit::Exit;
use crate::session::Session;

/// Computes the contact forces along a recorded motion, prints them and writes the files that the request names.
///
/// # Errors
/// Wrong usage, or a file that exists already.
pub(crate) fn run(request: &MotionRequest, session: &mut Session) -> Result<Exit> {
    if let Some(folder) = request.subject.iter().find(|path| path.is_dir()) {
        bail!("'{}' is a folder, and a motion is that of one model: name a model in it", folder.display());
    }
    let files = MotionFiles::of(request).map_err(|fault| session.file_error(&fault))?;
    let result = run_motion(request, &Disk)
        .map_err(|error| session.refuse(error, request.format == MotionFormat::Json))?;
    let next = NextModels::new(request, &result, &Disk)
        .map_err(|error| session.refuse(error, request.format == MotionFormat::Json))?;
    let remarks = result.remarks(request);
    let text = match request.format {
        MotionFormat::Json => line(&MotionRecord::new(&result, &remarks, session.words)),
        MotionFormat::Csv => motion_csv(&result)?,
        _ => motion_text(&result, &remarks, session.words, session.terminal.columns()),
    };
    let written = files.write(&result, &next).map_err(|fault| session.file_error(&fault))?;
    let written: String = written.iter().map(|path| format!("written to {}\n", path.display())).collect();
    let is_for_programs = matches!(request.format, MotionFormat::Json | MotionFormat::Csv);
    session.terminal.print_as(&text, is_for_programs)?;
    session.terminal.print_to_stderr(&written)?;
    let is_uncorrected = result.consistency.is_some_and(|one| one.correction.is_none());
    Ok(if is_uncorrected { Exit::Failed } else { Exit::Done })
}
