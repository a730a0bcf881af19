//! A model's own contacts at another mass.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::options::{
    AnswerOptions, ForceOptions, MassOptions, OutputOptions, RunOptions, ScalingOptions, SetFiles,
};
use crate::relation::Relation;
use crate::values::{Kilograms, path};

/// Rescales a model's own contacts to another mass.
///
/// ```
/// use osim_requests::{Kilograms, RescaleRequest};
///
/// let mut request = RescaleRequest::default();
/// request.models = vec!["human.osim".into()];
/// request.target_mass = Some(Kilograms::new(1190.0)?);
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct RescaleRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Mass the contacts should be made for, kg
    #[cfg_attr(feature = "clap", arg(long, value_name = "KG", allow_hyphen_values = true))]
    pub target_mass: Option<Kilograms>,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// What changes, and how.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub scaling: ScalingOptions,
    /// ScaleSet that the Scale Tool applied: spheres follow their bodies
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub body_scale_file: Option<PathBuf>,
    /// Spheres follow bodies scaled since the model's note was written
    #[cfg_attr(feature = "clap", arg(long))]
    pub follow_bodies: bool,
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

impl RescaleRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Expected("models"), Relation::Excludes("body_scale_file", "follow_bodies")],
        ScalingOptions::RELATIONS,
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];

    /// Whether something is given that makes sense for a change only.
    #[must_use]
    pub fn asks_for_change(&self) -> bool {
        let (scaling, output, run) = (&self.scaling, &self.output, &self.run);
        scaling.radius.is_some()
            || !scaling.only.is_empty()
            || !scaling.keep.is_empty()
            || scaling.friction
            || scaling.target_gravity.is_some()
            || scaling.level
            || self.body_scale_file.is_some()
            || self.follow_bodies
            || output.output.is_some()
            || output.output_dir.is_some()
            || output.in_place
            || run.dry_run
            || run.diff
            || run.summary.is_some()
            || run.shard.is_some()
    }
}
