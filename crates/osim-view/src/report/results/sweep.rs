//! The JSON contract of a sweep's end.

use std::path::Path;

use osim_inspect::SCHEMA_VERSION;
use osim_model::files::FileName;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

/// The end of a sweep, for scripts.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct SweepRecord {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The model, as it was named.
    pub model: String,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// The table that says what is in which file; null if nothing was made.
    pub manifest: Option<String>,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub manifest_bytes: Option<Vec<u8>>,
    /// The folder of the variants.
    pub folder: String,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub folder_bytes: Option<Vec<u8>>,
    /// How many points the grid has, or steps the ladder: they are counted from 1 to this number.
    pub points: usize,
    /// With `point`: the file of that point, by its name in `folder`.
    pub file: Option<String>,
    /// How many models are there as they should be, or would be: of all points, of the one that `point` names, or of a share.
    pub models: usize,
    /// How many of these an earlier sweep had made.
    pub done_before: usize,
    /// How many could not be made.
    pub failed: usize,
}

impl SweepRecord {
    /// A sweep of `model` into `folder`.
    #[must_use]
    pub fn new(model: &FileName, folder: &Path, manifest: Option<&Path>) -> Self {
        let (model, model_bytes) = model.clone().into_parts();
        let (folder, folder_bytes) = FileName::from(folder).into_parts();
        let (manifest, manifest_bytes) = manifest.map(|path| FileName::from(path).into_parts()).unzip();
        Self {
            schema_version: SCHEMA_VERSION,
            model,
            model_bytes,
            manifest,
            manifest_bytes: manifest_bytes.flatten(),
            folder,
            folder_bytes,
            points: 0,
            file: None,
            models: 0,
            done_before: 0,
            failed: 0,
        }
    }

    /// The same with how many points there are, and the file of the one that was asked for.
    #[must_use]
    pub fn of_points(self, points: usize, file: Option<String>) -> Self {
        Self { points, file, ..self }
    }

    /// The same with how many models were made and failed.
    #[must_use]
    pub fn counted(self, models: usize, failed: usize) -> Self {
        Self { models, failed, ..self }
    }

    /// The same with how many of its models an earlier sweep had made.
    #[must_use]
    pub fn of_which_before(self, done_before: usize) -> Self {
        Self { done_before, ..self }
    }
}
