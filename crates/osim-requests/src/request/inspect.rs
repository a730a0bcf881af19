//! Models looked at, and what the user knows of their contacts written down.

use std::path::PathBuf;

use osim_model::Severity;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::motion::AngleChoice;
use crate::fault::Relation;
use crate::options::{
    AnswerOptions, InspectionOptions, OutputOptions, ReportOptions, RunOptions, SetFiles, SheetFormat,
};
use crate::values::serial::choices;
use crate::values::{Acceleration, Count, Kilograms, path};

/// Shows what contacts models have.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct InspectRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// The generic model this one was scaled from: show each body's factors
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODEL"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub from: Option<PathBuf>,
    /// With `from`: the ScaleSet that the Scale Tool applied
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub body_scale_file: Option<PathBuf>,
    /// List what else would follow the size of a body of this mass, kg: muscles, springs, actuators
    #[cfg_attr(feature = "clap", arg(long, value_name = "KG", allow_hyphen_values = true))]
    pub target_mass: Option<Kilograms>,
    /// Show everything: each model, all rows, all explanations, all digits
    #[cfg_attr(feature = "clap", arg(long))]
    pub full: bool,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: SheetFormat,
    /// The page for browsers.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub report: ReportOptions,
    /// How models are inspected.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub options: InspectionOptions,
}

impl InspectRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Required("models"), Relation::Needs("body_scale_file", "from")],
        ReportOptions::RELATIONS,
    ];
}

choices! {
    /// From which severity on a finding is a failure.
    Deny: Error {
        /// Limits of the paper and traps, too.
        Warning = "warning", "Limits of the paper and traps, too";
        /// What OpenSim computes differently from what is written, or wrongly.
        Error = "error", "What OpenSim computes differently from what is written, or wrongly";
    }
}

impl Deny {
    /// The severity.
    pub const fn severity(self) -> Severity {
        match self {
            Self::Warning => Severity::Warning,
            Self::Error => Severity::Error,
        }
    }
}

/// Compares models with the limits of the paper and the traps of the format.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct CheckRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// The generic model this one was scaled from: whether its spheres followed, and what else follows size
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODEL"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub from: Option<PathBuf>,
    /// With `from`: the ScaleSet that the Scale Tool applied
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub body_scale_file: Option<PathBuf>,
    /// With `from`: list what else follows size in this Moco setup (.omoco), too
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub moco_setup: Option<PathBuf>,
    /// With `moco_setup`: the Moco setup of the generic model, to compare with
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub from_moco_setup: Option<PathBuf>,
    /// Say whether the contacts fit this motion (.mot, .sto), too
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub motion: Option<PathBuf>,
    /// With `motion`: the ground reactions that force plates measured (.mot, .sto)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub plates: Option<PathBuf>,
    /// With `motion`: OpenSim's ExternalLoads (.xml)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub loads: Option<PathBuf>,
    /// With `motion`: the unit of its angles, where its header does not say it
    #[cfg_attr(feature = "clap", arg(long, value_enum, hide_short_help = true))]
    pub angles: Option<AngleChoice>,
    /// Show everything: each model, all rows, all explanations, all digits
    #[cfg_attr(feature = "clap", arg(long))]
    pub full: bool,
    /// Exit with 1 where a finding is as bad as this, or worse
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub deny: Deny,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: SheetFormat,
    /// The page for browsers.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub report: ReportOptions,
    /// How models are inspected.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub options: InspectionOptions,
}

impl CheckRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[
            Relation::Required("models"),
            Relation::Needs("body_scale_file", "from"),
            Relation::Needs("moco_setup", "from"),
            Relation::Needs("from_moco_setup", "moco_setup"),
            Relation::Needs("motion", "plates"),
            Relation::Needs("plates", "motion"),
            Relation::Needs("loads", "motion"),
            Relation::Needs("angles", "motion"),
        ],
        ReportOptions::RELATIONS,
    ];
}

// Writing down what the user knows of contacts: the mass they were made for, the limbs that share the weight.

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
