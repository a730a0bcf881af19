//! Verbs that change models.

use anyhow::Result;
use osim_library::Disk;
use osim_library::run::RunRequest;
use osim_requests::options::RunOptions;
use osim_requests::{
    AddRequest, Change, ConvertRequest, DesignRequest, NoteRequest, RemoveRequest, SetRequest,
    TransferRequest,
};

use super::run;
use crate::session::Session;
use crate::terminal::Exit;

/// A change of all models that it names.
///
/// # Errors
/// Wrong usage.
pub(super) fn change(change: Change, options: &RunOptions, session: &mut Session) -> Result<Exit> {
    let request = RunRequest::of_change(change, options).map_err(|fault| session.refused(&fault))?;
    run::run(request, options, session)
}

/// `transfer`.
///
/// # Errors
/// Wrong usage.
pub(super) fn transfer(request: TransferRequest, session: &mut Session) -> Result<Exit> {
    let options = request.run.clone();
    match request.prepare(&Disk) {
        Ok(prepared) => change(prepared, &options, session),
        Err(error) => session.refuse(error, options.is_json()),
    }
}

/// `add`.
///
/// # Errors
/// Wrong usage.
pub(super) fn add(request: AddRequest, session: &mut Session) -> Result<Exit> {
    let options = request.run.clone();
    match request.prepare(&Disk) {
        Ok(prepared) => change(prepared, &options, session),
        Err(error) => session.refuse(error, options.is_json()),
    }
}

/// `remove`.
///
/// # Errors
/// Wrong usage.
pub(super) fn remove(request: RemoveRequest, session: &mut Session) -> Result<Exit> {
    let options = request.run.clone();
    let prepared = request.prepare().map_err(|fault| session.usage(&fault))?;
    change(prepared, &options, session)
}

/// `convert`.
///
/// # Errors
/// Wrong usage.
pub(super) fn convert(request: ConvertRequest, session: &mut Session) -> Result<Exit> {
    let options = request.run.clone();
    let prepared = request.prepare().map_err(|fault| session.usage(&fault))?;
    change(prepared, &options, session)
}

/// `design` with models.
///
/// # Errors
/// Wrong usage.
pub(super) fn design(request: DesignRequest, session: &mut Session) -> Result<Exit> {
    let options = request.run.clone();
    let prepared = request.prepare().map_err(|fault| session.usage(&fault))?;
    change(prepared, &options, session)
}

/// `set`.
///
/// # Errors
/// Wrong usage.
pub(super) fn set(request: SetRequest, session: &mut Session) -> Result<Exit> {
    let options = request.run.clone();
    let prepared = request.prepare().map_err(|fault| session.usage(&fault))?;
    change(prepared, &options, session)
}

/// `note`.
///
/// # Errors
/// Wrong usage.
pub(super) fn note(request: NoteRequest, session: &mut Session) -> Result<Exit> {
    let options = request.run.clone();
    let prepared = request.prepare().map_err(|fault| session.usage(&fault))?;
    change(prepared, &options, session)
}
