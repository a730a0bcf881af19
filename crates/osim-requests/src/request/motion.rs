//! Contacts along a recorded motion, and in a fall.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{AnswerOptions, ContactNumbers, CountOptions, ForceOptions, MassOptions, SetFiles};
use crate::values::serial::choices;
use crate::values::{Count, Height, Positive, Samples, Speed, path};

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
        Table = "table", "In words, and figures of each foot and sphere";
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
