//! `fit`: contact parameters from a measured indentation and force; a fit to recordings is a change of a model.

use anyhow::Result;
use osim_library::Disk;
use osim_planning::run_fit;
use osim_requests::{FitRequest, RequestError};
use osim_view::report::json::{FailureRecord, line};
use osim_view::report::results::{FitRecord, fit_text};

use crate::exit::Exit;
use crate::session::Session;

/// Fits and reports.
///
/// # Errors
/// Wrong usage.
pub(super) fn run(request: &FitRequest, session: &mut Session) -> Result<Exit> {
    let json = request.run.is_json();
    match run_fit(request, &Disk) {
        Ok(fit) => {
            let text = if json { line(&FitRecord::from(&fit)) } else { fit_text(&fit, session.words) };
            session.terminal.print_as(&text, json)?;
            Ok(Exit::Done)
        }
        Err(RequestError::Fault(fault)) => Err(session.usage(&fault)),
        Err(RequestError::Failure(failure)) => {
            if json {
                session.terminal.print_records(&line(&FailureRecord::new(&failure, session.words)))?;
            }
            // The message begins with the name of the file.
            session.terminal.error_line(&failure.message.spelled(session.words));
            Ok(Exit::Failed)
        }
    }
}
