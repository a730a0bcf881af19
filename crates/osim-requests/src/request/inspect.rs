//! Requests to inspect models alone, along a recorded motion, and in a fall; and to write facts about their contacts into a note.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{
    AnswerOptions, ContactNumbers, CountOptions, Deny, ForceOptions, InspectionOptions, MassOptions,
    OutputOptions, ReportOptions, RunOptions, SetFiles, SheetFormat,
};
use crate::values::serial::choices;
use crate::values::{Acceleration, Count, Height, Kilograms, Positive, Samples, Speed, path};

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
    pub fix: bool,
    #[serde(with = "path::Optional")]
    pub output: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub output_dir: Option<PathBuf>,
    pub in_place: bool,
    #[serde(flatten)]
    pub report: ReportOptions,
    #[serde(flatten)]
    pub options: InspectionOptions,
}

impl CheckRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[&[
        Relation::Required("models"),
        Relation::Needs("body_scale_file", "from"),
        Relation::Needs("moco_setup", "from"),
        Relation::Needs("from_moco_setup", "moco_setup"),
        Relation::Needs("motion", "plates"),
        Relation::Needs("plates", "motion"),
        Relation::Needs("loads", "motion"),
        Relation::Needs("angles", "motion"),
        Relation::Needs("output", "fix"),
        Relation::Needs("output_dir", "fix"),
        Relation::Needs("in_place", "fix"),
        Relation::Excludes("output_dir", "output"),
        Relation::Excludes("in_place", "output"),
        Relation::Excludes("in_place", "output_dir"),
    ]];

    /// The options for the results of `fix`.
    pub fn output(&self) -> OutputOptions {
        OutputOptions {
            output: self.output.clone(),
            output_dir: self.output_dir.clone(),
            in_place: self.in_place,
            force: self.report.force,
            ..OutputOptions::default()
        }
    }
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

choices! {
    /// The unit of the angles of a motion.
    AngleChoice {
        Degrees = "degrees";
        Radians = "radians";
    }
}

choices! {
    /// How a motion is shown.
    MotionFormat: Table {
        Table = "table", "In sentences, and with the values of each foot and sphere";
        Json = "json", "One JSON object";
        Csv = "csv", "One row per frame, sphere and force";
    }
}

/// Shows what contacts do along a recorded motion, beside what force plates measured.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct MotionRequest {
    #[serde(with = "path::Optional")]
    pub subject: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub motion: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub plates: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub loads: Option<PathBuf>,
    pub angles: Option<AngleChoice>,
    pub low_pass: Option<Positive>,
    pub belt: Option<Speed>,
    pub belt_column: Option<String>,
    #[serde(with = "path::Optional")]
    pub output: Option<PathBuf>,
    pub force: bool,
    pub format: MotionFormat,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub set_files: SetFiles,
}

impl MotionRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[&[
        Relation::Required("subject"),
        Relation::Required("motion"),
        Relation::Needs("loads", "plates"),
        Relation::Excludes("belt", "belt_column"),
    ]];
}

choices! {
    /// How a drop is shown.
    SeriesFormat: Table {
        Table = "table", "Figures (and a chart on a terminal)";
        Json = "json", "One JSON object";
        Csv = "csv", "The series, one row per moment";
    }
}

/// Lets a model fall on its contacts and shows what they do.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct DropTestRequest {
    #[serde(with = "path::Optional")]
    pub subject: Option<PathBuf>,
    pub height: Height,
    pub duration: Positive,
    pub samples: Samples,
    #[serde(with = "path::Optional")]
    pub compare: Option<PathBuf>,
    pub compare_spheres: Option<Count>,
    #[serde(with = "path::Optional")]
    pub presets: Option<PathBuf>,
    pub format: SeriesFormat,
    #[serde(flatten)]
    pub numbers: ContactNumbers,
    #[serde(flatten)]
    pub counts: CountOptions,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub set_files: SetFiles,
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

impl Default for DropTestRequest {
    fn default() -> Self {
        Self {
            subject: None,
            height: Height::default(),
            duration: Positive::DROP_DURATION_S,
            samples: Samples::default(),
            compare: None,
            compare_spheres: None,
            presets: None,
            format: SeriesFormat::Table,
            numbers: ContactNumbers::default(),
            counts: CountOptions::default(),
            masses: MassOptions::default(),
            choice: ForceOptions::default(),
            set_files: SetFiles::default(),
            answers: AnswerOptions::default(),
        }
    }
}

impl DropTestRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] =
        &[&[Relation::Needs("compare_spheres", "compare")]];
}
