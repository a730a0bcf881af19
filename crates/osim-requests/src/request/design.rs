//! Parameters from what is wanted.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::{
    AnswerOptions, CountOptions, ForceOptions, LoadOptions, MassOptions, OutputOptions, RunOptions, SetFiles,
    WantedOptions,
};
use crate::relation::Relation;
use crate::values::path;

/// Finds parameters from what is wanted: indentation, stiffness, restitution.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct DesignRequest {
    /// Models to write the design into; without one, a calculator
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// What is wanted or known.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub wanted: WantedOptions,
    /// The load.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub load: LoadOptions,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// How many spheres share the load.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub counts: CountOptions,
    /// Which forces.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Where results go.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub output: OutputOptions,
    /// How to go about the work.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub run: RunOptions,
    /// Answers to questions.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub answers: AnswerOptions,
    /// Files of a standalone set.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub set_files: SetFiles,
}

impl DesignRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] =
        &[WantedOptions::RELATIONS, LoadOptions::RELATIONS, OutputOptions::RELATIONS, RunOptions::RELATIONS];
}
