//! A request as a call that people can copy: of the command, of Python, of MATLAB.
//!
//! Each call does what the request asks for: it reads the same models and writes the same files. What is only about a terminal,
//! such as `quiet`, is left out where there is none.

mod command;
mod fields;
mod matlab;
mod python;

use osim_report::dialect::shell_quoted;
use osim_requests::Request;
use serde::Serialize;

use fields::Fields;

/// The three calls of one request.
///
/// Texts are as they are in the request, with the quotation marks of each language. Only a name of a file that a shell or Python
/// would take for something else gets `./` before it. A name that is not UTF-8 cannot be copied: it has U+FFFD in it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Calls {
    /// A line for a terminal: for POSIX shells, and for PowerShell and cmd where nothing in it would be expanded by a POSIX shell.
    pub command: String,
    /// Lines of Python, from the import on.
    pub python: String,
    /// A line of MATLAB or GNU Octave.
    pub matlab: String,
}

/// The calls of `request`: of a change, of `inspect` and `check`, or of `design` without a model.
///
/// Other verbs have arguments without a name that are not models; their calls are not spelled rightly here.
///
/// ```
/// use osim_requests::Request;
/// use osim_web::spelled::calls;
///
/// let request = br#"{"verb": "rescale", "models": "human.osim", "target_mass": 500}"#;
/// let calls = calls(&Request::from_json(request)?);
/// assert_eq!(calls.command, "osim-contact-scale rescale human.osim --target-mass 500");
/// assert_eq!(calls.matlab, "result = osimcontact.rescale('human.osim', 'TargetMass', 500);");
/// # Ok::<(), osim_requests::RequestFault>(())
/// ```
#[must_use]
pub fn calls(request: &Request) -> Calls {
    let fields = Fields::of(request);
    Calls {
        command: command::command(&fields),
        python: python::python(&fields),
        matlab: matlab::matlab(&fields),
    }
}

/// The command of `request` as a report has it: with the quotation marks that the command itself would show.
pub(crate) fn in_report(request: &Request) -> String {
    command::line(&Fields::of(request), shell_quoted)
}
