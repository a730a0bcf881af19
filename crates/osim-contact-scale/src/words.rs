//! The words in which this program says what can be said: those of its command line, or of a request in JSON.

use osim_report::dialect::{CommandLine, FrontEnd, JsonRequest};

/// A front end's words that every thread can use.
pub(crate) type Words = &'static (dyn FrontEnd + Sync);

/// Options as they are typed.
pub(crate) static WORDS: Words = &CommandLine;

/// Fields as a request has them.
pub(crate) static FIELDS: Words = &JsonRequest;
