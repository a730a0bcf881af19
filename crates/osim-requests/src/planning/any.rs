//! Any request that changes models.

use osim_model::files::Files;

use crate::fault::{RequestError, RequestFault};
use crate::planner::Change;
use crate::request::Request;

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
            Self::Transfer(request) => request.prepare(files),
            _ => {
                let message = format!("'{verb}', expected rescale, transfer, design or set");
                Err(RequestFault::general(message).into())
            }
        }
    }
}
