//! Why something could not be done with files.

use std::fmt::{self, Display};
use std::path::Path;

use osim_model::files::{Failure, FileName};
use osim_model::messages::{Dialect, Input, Phrase, phrase};

/// Why something could not be done with files: what is wrong, what was expected, and a way out.
#[derive(Debug, Clone, PartialEq)]
pub struct LibraryFault {
    message: Phrase,
    cause: Cause,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// The call's: it asks for what is not done.
    Call,
    /// The system's: a full disk, a folder that may not be written.
    System,
    /// Nobody's: another run has a file, and will be done with it.
    Busy,
}

impl LibraryFault {
    /// In words; what the reader can say is in them as data.
    pub fn new(message: impl Into<Phrase>) -> Self {
        Self { message: message.into(), cause: Cause::Call }
    }

    /// What could not be done, and why not.
    pub(crate) fn because(what: impl Display, why: impl Display) -> Self {
        Self { cause: Cause::System, ..Self::new(format!("{what}: {why}")) }
    }

    /// Another run has a file.
    pub(crate) fn busy(message: Phrase) -> Self {
        Self { message, cause: Cause::Busy }
    }

    /// This output is there, and no run wrote it like that. No file is replaced unless the user asks for it.
    pub(crate) fn edited(output: &Path) -> Self {
        Self::new(phrase![
            format!(
                "{} is not what an earlier run wrote, so it stays: move it away, or replace it with ",
                output.display()
            ),
            Input::Force,
        ])
    }

    /// A model holds what an earlier run wrote by other options. A factor would be applied on top of the one before.
    pub(crate) fn changed_before() -> Self {
        Self::new(phrase![
            "an earlier run changed this model by other options, and this change would come on top of that: bring back \
             what it was before, or change it once more with ",
            Input::Force,
        ])
    }

    pub fn within(self, what: impl Display) -> Self {
        let mut message = Phrase::from(format!("{what}: "));
        message.push(&self.message);
        Self { message, cause: self.cause }
    }

    pub fn cause(&self) -> Cause {
        self.cause
    }

    /// What is wrong, with inputs as data.
    pub fn phrase(&self) -> &Phrase {
        &self.message
    }

    pub fn spelled(&self, dialect: &dyn Dialect) -> String {
        self.message.spelled(dialect)
    }

    pub fn of_model(self, model: impl Into<FileName>, code: &'static str) -> Failure {
        Failure::outside(model, code, &self.message)
    }
}

/// The error of another library.
pub(crate) fn foreign_fault(error: impl Display) -> LibraryFault {
    LibraryFault::new(error.to_string())
}

impl Display for LibraryFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message.fmt(f)
    }
}

impl std::error::Error for LibraryFault {}

/// Adds what could not be done to an error that says why.
pub(crate) trait Context<T> {
    fn context<D: Display>(self, what: impl FnOnce() -> D) -> Result<T, LibraryFault>;
}

impl<T, E: Display> Context<T> for Result<T, E> {
    fn context<D: Display>(self, what: impl FnOnce() -> D) -> Result<T, LibraryFault> {
        self.map_err(|why| LibraryFault::because(what(), why))
    }
}
