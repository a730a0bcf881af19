//! The words in which this program names its options: those of its command line, of a request in JSON, or of the functions
//! that send one.

use clap::ValueEnum;
pub(crate) use osim_library::page::Words;
use osim_requests::spell::{CommandLine, JsonRequest, Matlab};

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
