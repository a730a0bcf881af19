//! How a model is inspected.

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::answers::AnswerOptions;
use super::forces::ForceOptions;
use super::load::StanceOptions;
use super::masses::MassOptions;
use super::set_files::SetFiles;

/// How a model is inspected.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct InspectionOptions {
    /// Under what load.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub stance: StanceOptions,
    /// Whose weight.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// Which forces.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Files of a standalone set.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub set_files: SetFiles,
    /// Answers to questions.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

impl InspectionOptions {
    /// These groups.
    #[must_use]
    pub fn new(
        stance: StanceOptions,
        masses: MassOptions,
        choice: ForceOptions,
        set_files: SetFiles,
    ) -> Self {
        Self { stance, masses, choice, set_files, answers: AnswerOptions::default() }
    }
}
