//! What `check` found: data for the table, CSV, JSON and reports.

use osim_patch::{Severity, Warning, WarningCode};
use serde::{Serialize, Serializer};

/// Raised when a field changes its meaning or goes away.
const SCHEMA_VERSION: u32 = 1;

/// Everything found in one model. Serialised it is the JSON contract of `check`; `docs/json.md` describes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Report {
    pub schema_version: u32,
    /// The model as it was named.
    pub model: String,
    pub counts: Counts,
    /// From the worst to the least; equally bad ones in the order of the register.
    pub findings: Vec<Finding>,
}

/// How many findings of each severity.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Counts {
    pub error: usize,
    pub warn: usize,
    pub info: usize,
}

impl Counts {
    /// "1 error, 2 warnings"; `none` where there is nothing.
    pub(crate) fn told(self, none: &str) -> String {
        let all = [(self.error, "error"), (self.warn, "warning"), (self.info, "remark")];
        let parts: Vec<String> = all
            .into_iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, name)| format!("{count} {name}{}", if count == 1 { "" } else { "s" }))
            .collect();
        if parts.is_empty() { none.to_owned() } else { parts.join(", ") }
    }
}

/// One thing found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Finding {
    #[serde(serialize_with = "code")]
    pub code: WarningCode,
    #[serde(serialize_with = "severity")]
    pub severity: Severity,
    /// This case, in words.
    pub message: String,
    /// Why it matters, from the register.
    pub why: &'static str,
    /// What to do about it, from the register.
    pub remedy: &'static str,
    /// Component path of the force or sphere, where it is one; of the worst where it is several.
    pub place: Option<String>,
    /// Names of all spheres concerned, where it is about spheres.
    pub spheres: Vec<String>,
    /// Line in the model.
    pub line: Option<usize>,
    /// A command that mends it; `None` where only the user can know what to write.
    pub command: Option<String>,
}

fn code<S: Serializer>(code: &WarningCode, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(code.as_str())
}

fn severity<S: Serializer>(severity: &Severity, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(severity.as_str())
}

impl Finding {
    pub(crate) fn new(code: WarningCode, message: impl Into<String>) -> Self {
        Self {
            code,
            severity: code.severity(),
            message: message.into(),
            why: code.why(),
            remedy: code.remedy(),
            place: None,
            spheres: Vec::new(),
            line: None,
            command: None,
        }
    }

    pub(crate) fn at(self, place: Option<&str>, line: Option<usize>) -> Self {
        Self { place: place.map(str::to_owned), line, ..self }
    }

    pub(crate) fn mended_by(self, command: Option<String>) -> Self {
        Self { command, ..self }
    }
}

impl From<&Warning> for Finding {
    fn from(warning: &Warning) -> Self {
        Self::new(warning.code, warning.message.clone()).at(warning.subject.as_deref(), warning.line)
    }
}

impl Report {
    pub(crate) fn new(model: String, mut findings: Vec<Finding>) -> Self {
        findings.sort_by_key(|finding| (std::cmp::Reverse(finding.severity), finding.code, finding.line));
        let count = |severity| findings.iter().filter(|finding| finding.severity == severity).count();
        let counts = Counts {
            error: count(Severity::Error),
            warn: count(Severity::Warn),
            info: count(Severity::Info),
        };
        Self { schema_version: SCHEMA_VERSION, model, counts, findings }
    }

    /// `true` where something is as bad as `severity`, or worse.
    pub(crate) fn reaches(&self, severity: Severity) -> bool {
        self.findings.iter().any(|finding| finding.severity >= severity)
    }
}
