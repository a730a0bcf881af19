//! Lines of messages about findings, masses and contacts, and the meanings of exit statuses.

use osim_inspect::MassMismatch;
use osim_model::messages::{Dialect, one_line};
use osim_model::{Finding, FindingCode, Severity};

/// The findings, one on each line: `warning: line 12, column 5: message [code]`. Findings that the model had before the change share one line with
/// their codes.
pub(crate) fn finding_lines(findings: &[Finding]) -> String {
    let mut text = String::new();
    let (before, new): (Vec<&Finding>, Vec<&Finding>) = findings.iter().partition(|one| one.had_before);
    for finding in new {
        let place = finding.position.map(|at| format!("{at}: ")).unwrap_or_default();
        let severity = finding.severity.as_str();
        text.push_str(&format!("{severity}: {place}{} [{}]\n", finding.message, finding.code()));
    }
    let severities = [Severity::Error, Severity::Warning, Severity::Remark];
    let of_severity = severities.into_iter().filter_map(|severity| {
        let mut codes: Vec<&str> =
            before.iter().filter(|one| one.severity == severity).map(|one| one.code().as_str()).collect();
        codes.dedup();
        (!codes.is_empty()).then(|| format!("{} {}", severity.as_str(), codes.join(", ")))
    });
    let as_before = of_severity.collect::<Vec<_>>().join("; ");
    if !as_before.is_empty() {
        text.push_str(&format!("as before: {as_before}\n"));
    }
    text
}

/// A line about a model, called `name`, whose contacts are made for another mass than the mass of its bodies.
pub fn mass_mismatch(name: &str, mismatch: &MassMismatch, dialect: &dyn Dialect) -> String {
    let message = mismatch.message().spelled(dialect);
    let line = format!("warning: {name}: {message} [{}]", FindingCode::MassSourcesDisagree);
    format!("{}\n", one_line(line))
}

/// The text in the row of a model that has no contacts, so that there is nothing to show.
pub(crate) const NO_CONTACTS_CELL: &str = "no contacts";

/// The text in the row of a model with a failure, by the code of the failure.
pub(crate) fn failure_in_cell(code: &str) -> &'static str {
    match code {
        "no-contacts" => NO_CONTACTS_CELL,
        "no-models" => "no models",
        _ => "not read",
    }
}

/// The way in which a run of the program ended.
///
/// ```
/// use osim_view::report::ExitStatus;
///
/// assert_eq!(ExitStatus::Failed.code(), 1);
/// // What came first counts, but for what ended the run.
/// assert_eq!(ExitStatus::Done.plus(ExitStatus::Failed).plus(ExitStatus::Done), ExitStatus::Failed);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExitStatus {
    Done = 0,
    /// A model failed, or a result could not be written.
    Failed = 1,
    Usage = 2,
    /// Another run of the program is writing a file that this run has to write.
    Busy = 3,
    /// Ctrl-C or a batch system stopped the run. Shells have this number for a program that SIGINT ended.
    Interrupted = 130,
}

impl ExitStatus {
    pub const ALL: [Self; 5] = [Self::Done, Self::Failed, Self::Usage, Self::Busy, Self::Interrupted];

    pub const fn code(self) -> u8 {
        self as u8
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

    /// The status of a run that has two parts, if the other part ended with `other`.
    pub fn plus(self, other: Self) -> Self {
        if self == Self::Done || other == Self::Interrupted { other } else { self }
    }
}
