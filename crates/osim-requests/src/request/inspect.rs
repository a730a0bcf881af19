//! Models looked at, and what the user knows of their contacts written down.

use std::path::PathBuf;

use osim_model::Severity;
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
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct InspectRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    #[serde(with = "path::Optional")]
    pub from: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub body_scale_file: Option<PathBuf>,
    pub target_mass: Option<Kilograms>,
    pub full: bool,
    pub format: SheetFormat,
    #[serde(flatten)]
    pub report: ReportOptions,
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
        Warning = "warning", "Limits of the paper and traps, too";
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
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct CheckRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    #[serde(with = "path::Optional")]
    pub from: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub body_scale_file: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub moco_setup: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub from_moco_setup: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub motion: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub plates: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub loads: Option<PathBuf>,
    pub angles: Option<AngleChoice>,
    pub full: bool,
    pub deny: Deny,
    pub format: SheetFormat,
    #[serde(flatten)]
    pub report: ReportOptions,
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
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct NoteRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    pub contacts_mass: Option<Kilograms>,
    pub contacts_gravity: Option<Acceleration>,
    pub stance_limbs: Option<Count>,
    #[serde(flatten)]
    pub output: OutputOptions,
    #[serde(flatten)]
    pub run: RunOptions,
    #[serde(flatten)]
    pub answers: AnswerOptions,
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
