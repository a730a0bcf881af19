//! Contacts along a recorded motion.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::choice::choices;
use crate::options::{ForceOptions, MassOptions, SetFiles};
use crate::relation::Relation;
use crate::values::{Positive, Speed, path};

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
