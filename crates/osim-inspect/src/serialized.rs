//! What all JSON results share: their version, and findings and phrases as they have them.

use osim_model::Finding;
use osim_model::wording::Phrase;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// Raised when a field of any result changes its meaning or goes away.
pub const SCHEMA_VERSION: u32 = 1;

/// One finding, as every JSON has it: of a model, of a check, of a change.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct FindingRecord {
    /// Stable short name.
    pub code: &'static str,
    /// How bad it is: `error`, `warn` or `info`.
    pub severity: &'static str,
    /// This case, in words.
    pub message: String,
    /// Why it matters, the same for every case.
    pub why: String,
    /// What to do about it, the same for every case.
    pub advice: String,
    /// Component path of the force or sphere, where it is one; of the worst where it is several.
    pub place: Option<String>,
    /// Names of all spheres concerned, where it is about spheres.
    pub spheres: Vec<String>,
    /// Line in the model, where there is one.
    pub line: Option<usize>,
    /// The call that puts it right, where `check` can propose one.
    pub command: Option<String>,
}

impl From<&Finding> for FindingRecord {
    fn from(finding: &Finding) -> Self {
        Self {
            code: finding.code.as_str(),
            severity: finding.code.severity().as_str(),
            message: finding.message.to_string(),
            why: finding.why.to_string(),
            advice: finding.advice.to_string(),
            place: finding.place.clone(),
            spheres: finding.spheres.clone(),
            line: finding.line,
            command: finding.command.clone(),
        }
    }
}

/// Serialises findings as their records.
///
/// # Errors
/// Those of the serialiser.
pub(crate) fn records<S: Serializer>(findings: &[Finding], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(findings.iter().map(FindingRecord::from))
}

/// Serialises a phrase that may be absent as its text.
///
/// # Errors
/// Those of the serialiser.
pub(crate) fn optional_phrase<S: Serializer>(
    phrase: &Option<Phrase>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    phrase.as_ref().map(ToString::to_string).serialize(serializer)
}
