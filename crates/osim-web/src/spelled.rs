//! A request as calls that people can copy: of the command, of Python, of MATLAB.

use osim_requests::Request;
use osim_requests::spell::{CommandLine, Matlab, Python, Speller};
use serde::Serialize;

/// The three calls of one request. Each does what the request asks for: it reads the same models and writes the same files.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Calls {
    /// A line for a terminal.
    command: String,
    /// Lines of Python, from the import on.
    python: String,
    /// A line of MATLAB or GNU Octave.
    matlab: String,
}

impl Calls {
    pub(crate) fn of(request: &Request) -> Self {
        Self {
            command: CommandLine.script(request),
            python: Python.script(request),
            matlab: Matlab.script(request),
        }
    }
}
