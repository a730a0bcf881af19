//! What every verb of one call shares.

use anyhow::Result;
use osim_library::LibraryFault;
use osim_model::files::Failure;
use osim_requests::{RequestError, RequestFault};
use osim_view::report::json::{FailureRecord, line};

use crate::exit::{Ended, Exit, exit_of_cause};
use crate::failure;
use crate::terminal::Terminal;
use crate::words::Words;

/// One call of the program.
pub(crate) struct Session {
    /// Where it talks.
    pub terminal: Terminal,
    /// How it spells what the reader can say.
    pub words: Words,
}

impl Session {
    /// Reports a failure; scripts that read JSON get it there, too.
    pub(crate) fn fail(&mut self, failure: &Failure, json: bool) -> Result<Exit> {
        if json {
            self.terminal.print_records(&line(&FailureRecord::new(failure, self.words)))?;
        }
        failure::report(failure, self.words, &mut self.terminal);
        Ok(Exit::Failed)
    }

    /// A request that cannot be begun: wrong usage, or a file that it needs.
    ///
    /// # Errors
    /// Wrong usage.
    pub(crate) fn refuse(&mut self, error: RequestError, json: bool) -> Result<Exit> {
        match error {
            RequestError::Fault(fault) => Err(self.usage(&fault)),
            RequestError::Failure(failure) => self.fail(&failure, json),
        }
    }

    /// Wrong usage, as an error.
    pub(crate) fn usage(&self, fault: &RequestFault) -> anyhow::Error {
        anyhow::anyhow!(fault.spelled(self.words))
    }

    /// The same of files.
    pub(crate) fn refused(&self, fault: &LibraryFault) -> anyhow::Error {
        Ended { text: fault.spelled(self.words), exit: exit_of_cause(fault.cause()) }.into()
    }
}
