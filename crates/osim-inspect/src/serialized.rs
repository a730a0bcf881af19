//! What all JSON results share: their version, and warnings and phrases as they have them.

use osim_model::Warning;
use osim_model::wording::Phrase;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// The version of all JSON results: raised when a field of one changes its meaning or goes away.
pub const SCHEMA_VERSION: u32 = 1;

/// Something to know, as the JSON has it.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct WarningRecord {
    /// Stable short name.
    pub code: &'static str,
    /// This case, in words.
    pub message: String,
    /// Line in the model, where there is one.
    pub line: Option<usize>,
}

impl From<&Warning> for WarningRecord {
    fn from(warning: &Warning) -> Self {
        Self { code: warning.code.as_str(), message: warning.message.to_string(), line: warning.line }
    }
}

/// Serialises warnings as their records.
///
/// # Errors
/// Those of the serialiser.
pub(crate) fn warnings<S: Serializer>(warnings: &[Warning], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(warnings.iter().map(WarningRecord::from))
}

/// Serialises a phrase as its text.
///
/// # Errors
/// Those of the serialiser.
pub(crate) fn phrase<S: Serializer>(phrase: &Phrase, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(phrase)
}

/// The same of a phrase that may be absent.
///
/// # Errors
/// Those of the serialiser.
pub(crate) fn optional_phrase<S: Serializer>(
    phrase: &Option<Phrase>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    phrase.as_ref().map(ToString::to_string).serialize(serializer)
}
