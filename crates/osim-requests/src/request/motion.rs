//! Contacts along a recorded motion, and in a fall.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{AnswerOptions, ContactNumbers, CountOptions, ForceOptions, MassOptions, SetFiles};
use crate::values::serial::choices;
use crate::values::{Count, Height, Positive, Samples, Speed, path};

choices! {
    /// The unit of the angles of a motion.
    AngleChoice {
        /// Degrees.
        Degrees = "degrees";
        /// Radians.
        Radians = "radians";
    }
}

choices! {
    /// How a motion is shown.
    MotionFormat: Table {
        /// In words, and figures of each foot and sphere.
        Table = "table", "In words, and figures of each foot and sphere";
        /// One JSON object.
        Json = "json", "One JSON object";
        /// One row per frame, sphere and force.
        Csv = "csv", "One row per frame, sphere and force";
    }
}

/// Shows what contacts do along a recorded motion, beside what force plates measured.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct MotionRequest {
    /// The model (.osim), or a ForceSet (.xml) with `geometry` and `model`
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub subject: Option<PathBuf>,
    /// Its motion: coordinates over time (.mot or .sto), from inverse kinematics or a simulation
    #[cfg_attr(feature = "clap", arg(value_name = "MOTION"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub motion: Option<PathBuf>,
    /// Ground reactions that force plates measured (.mot or .sto)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub plates: Option<PathBuf>,
    /// OpenSim's ExternalLoads (.xml): which columns of the plates act on which body
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub loads: Option<PathBuf>,
    /// The unit of the motion's angles, where its header does not say it
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub angles: Option<AngleChoice>,
    /// Smooth the coordinates first: zero-lag Butterworth filter of 4th order, cutoff in Hz (6 is usual for walking)
    #[cfg_attr(feature = "clap", arg(long, value_name = "HZ"))]
    pub low_pass: Option<Positive>,
    /// Speed of a treadmill's belt against x, m/s: slip is taken against it
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S", allow_hyphen_values = true))]
    pub belt: Option<Speed>,
    /// The same, from this column of the motion
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true, value_name = "NAME"))]
    pub belt_column: Option<String>,
    /// Write the model's ground reactions to this file (.sto), with its ExternalLoads beside it (.xml)
    #[cfg_attr(feature = "clap", arg(short, long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub output: Option<PathBuf>,
    /// Replace existing files
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: MotionFormat,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// Which forces.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Files of a standalone set.
    #[cfg_attr(feature = "clap", command(flatten))]
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
        /// Figures (and a chart on a terminal).
        Table = "table", "Figures (and a chart on a terminal)";
        /// One JSON object.
        Json = "json", "One JSON object";
        /// The series, one row per moment.
        Csv = "csv", "The series, one row per moment";
    }
}

/// Lets a model fall on its contacts and shows what they do.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct DropTestRequest {
    /// The model to drop (.osim), or a preset; without one, give the numbers
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL|PRESET"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub subject: Option<PathBuf>,
    /// Height of the sphere bottoms at the start: metres, or a factor of the radius like x0.25
    #[cfg_attr(feature = "clap", arg(long, value_name = "HEIGHT", default_value_t))]
    pub height: Height,
    /// How long to follow the body, s
    #[cfg_attr(feature = "clap", arg(long, value_name = "S", default_value_t = Positive::DROP_DURATION_S))]
    pub duration: Positive,
    /// Points of the series
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", default_value_t))]
    pub samples: Samples,
    /// Say how far this drop and that of OTHER (a model or preset) lie apart in dimensionless form
    #[cfg_attr(feature = "clap", arg(long, value_name = "OTHER"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub compare: Option<PathBuf>,
    /// With `compare`: the spheres that share OTHER's weight [default: as found on one limb]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub compare_spheres: Option<Count>,
    /// A file with presets of your own (TOML)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub presets: Option<PathBuf>,
    /// How to print
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub format: SeriesFormat,
    /// A contact given by its numbers.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub numbers: ContactNumbers,
    /// How many spheres share the weight.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub counts: CountOptions,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// Which forces.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Files of a standalone set.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub set_files: SetFiles,
    /// Answers to questions.
    #[cfg_attr(feature = "clap", command(flatten))]
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
