//! Requests to change a model's own contacts: to another mass, by values and factors, to another force class, or to remove them.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{
    AnswerOptions, ClassChoice, ForceOptions, MassOptions, OutputOptions, RunOptions, ScalingOptions,
    SetFiles,
};
use crate::values::{Assignments, Kilograms, Positive, path};

/// Rescales a model's own contacts to another mass.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct RescaleRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    pub target_mass: Option<Kilograms>,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub scaling: ScalingOptions,
    #[serde(with = "path::Optional")]
    pub body_scale_file: Option<PathBuf>,
    pub follow_bodies: bool,
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

impl RescaleRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Expected("models"), Relation::Excludes("body_scale_file", "follow_bodies")],
        ScalingOptions::RELATIONS,
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];

    /// Whether a field is given that only makes sense for a change.
    ///
    /// ```
    /// use osim_requests::RescaleRequest;
    ///
    /// let request = RescaleRequest { models: vec!["human.osim".into()], ..RescaleRequest::default() };
    /// assert!(!request.asks_for_change());
    /// ```
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

/// Sets properties to a value, or multiplies them by a factor.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct SetRequest {
    // The command line has models and assignments in one list of words.
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    pub set: Assignments,
    pub level: bool,
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

impl SetRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Expected("models"), Relation::RequiredUnless("set", "level")],
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}

/// Makes forces of one class from those of the other, one for each sphere. Stiffness, dissipation, friction and transition velocity
/// stay as they are.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct ConvertRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    pub to: Option<ClassChoice>,
    pub constant_contact_force: Option<Positive>,
    pub hertz_smoothing: Option<Positive>,
    pub hunt_crossley_smoothing: Option<Positive>,
    pub strict: bool,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub output: OutputOptions,
    #[serde(flatten)]
    pub run: RunOptions,
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

impl ConvertRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Required("models"), Relation::Required("to")],
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}

/// Takes the foot contacts out of models: forces, the spheres that nothing else uses, and what was made for them.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct RemoveRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub output: OutputOptions,
    #[serde(flatten)]
    pub run: RunOptions,
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

impl RemoveRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] =
        &[&[Relation::Required("models")], OutputOptions::RELATIONS, RunOptions::RELATIONS];
}
