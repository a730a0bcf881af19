//! Writing down what the user knows of contacts: the mass they were made for, the limbs that share the weight.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::{AnswerOptions, OutputOptions, RunOptions, SetFiles};
use crate::relation::Relation;
use crate::values::{Acceleration, Count, Kilograms, path};

/// Writes into models which mass their contacts were made for, or how many limbs share the weight; no number changes.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct NoteRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Mass the contacts in the file were made for, kg
    #[cfg_attr(feature = "clap", arg(long, value_name = "KG", allow_hyphen_values = true))]
    pub contacts_mass: Option<Kilograms>,
    /// Gravity the contacts in the file were made for, m/s2 [default: the model's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G", allow_hyphen_values = true))]
    pub contacts_gravity: Option<Acceleration>,
    /// Limbs that share the body weight [default: as the note in the model says]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub stance_limbs: Option<Count>,
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

impl NoteRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Expected("models"), Relation::ExpectedUnless("contacts_mass", "stance_limbs")],
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}
