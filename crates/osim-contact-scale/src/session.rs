//! What every verb of one call shares.

use anyhow::Result;
use clap::ValueEnum;
use osim_library::LibraryFault;
pub(crate) use osim_library::page::Words;
use osim_model::files::Failure;
use osim_requests::spell::{CommandLine, JsonRequest, Matlab};
use osim_requests::{RequestError, RequestFault};
use osim_view::report::json::{FailureRecord, line};

use crate::exit::{self, Ended, Exit, exit_of_cause};
use crate::terminal::Terminal;

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
        exit::report(failure, self.words, &mut self.terminal);
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

    /// The error for files that were refused.
    pub(crate) fn refused(&self, fault: &LibraryFault) -> anyhow::Error {
        Ended { text: fault.spelled(self.words), exit: exit_of_cause(fault.cause()) }.into()
    }
}

// The words in which this program names its options: those of its command line, of a request in JSON, or of the functions
// that send one.

/// Options as they are typed.
pub(crate) static WORDS: Words = &CommandLine;

/// The language of those who read messages about a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Language {
    Json,
    Matlab,
}

/// The words of a request for those who wrote it: fields, or the arguments of the function that made them.
pub(crate) fn of_request(language: Language) -> Words {
    match language {
        Language::Json => &JsonRequest,
        Language::Matlab => &Matlab,
    }
}
