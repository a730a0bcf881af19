//! Plain values and factors.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::{AnswerOptions, ForceOptions, MassOptions, OutputOptions, RunOptions, SetFiles};
use crate::relation::Relation;
use crate::values::{Assignments, path};

/// Sets properties to a value, or multiplies them by a factor.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct SetRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    // The command line has models and assignments in one list of words.
    #[cfg_attr(feature = "clap", arg(skip))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Properties by OpenSim's names, each with its value, or with a factor such as "x2"
    #[cfg_attr(feature = "clap", arg(skip))]
    pub set: Assignments,
    /// Move spheres down until all spheres of a foot are as low as its lowest one, at the default pose
    #[cfg_attr(feature = "clap", arg(long, help_heading = "What changes"))]
    pub level: bool,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
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

impl SetRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Expected("models"), Relation::RequiredUnless("set", "level")],
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}
