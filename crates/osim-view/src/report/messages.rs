//! Lines that say what should be known, and what the exit status says.

use osim_inspect::MassMismatch;
use osim_model::messages::{Dialect, one_line};
use osim_model::{Finding, FindingCode};

/// Findings, one line each: `warning: line 12: message [code]`.
pub(crate) fn finding_lines(findings: &[Finding]) -> String {
    let mut text = String::new();
    for finding in findings {
        let line = finding.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        let severity = finding.severity.as_str();
        text.push_str(&format!("{severity}: {line}{} [{}]\n", finding.message, finding.code()));
    }
    text
}

/// A line about a model, called `name`, whose contacts carry a body of another mass.
pub fn mass_mismatch(name: &str, mismatch: &MassMismatch, dialect: &dyn Dialect) -> String {
    let message = mismatch.message().spelled(dialect);
    let line = format!("warning: {name}: {message} [{}]", FindingCode::MassSourcesDisagree);
    format!("{}\n", one_line(line))
}

/// In the row of a model that has nothing to show, because it has no contacts.
pub(crate) const NO_CONTACTS: &str = "no contacts";

/// Why the row of a model has nothing to show, by the code of its failure.
pub(crate) fn in_a_cell(code: &str) -> &'static str {
    match code {
        "no-contacts" => NO_CONTACTS,
        "no-models" => "no models",
        _ => "not read",
    }
}

/// How a run of the command ended.
///
/// ```
/// use osim_view::report::ExitStatus;
///
/// assert_eq!(ExitStatus::Failed.code(), 1);
/// // What came first counts, but for what ended the run.
/// assert_eq!(ExitStatus::Done.and(ExitStatus::Failed).and(ExitStatus::Done), ExitStatus::Failed);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExitStatus {
    Done,
    /// A model failed, or a result could not be written.
    Failed,
    Usage,
    /// Another run has a file.
    Busy,
    /// Stopped by Ctrl-C.
    Interrupted,
}

impl ExitStatus {
    pub const ALL: [Self; 5] = [Self::Done, Self::Failed, Self::Usage, Self::Busy, Self::Interrupted];

    pub const fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Failed => 1,
            Self::Usage => 2,
            Self::Busy => 3,
            // As shells have it for a program that SIGINT ended.
            Self::Interrupted => 130,
        }
    }

    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Done => "all done, and check found no error",
            Self::Failed => {
                "a model failed or needs an answer, check found an error, or a result could not be written (full disk)"
            }
            Self::Usage => "the call is wrong: nothing was done",
            Self::Busy => {
                "another run is writing the same files: nothing was done, the same call may be right later"
            }
            Self::Interrupted => "stopped by Ctrl-C or by a batch system: what was begun is finished",
        }
    }

    /// The status of a run whose other part ended with `other`.
    pub fn and(self, other: Self) -> Self {
        if self == Self::Done || other == Self::Interrupted { other } else { self }
    }
}
