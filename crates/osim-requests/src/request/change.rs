//! Changes of a model's own contacts: another mass, plain values and factors, another class, none.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{
    AnswerOptions, ClassChoice, ForceOptions, MassOptions, OutputOptions, RunOptions, ScalingOptions,
    SetFiles,
};
use crate::values::{Assignments, Kilograms, Positive, path};

/// Rescales a model's own contacts to another mass.
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
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct SetRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    // The command line has models and assignments in one list of words.
    #[cfg_attr(feature = "clap", arg(skip))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Properties by OpenSim's names, each with its value, or with a factor such as "x2"
    #[cfg_attr(feature = "clap", arg(skip))]
    pub set: Assignments,
    /// Move spheres down until all spheres of a foot are as low as its lowest one, at the default pose
    #[cfg_attr(feature = "clap", arg(long, help_heading = "What changes"))]
    pub level: bool,
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
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct ConvertRequest {
    /// Models (.osim), folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// The class that forces get
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub to: Option<ClassChoice>,
    /// OpenSim's constant_contact_force of forces that had none [default: Falisse et al. (2022) at each radius (C.2)]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M2"))]
    pub constant_contact_force: Option<Positive>,
    /// hertz_smoothing of forces that had none, 1/m [default: Falisse et al. (2022) at each radius (C.5)]
    #[cfg_attr(feature = "clap", arg(long, value_name = "PER_M"))]
    pub hertz_smoothing: Option<Positive>,
    /// hunt_crossley_smoothing of forces that had none, s/m [default: Falisse et al. (2022) at each radius (C.10)]
    #[cfg_attr(feature = "clap", arg(long, value_name = "S_PER_M"))]
    pub hunt_crossley_smoothing: Option<Positive>,
    /// Refuse where sphere and half-space have parameters of their own that differ
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub strict: bool,
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
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct RemoveRequest {
    /// Models (.osim), folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
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
}

impl RemoveRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] =
        &[&[Relation::Required("models")], OutputOptions::RELATIONS, RunOptions::RELATIONS];
}
