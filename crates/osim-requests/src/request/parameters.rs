//! Contact parameters: from what is wanted, and from a measurement.

use std::path::PathBuf;

use contact_scaling::fit::Branch;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::motion::AngleChoice;
use crate::fault::Relation;
use crate::options::{
    AnswerOptions, ColumnOptions, CountOptions, ForceOptions, LoadOptions, MassOptions, OutputOptions,
    RunOptions, SetFiles, WantedOptions,
};
use crate::values::serial::choices;
use crate::values::{ContactOnset, Count, Positive, Speed, path};

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

// Contact parameters from a measurement: of one contact, or of a gait.

choices! {
    /// Which part of a measurement.
    BranchChoice: Both {
        /// All of it.
        Both = "both";
        /// While the indentation grows.
        Loading = "loading";
        /// While it shrinks.
        Unloading = "unloading";
    }
}

choices! {
    /// What is fitted to a recording.
    FittedChoice {
        /// E₁*: all stiffnesses by one factor.
        Stiffness = "stiffness", "All stiffnesses, by one factor";
        /// α of all forces.
        Dissipation = "dissipation", "The dissipation of all forces";
        /// How high the floor is.
        Height = "height", "How high the floor is";
    }
}

choices! {
    /// What a fitted height moves.
    HeightChoice: Floor {
        /// The floor, along its normal.
        Floor = "floor", "The floor, along its normal: spheres stay on the sole";
        /// All spheres, in their bodies.
        Spheres = "spheres", "All spheres, in their bodies: the floor stays";
    }
}

impl BranchChoice {
    /// The branch.
    pub const fn branch(self) -> Branch {
        match self {
            Self::Both => Branch::Both,
            Self::Loading => Branch::Loading,
            Self::Unloading => Branch::Unloading,
        }
    }
}

/// Finds contact parameters from a measured indentation and force, or those of a model from recordings of its gait.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct FitRequest {
    /// Measured indentation and force (.csv; - is standard input); with `motion`, the model (.osim)
    #[cfg_attr(feature = "clap", arg(value_name = "FILE|MODEL"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub file: Option<PathBuf>,
    /// Fit the model to this motion (.mot, .sto), so that its forces are the measured ones; may be repeated, for several trials
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", help_heading = "To a recording"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub motion: Vec<PathBuf>,
    /// Ground reactions that force plates measured (.mot, .sto); one for each motion
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", help_heading = "To a recording"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub plates: Vec<PathBuf>,
    /// OpenSim's ExternalLoads (.xml); one for each motion, or one for all
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", help_heading = "To a recording"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub loads: Vec<PathBuf>,
    /// What to fit; may be repeated [default: stiffness, dissipation and height]
    #[cfg_attr(
        feature = "clap",
        arg(long = "fit", value_name = "WHAT", value_enum, help_heading = "To a recording")
    )]
    pub fit: Vec<FittedChoice>,
    /// Let spheres go deeper than their radius
    #[cfg_attr(feature = "clap", arg(long, help_heading = "To a recording"))]
    pub unbounded: bool,
    /// What a fitted height moves
    #[cfg_attr(
        feature = "clap",
        arg(long, value_name = "WHAT", value_enum, default_value_t, help_heading = "To a recording")
    )]
    pub height_in: HeightChoice,
    /// Speed of a treadmill's belt against x, m/s: slip is taken against it
    #[cfg_attr(
        feature = "clap",
        arg(long, value_name = "M/S", allow_hyphen_values = true, help_heading = "To a recording")
    )]
    pub belt: Option<Speed>,
    /// The same, from this column of each motion
    #[cfg_attr(
        feature = "clap",
        arg(long, hide_short_help = true, value_name = "NAME", help_heading = "To a recording")
    )]
    pub belt_column: Option<String>,
    /// The unit of the motions' angles, where their headers do not say it
    #[cfg_attr(feature = "clap", arg(long, value_enum, help_heading = "To a recording"))]
    pub angles: Option<AngleChoice>,
    /// Smooth the coordinates first: zero-lag Butterworth filter of 4th order, cutoff in Hz (6 is usual for walking)
    #[cfg_attr(feature = "clap", arg(long, value_name = "HZ", help_heading = "To a recording"))]
    pub low_pass: Option<Positive>,
    /// Sphere radius, m
    #[cfg_attr(feature = "clap", arg(long, value_name = "M"))]
    pub radius: Option<Positive>,
    /// Spheres that share the measured force
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", default_value_t = Count::ONE))]
    pub spheres: Count,
    /// Where contact begins, in metres, or fit to find it
    #[cfg_attr(
        feature = "clap",
        arg(long, value_name = "M|fit", default_value_t, allow_hyphen_values = true)
    )]
    pub onset: ContactOnset,
    /// Which part of the measurement
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub branch: BranchChoice,
    /// Columns and units.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub columns: ColumnOptions,
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

impl Default for FitRequest {
    fn default() -> Self {
        Self {
            file: None,
            motion: Vec::new(),
            plates: Vec::new(),
            loads: Vec::new(),
            fit: Vec::new(),
            unbounded: false,
            height_in: HeightChoice::Floor,
            belt: None,
            belt_column: None,
            angles: None,
            low_pass: None,
            radius: None,
            spheres: Count::ONE,
            onset: ContactOnset::default(),
            branch: BranchChoice::Both,
            columns: ColumnOptions::default(),
            masses: MassOptions::default(),
            choice: ForceOptions::default(),
            output: OutputOptions::default(),
            run: RunOptions::default(),
            answers: AnswerOptions::default(),
            set_files: SetFiles::default(),
        }
    }
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

    /// Whether a model is fitted to recordings, and not a contact to one curve.
    pub fn is_of_motion(&self) -> bool {
        !self.motion.is_empty()
    }
}
