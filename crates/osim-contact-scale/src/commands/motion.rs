//! `motion`: contact forces along a recorded motion.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use osim_library::run::PathConflicts;
use osim_library::{Disk, WriteMode, write_files};
use osim_model::messages::Input;
use osim_planning::{MotionResult, run_motion};
use osim_requests::{MotionFormat, MotionRequest};
use osim_view::report::json::line;
use osim_view::report::results::{
    MotionRecord, external_loads_xml, ground_reactions_sto, motion_csv, motion_text,
};

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
    let output = MotionOutput::of(request, session)?;
    let result = run_motion(request, &Disk)
        .map_err(|error| session.refuse(error, request.format == MotionFormat::Json))?;
    let remarks = result.remarks(request);
    let text = match request.format {
        MotionFormat::Json => line(&MotionRecord::new(&result, &remarks, session.words)),
        MotionFormat::Csv => motion_csv(&result)?,
        _ => motion_text(&result, &remarks, session.words, session.terminal.columns()),
    };
    let written = match &output {
        Some(output) => output.write(&result, request, session)?,
        None => String::new(),
    };
    let is_for_programs = matches!(request.format, MotionFormat::Json | MotionFormat::Csv);
    session.terminal.print_as(&text, is_for_programs)?;
    session.terminal.print_to_stderr(&written)?;
    Ok(Exit::Done)
}

/// The files of ground reactions.
struct MotionOutput<'o> {
    table: &'o Path,
    loads: PathBuf,
}

impl<'o> MotionOutput<'o> {
    /// The outputs that the request names, checked before anything is computed.
    ///
    /// # Errors
    /// The name does not have the ending of a table, or is the name of a file that is read.
    fn of(request: &'o MotionRequest, session: &Session) -> Result<Option<Self>> {
        let Some(table) = request.output.as_deref() else { return Ok(None) };
        let is_table = |path: &Path| {
            path.extension()
                .is_some_and(|ending| ["sto", "mot"].iter().any(|known| ending.eq_ignore_ascii_case(known)))
        };
        if !is_table(table) {
            return Err(session.wrong_ending(Input::Output, table, ".sto"));
        }
        let loads = table.with_extension("xml");
        let mut conflicts = PathConflicts::default();
        let set_files = request.set_files.paths();
        let read = [&request.subject, &request.motion, &request.plates, &request.loads];
        for path in read.into_iter().flatten().chain(set_files) {
            conflicts.add_input(path);
        }
        conflicts.add_output(table, "the ground reactions").map_err(|fault| session.file_error(&fault))?;
        conflicts.add_output(&loads, "their ExternalLoads").map_err(|fault| session.file_error(&fault))?;
        Ok(Some(Self { table, loads }))
    }

    /// Writes the table of ground reactions and the file of external loads.
    ///
    /// # Errors
    /// As [`PendingFile::new`].
    fn write(&self, result: &MotionResult, request: &MotionRequest, session: &Session) -> Result<String> {
        let mode = if request.force { WriteMode::Replace } else { WriteMode::New };
        let name = self.table.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let files = [
            (self.table, ground_reactions_sto(result, &name)),
            (self.loads.as_path(), external_loads_xml(result, &name)),
        ];
        // Both are complete before the first gets its name.
        write_files(files.iter().map(|(path, text)| (*path, text.as_bytes())), mode)
            .map_err(|fault| session.file_error(&fault))?;
        Ok(files.iter().map(|(path, _)| format!("written to {}\n", path.display())).collect())
    }
}
