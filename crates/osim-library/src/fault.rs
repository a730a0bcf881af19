//! Faults of work with files on a disk.

use std::fmt::{self, Display};
use std::path::Path;

use osim_model::files::{Failure, FileName};
use osim_model::messages::{Dialect, Input, Phrase, phrase};

/// The reason why an action with files failed: the fault, what was expected, and a way out.
#[derive(Debug, Clone, PartialEq)]
pub struct LibraryFault {
    message: Phrase,
    pub cause: FaultCause,
}

/// What an action with files gives, or why it failed.
pub type Result<T, E = LibraryFault> = std::result::Result<T, E>;

/// What made an action with files fail: the call, the operating system, or another run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaultCause {
    /// The user's call asks for something that is refused.
    Call,
    /// The operating system refused, for example because the disk is full or the folder may not be written.
    System,
    /// Another run is using a file; that run will end.
    Busy,
}

impl LibraryFault {
    /// A fault of the user's call. The message has names of options as data, which a front end spells.
    pub fn new(message: impl Into<Phrase>) -> Self {
        Self { message: message.into(), cause: FaultCause::Call }
    }

    /// A fault of the operating system: the action `what` failed for the reason `why`.
    pub(crate) fn system(what: impl Display, why: impl Display) -> Self {
        Self { cause: FaultCause::System, ..Self::new(format!("{what}: {why}")) }
    }

    /// The fault that another run is using a file.
    pub(crate) fn busy(message: Phrase) -> Self {
        Self { message, cause: FaultCause::Busy }
    }

    /// The fault that the file `path` exists already; `option` gives it another name.
    pub fn file_exists(path: &Path, option: Input) -> Self {
        let what = if option == Input::OutputDir { "folder" } else { "name" };
        Self::new(phrase![
            "{} exists already: choose another {what} with {}, or replace it with {}";
            path.display().to_string(), option, Input::Force
        ])
    }

    /// The fault that several results exist already: `which` and how many, with the `first` of them. `resume` goes on with them, if the
    /// verb can.
    pub(crate) fn results_exist(which: impl Display, first: &Path, resume: Option<&Phrase>) -> Self {
        let resume = resume.map(|way| phrase!["continue the earlier run ({}), "; way]).unwrap_or_default();
        Self::new(phrase![
            "{which} exist already, such as {}: {}replace them ({}), or choose another folder with {}";
            first.display().to_string(), &resume, Input::Force, Input::OutputDir.with_placeholder("DIR")
        ])
    }

    /// Refuses several `existing` results of a run with `all` results. `resume` goes on with them, if the verb can.
    pub(crate) fn refuse_existing(
        existing: &[impl AsRef<Path>],
        all: usize,
        resume: Option<&Phrase>,
    ) -> Result<(), Self> {
        let [first, _, ..] = existing else { return Ok(()) };
        let which = format!("{} of {all} results", existing.len());
        Err(Self::results_exist(which, first.as_ref(), resume))
    }

    /// The fault that a resumed run would replace an output which somebody edited after it was written.
    pub(crate) fn output_edited(output: &Path) -> Self {
        Self::new(phrase![
            "{} is not what an earlier run wrote, so it stays: move it away, or replace it with {}";
            output.display().to_string(), Input::Force
        ])
    }

    /// The fault with the name of the failed action before its message.
    pub fn with_context(self, what: impl Display) -> Self {
        Self { message: phrase![format!("{what}: "), &self.message], cause: self.cause }
    }

    /// The message, with names of options as data.
    pub fn phrase(&self) -> &Phrase {
        &self.message
    }

    pub fn spelled(&self, dialect: &dyn Dialect) -> String {
        self.message.spelled(dialect)
    }

    /// The fault as the failure of a model, with this code.
    pub fn into_failure(self, model: impl Into<FileName>, code: &'static str) -> Failure {
        Failure::outside(model, code, &self.message)
    }
}

/// The fault of a lock that a thread held when it ended by a panic.
pub(crate) fn fault_of_panic() -> LibraryFault {
    LibraryFault::new("a thread ended early")
}

/// A fault with the text of `error`.
pub(crate) fn fault_of_error(error: impl Display) -> LibraryFault {
    LibraryFault::new(error.to_string())
}

impl Display for LibraryFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message.fmt(f)
    }
}

impl std::error::Error for LibraryFault {}

/// Adds the name of the failed action to an error.
pub(crate) trait Context<T> {
    fn context<D: Display>(self, what: impl FnOnce() -> D) -> Result<T>;
}

impl<T, E: Display> Context<T> for Result<T, E> {
    fn context<D: Display>(self, what: impl FnOnce() -> D) -> Result<T> {
        self.map_err(|why| LibraryFault::system(what(), why))
    }
}
