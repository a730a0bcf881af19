//! `rescale`, and a model alone.

use anyhow::{Result, bail};
use osim_library::Disk;
use osim_model::files::Files;
use osim_planning::{may_be_file, prepare};
use osim_requests::options::{InspectionOptions, SheetFormat, StanceOptions};
use osim_requests::{InspectRequest, RequestError, RescaleRequest};

use super::change::change;
use super::inspect;
use crate::exit::Exit;
use crate::meant::meant;
use crate::session::Session;

/// Rescales; `may_inspect` where no verb was typed, so that a model alone is inspected.
///
/// # Errors
/// Wrong usage.
pub(super) fn run(request: RescaleRequest, may_inspect: bool, session: &mut Session) -> Result<Exit> {
    if request.models.is_empty() {
        bail!("no model given, expected one or more .osim files or folders (see --help)");
    }
    // If there is a file of that name, it is a model; a name that was split at its blanks is another failure.
    let is_odd = request.models.iter().any(|path| !Disk.exists(path) && path.as_os_str() != "-");
    if is_odd && let Some(text) = meant(&request.models, request.target_mass.is_none(), session.words) {
        bail!("{text} (see --help)");
    }
    if let Some(word) = request.models.iter().find(|path| !may_be_file(path, &Disk)).filter(|_| may_inspect) {
        bail!("'{}' is neither a verb nor a file (see --help)", word.display());
    }
    if request.target_mass.is_some() || !may_inspect || request.asks_for_change() {
        let missing = request.target_mass.is_none();
        let run = request.run.clone();
        return match prepare(request, &Disk) {
            Ok(prepared) => change(prepared, &run, session),
            Err(RequestError::Fault(fault)) if missing => {
                bail!("{}{}", fault.spelled(session.words), session.words.see_also())
            }
            Err(error) => session.refuse(error, run.is_json()),
        };
    }
    // A model alone, perhaps dropped on the program: show something useful.
    let json = request.run.is_json();
    let format = if json { SheetFormat::Json } else { SheetFormat::Table };
    let mut inspect = InspectRequest { format, ..InspectRequest::default() };
    inspect.report.report = request.run.report;
    inspect.report.force = request.output.force;
    inspect.models = request.models;
    inspect.options =
        InspectionOptions::new(StanceOptions::default(), request.masses, request.choice, request.set_files);
    inspect.options.answers = request.answers;
    inspect::run(&inspect, true, session)
}
