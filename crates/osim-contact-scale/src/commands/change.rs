//! Verbs that change models.

use anyhow::Result;
use osim_library::Disk;
use osim_library::run::RunRequest;
use osim_planning::{Change, prepare};
use osim_requests::Request;
use osim_requests::options::RunOptions;

use crate::exit::Exit;
use crate::session::Session;

/// A change of all models that it names.
///
/// # Errors
/// Wrong usage.
pub(super) fn change(change: Change, options: &RunOptions, session: &mut Session) -> Result<Exit> {
    let request = RunRequest::of_change(change, options).map_err(|fault| session.refused(&fault))?;
    super::run::run(request, options, session)
}

/// A verb that changes models.
///
/// # Errors
/// Wrong usage.
pub(super) fn run(request: Request, session: &mut Session) -> Result<Exit> {
    let options = request.run_options().cloned().unwrap_or_default();
    match prepare(request, &Disk) {
        Ok(prepared) => change(prepared, &options, session),
        Err(error) => session.refuse(error, options.is_json()),
    }
}
