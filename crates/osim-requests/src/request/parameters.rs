//! Requests for contact parameters: from wanted behaviour, and from a measurement.

use std::path::PathBuf;

use contact_scaling::fit::Branch;
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{
    AnswerOptions, ColumnOptions, CountOptions, ForceOptions, LoadOptions, MassOptions, OutputOptions,
    RunOptions, SetFiles, WantedOptions,
};
use crate::request::inspect::AngleChoice;
use crate::values::serial::choices;
use crate::values::{ContactOnset, Count, Positive, Speed, path};

/// Finds parameters from what is wanted: indentation, stiffness, restitution.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct DesignRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    #[serde(flatten)]
    pub wanted: WantedOptions,
    #[serde(flatten)]
    pub load: LoadOptions,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub counts: CountOptions,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub output: OutputOptions,
    #[serde(flatten)]
    pub run: RunOptions,
    #[serde(flatten)]
    pub answers: AnswerOptions,
    #[serde(flatten)]
    pub set_files: SetFiles,
}

impl DesignRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] =
        &[WantedOptions::RELATIONS, LoadOptions::RELATIONS, OutputOptions::RELATIONS, RunOptions::RELATIONS];
}

// Contact parameters from a measurement: of one contact, or of a gait.

choices! {
    /// Which part of a measurement.
    BranchChoice: Both {
        Both = "both";
        Loading = "loading";
        Unloading = "unloading";
    }
}

choices! {
    /// A parameter that is fitted to a recording.
    FittedChoice {
        Stiffness = "stiffness", "All stiffnesses, by one factor";
        Dissipation = "dissipation", "The dissipation of all forces";
        Height = "height", "How high the floor is";
    }
}

choices! {
    /// The object that a fitted height moves.
    HeightChoice: Floor {
        Floor = "floor", "The floor, along its normal: spheres stay on the sole";
        Spheres = "spheres", "All spheres, in their bodies: the floor stays";
    }
}

impl BranchChoice {
    pub const fn branch(self) -> Branch {
        match self {
            Self::Both => Branch::Both,
            Self::Loading => Branch::Loading,
            Self::Unloading => Branch::Unloading,
        }
    }
}

/// Finds contact parameters from a measured indentation and force, or those of a model from recordings of its gait.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct FitRequest {
    #[serde(with = "path::Optional")]
    pub file: Option<PathBuf>,
    #[serde(with = "path::List")]
    pub motion: Vec<PathBuf>,
    #[serde(with = "path::List")]
    pub plates: Vec<PathBuf>,
    #[serde(with = "path::List")]
    pub loads: Vec<PathBuf>,
    pub fit: Vec<FittedChoice>,
    pub unbounded: bool,
    pub height_in: HeightChoice,
    pub belt: Option<Speed>,
    pub belt_column: Option<String>,
    pub angles: Option<AngleChoice>,
    pub low_pass: Option<Positive>,
    pub radius: Option<Positive>,
    pub spheres: Count,
    pub onset: ContactOnset,
    pub branch: BranchChoice,
    #[serde(flatten)]
    pub columns: ColumnOptions,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub output: OutputOptions,
    #[serde(flatten)]
    pub run: RunOptions,
    #[serde(flatten)]
    pub answers: AnswerOptions,
    #[serde(flatten)]
    pub set_files: SetFiles,
}

impl FitRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[
            Relation::Required("file"),
            Relation::RequiredUnless("radius", "motion"),
            Relation::Needs("motion", "plates"),
            Relation::Needs("plates", "motion"),
            Relation::Needs("loads", "motion"),
            Relation::Needs("fit", "motion"),
            Relation::Needs("unbounded", "motion"),
            Relation::Needs("height_in", "motion"),
            Relation::Needs("belt", "motion"),
            Relation::Needs("belt_column", "motion"),
            Relation::Excludes("belt", "belt_column"),
            Relation::Needs("angles", "motion"),
            Relation::Needs("low_pass", "motion"),
            Relation::Needs("output", "motion"),
            Relation::Needs("output_dir", "motion"),
            Relation::Needs("in_place", "motion"),
            Relation::Needs("report", "motion"),
            Relation::Needs("summary", "motion"),
            Relation::Excludes("radius", "motion"),
            Relation::Excludes("spheres", "motion"),
            Relation::Excludes("onset", "motion"),
            Relation::Excludes("branch", "motion"),
            Relation::Excludes("indentation_column", "motion"),
            Relation::Excludes("force_column", "motion"),
            Relation::Excludes("speed_column", "motion"),
            Relation::Excludes("time_column", "motion"),
            Relation::Excludes("indentation_unit", "motion"),
            Relation::Excludes("force_unit", "motion"),
            Relation::Excludes("speed_unit", "motion"),
            Relation::Excludes("time_unit", "motion"),
        ],
        ColumnOptions::RELATIONS,
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];

    /// Whether a model is fitted to recorded motions, and not a contact to one measured curve.
    pub fn is_of_motion(&self) -> bool {
        !self.motion.is_empty()
    }
}
