//! What `check` found: data for the table, CSV, JSON and reports.

use std::cmp::Reverse;

use osim_model::wording::Phrase;
use osim_model::{Severity, Warning, WarningCode};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::remedy::{Remedy, RemedyDialect};
use crate::inspection::Inspection;
use crate::serialized::{SCHEMA_VERSION, phrase};

/// Everything found in one model. Serialised it is the JSON contract of `check`; `docs/json.md` describes it.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct CheckResult {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The model as it was named.
    pub model: String,
    /// Its name in bytes, where that is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// How many of each severity.
    pub counts: Counts,
    /// From the worst to the least; equally bad ones in the order of the register.
    pub findings: Vec<Finding>,
}

/// How many findings of each severity.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct Counts {
    /// What OpenSim computes otherwise than it looks, or as nonsense.
    pub error: usize,
    /// Limits of the paper, and traps.
    pub warn: usize,
    /// Worth knowing.
    pub info: usize,
}

impl Counts {
    /// "1 error, 2 warnings"; `none` where there is nothing.
    #[must_use]
    pub fn describe(self, none: &str) -> String {
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
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct Finding {
    /// Which kind.
    #[serde(serialize_with = "code")]
    #[schemars(with = "String")]
    pub code: WarningCode,
    /// How bad it is.
    #[serde(serialize_with = "severity")]
    #[schemars(with = "String")]
    pub severity: Severity,
    /// This case, in words.
    #[serde(serialize_with = "phrase")]
    #[schemars(with = "String")]
    pub message: Phrase,
    /// Why it matters, from the register.
    #[serde(serialize_with = "phrase")]
    #[schemars(with = "String")]
    pub why: Phrase,
    /// What to do about it, from the register.
    #[serde(rename = "remedy", serialize_with = "phrase")]
    #[schemars(with = "String")]
    pub advice: Phrase,
    /// Component path of the force or sphere, where it is one; of the worst where it is several.
    pub place: Option<String>,
    /// Names of all spheres concerned, where it is about spheres.
    pub spheres: Vec<String>,
    /// Line in the model.
    pub line: Option<usize>,
    /// A change that puts it right; `None` where only the user can know what to write.
    #[serde(skip)]
    pub remedy: Option<Remedy>,
    /// The same in the words of a front end, once [`CheckResult::spell`] was told them.
    pub command: Option<String>,
}

fn code<S: Serializer>(code: &WarningCode, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(code.as_str())
}

fn severity<S: Serializer>(severity: &Severity, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(severity.as_str())
}

impl Finding {
    /// A finding about the whole model.
    pub fn new(code: WarningCode, message: impl Into<Phrase>) -> Self {
        Self {
            code,
            severity: code.severity(),
            message: message.into(),
            why: code.why(),
            advice: code.remedy(),
            place: None,
            spheres: Vec::new(),
            line: None,
            remedy: None,
            command: None,
        }
    }

    /// The same at a component or a line.
    #[must_use]
    pub fn at(self, place: Option<&str>, line: Option<usize>) -> Self {
        Self { place: place.map(str::to_owned), line, ..self }
    }

    /// The same about these spheres, by name.
    #[must_use]
    pub fn about(self, spheres: Vec<String>) -> Self {
        Self { spheres, ..self }
    }

    pub(super) fn put_right_by(self, remedy: Option<Remedy>) -> Self {
        Self { remedy, ..self }
    }
}

impl From<&Warning> for Finding {
    fn from(warning: &Warning) -> Self {
        Self::new(warning.code, warning.message.clone()).at(warning.subject.as_deref(), warning.line)
    }
}

impl CheckResult {
    /// Everything found in a model, in any order.
    #[must_use]
    pub fn new(inspected: &Inspection, mut findings: Vec<Finding>) -> Self {
        findings.sort_by_key(|finding| (Reverse(finding.severity), finding.code, finding.line));
        let count = |severity| findings.iter().filter(|finding| finding.severity == severity).count();
        let counts = Counts {
            error: count(Severity::Error),
            warn: count(Severity::Warn),
            info: count(Severity::Info),
        };
        Self {
            schema_version: SCHEMA_VERSION,
            model: inspected.model.clone(),
            model_bytes: inspected.model_bytes.clone(),
            counts,
            findings,
        }
    }

    /// `true` where something is as bad as `severity`, or worse.
    #[must_use]
    pub fn reaches(&self, severity: Severity) -> bool {
        self.findings.iter().any(|finding| finding.severity >= severity)
    }

    /// Spells everything it says in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn RemedyDialect) {
        for finding in &mut self.findings {
            finding.message.spell(dialect);
            finding.why.spell(dialect);
            finding.advice.spell(dialect);
            finding.command = finding.remedy.as_ref().map(|remedy| dialect.remedy(remedy));
        }
    }
}
