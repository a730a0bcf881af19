//! Prepares any request that changes models. Each verb has a file.

mod add;
mod convert;
pub(crate) mod design;
pub(crate) mod fit;
mod fit_remarks;
mod note;
pub(crate) mod reference;
mod remove;
pub(crate) mod rescale;
pub(crate) mod set;
mod transfer;

use osim_model::files::Files;
use osim_requests::{CHANGING, NoteDetails, Request, RequestFault, Result};

use crate::prepared_change::PreparedChange;

/// The verbs that change models, in words: `rescale, transfer, design, set, fit or note`.
pub(crate) fn changing_verbs() -> String {
    let names: Vec<&str> = CHANGING.iter().map(|verb| verb.name()).collect();
    names.split_last().map_or_else(String::new, |(last, others)| format!("{} or {last}", others.join(", ")))
}

/// Checks a request that changes models, once for all of its models, and reads the other files that it names. A design without models
/// changes none; [`design_sheet`](crate::design_sheet) computes it.
///
/// # Errors
/// Options that have no effect, or contradict each other; a file that cannot be read; or a verb that changes nothing.
pub fn prepare(request: impl Into<Request>, files: &dyn Files) -> Result<PreparedChange> {
    let request = request.into();
    let settings = request.settings();
    let details = NoteDetails::of(request.verb(), &settings);
    Ok(PreparedChange { details, settings, ..prepare_change(request, files)? })
}

/// Prepares the change of each verb that changes models.
fn prepare_change(request: Request, files: &dyn Files) -> Result<PreparedChange> {
    match request {
        Request::Rescale(request) => rescale::prepare(*request, files),
        Request::Design(request) => Ok(design::prepare(*request)?),
        Request::Set(request) => Ok(set::prepare(*request)?),
        Request::Note(request) => Ok(note::prepare(*request)?),
        Request::Add(request) => add::prepare::prepare(*request, files),
        Request::Convert(request) => Ok(convert::prepare(*request)?),
        Request::Remove(request) => Ok(remove::prepare(*request)?),
        Request::Transfer(request) => transfer::prepare(*request, files),
        Request::Fit(request) if request.is_of_motion() => fit::prepare(*request, files),
        Request::Fit(_) => Err(RequestFault::Missing { field: "motion" }.into()),
        other => {
            let message = format!("'{}', expected {}", other.verb().name(), changing_verbs());
            Err(RequestFault::general(message).into())
        }
    }
}
