//! Any request that changes models.

use osim_model::files::Files;
use osim_model::wording::Verb;

use crate::planner::Change;
use crate::request::Request;
use osim_options::{RequestError, RequestFault};

/// Verbs that change models.
pub(crate) const CHANGING: [Verb; 8] = [
    Verb::Rescale,
    Verb::Transfer,
    Verb::Add,
    Verb::Remove,
    Verb::Convert,
    Verb::Design,
    Verb::Set,
    Verb::Note,
];

/// The same in words: `rescale, transfer, design, set or note`.
pub(crate) fn changing_verbs() -> String {
    let names = CHANGING.map(Verb::name);
    match names.split_last() {
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
        None => String::new(),
    }
}

impl Request {
    /// Checks a request that changes models, for all of them, and reads what it needs beside them. A design without models
    /// has none to change: it is [calculated](crate::DesignRequest::calculate).
    ///
    /// # Errors
    /// Options that say nothing, or contradict each other; a file that cannot be read; or a verb that changes nothing.
    pub fn prepare(self, files: &dyn Files) -> Result<Change, RequestError> {
        let verb = self.verb().name();
        match self {
            Self::Rescale(request) => request.prepare(files),
            Self::Design(request) => Ok(request.prepare()?),
            Self::Set(request) => Ok(request.prepare()?),
            Self::Note(request) => Ok(request.prepare()?),
            Self::Add(request) => request.prepare(files),
            Self::Convert(request) => Ok(request.prepare()?),
            Self::Remove(request) => Ok(request.prepare()?),
            Self::Transfer(request) => request.prepare(files),
            _ => {
                let message = format!("'{verb}', expected {}", changing_verbs());
                Err(RequestFault::general(message).into())
            }
        }
    }
}
