//! The JSON contract of what went wrong.

use osim_inspect::SCHEMA_VERSION;
use osim_model::files::Failure;
use osim_model::messages::Dialect;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

/// One model that could not be done.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct FailureRecord {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The file, as it was named.
    pub model: String,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// What went wrong.
    pub error: ErrorRecord,
}

/// What went wrong.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct ErrorRecord {
    /// Stable short name.
    pub code: &'static str,
    /// What is wrong, what was expected, and a way out.
    pub message: String,
    /// Line of the place, from 1.
    pub line: Option<usize>,
    /// Column of the place in characters, from 1.
    pub column: Option<usize>,
}

impl FailureRecord {
    /// A failure in the words of `dialect`.
    #[must_use]
    pub fn new(failure: &Failure, dialect: &dyn Dialect) -> Self {
        let (model, model_bytes) = failure.model.clone().into_parts();
        Self {
            schema_version: SCHEMA_VERSION,
            model,
            model_bytes,
            error: ErrorRecord {
                code: failure.code,
                message: failure.message.spelled(dialect),
                line: failure.line,
                column: failure.column,
            },
        }
    }
}
