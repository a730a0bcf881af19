//! The words in which this program names its options: those of its command line, or of a request in JSON.

pub(crate) use osim_library::page::Words;
use osim_requests::spell::{CommandLine, JsonRequest};

/// Options as they are typed.
pub(crate) static WORDS: Words = &CommandLine;

/// Fields as a request has them.
pub(crate) static FIELDS: Words = &JsonRequest;
