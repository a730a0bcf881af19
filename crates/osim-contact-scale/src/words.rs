//! The words in which this program says what can be said: those of its command line.

use osim_report::dialect::{CommandLine, FrontEnd};

/// A front end's words that every thread can use.
pub(crate) type Words = &'static (dyn FrontEnd + Sync);

/// Options as they are typed.
pub(crate) static WORDS: Words = &CommandLine;
