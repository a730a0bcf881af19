//! The JSON contract of a sweep's end.

use schemars::JsonSchema;
use serde::Serialize;

const SCHEMA_VERSION: u32 = 1;

/// The end of a sweep, for scripts.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct SweepRecord {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The model, as it was named.
    pub model: String,
    /// The table that says what is in which file; none where nothing was made.
    pub manifest: Option<String>,
    /// The folder of the variants.
    pub folder: String,
    /// How many models were made, or would be.
    pub models: usize,
    /// How many could not be made.
    pub failed: usize,
}

impl SweepRecord {
    /// A sweep of `model` into `folder`.
    #[must_use]
    pub fn new(model: &str, folder: &std::path::Path, manifest: Option<&std::path::Path>) -> Self {
        Self {
            schema_version: SCHEMA_VERSION,
            model: model.to_owned(),
            manifest: manifest.map(|path| path.display().to_string()),
            folder: folder.display().to_string(),
            models: 0,
            failed: 0,
        }
    }

    /// The same with how many models were made and failed.
    #[must_use]
    pub fn counted(self, models: usize, failed: usize) -> Self {
        Self { models, failed, ..self }
    }
}
