//! Contacts of another model or of a preset.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::{
    AnswerOptions, CountOptions, FollowOptions, ForceOptions, MassOptions, OutputOptions, ReferenceOptions,
    RunOptions, ScalingOptions, SetFiles,
};
use crate::relation::Relation;
use crate::values::path;

/// Gives a model the contacts of another model or of a preset, at its own size.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct TransferRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Where the contacts come from: a model, or a preset such as falisse2022
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODEL|PRESET"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub from: Option<PathBuf>,
    /// A file with presets of your own (TOML)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub presets: Option<PathBuf>,
    /// How many spheres share the weight.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub counts: CountOptions,
    /// What the reference is.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub reference: ReferenceOptions,
    /// Whether spheres follow their bodies.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub follow: FollowOptions,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// What changes, and how.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub scaling: ScalingOptions,
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

impl TransferRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Required("models"), Relation::Required("from")],
        FollowOptions::RELATIONS,
        ScalingOptions::RELATIONS,
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}
