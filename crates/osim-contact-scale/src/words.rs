//! The words in which this program says what can be said: those of its command line, or of a request in JSON.

use osim_report::dialect::{CommandLine, JsonRequest};
pub(crate) use osim_runs::Words;

/// Options as they are typed.
pub(crate) static WORDS: Words = &CommandLine;

/// Fields as a request has them.
pub(crate) static FIELDS: Words = &JsonRequest;
