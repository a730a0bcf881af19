//! Contacts for models that have none, and contacts of another model or of a preset.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{
    AnswerOptions, ClassChoice, CountOptions, FollowOptions, ForceOptions, LoadOptions, MassOptions,
    MirrorChoice, NumberOptions, OutputOptions, ReferenceOptions, RunOptions, ScalingOptions, SetFiles,
};
use crate::values::{BodyMap, BodyScale, Metres, NewRadius, SpheresOfFoot, bodies, path, serial};

/// Gives a model that has no foot contacts those of another model or of a preset, of a table, or spheres under its bones.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct AddRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    #[serde(with = "path::Optional")]
    pub from: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub contacts: Option<PathBuf>,
    pub default_pose: bool,
    #[serde(deserialize_with = "serial::from_texts")]
    pub feet: Vec<String>,
    pub count: Option<SpheresOfFoot>,
    pub pad: Option<Metres>,
    #[serde(with = "path::Optional")]
    pub geometry_dir: Option<PathBuf>,
    pub mirror: Option<MirrorChoice>,
    pub class: Option<ClassChoice>,
    pub friction: bool,
    pub radius: NewRadius,
    #[serde(with = "bodies")]
    #[cfg_attr(feature = "schemas", schemars(schema_with = "bodies::body_scale_schema"))]
    pub body_scale: Vec<BodyScale>,
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub body_map: Vec<BodyMap>,
    pub level: bool,
    pub replace: bool,
    #[serde(flatten)]
    pub choice: ForceOptions,
    #[serde(flatten)]
    pub numbers: NumberOptions,
    #[serde(flatten)]
    pub load: LoadOptions,
    #[serde(flatten)]
    pub counts: CountOptions,
    #[serde(flatten)]
    pub reference: ReferenceOptions,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub output: OutputOptions,
    #[serde(flatten)]
    pub run: RunOptions,
    #[serde(flatten)]
    pub answers: AnswerOptions,
}

impl AddRequest {
    /// Whether the request gives the places of the spheres, in a table or by feet.
    pub fn has_places(&self) -> bool {
        self.contacts.is_some() || !self.feet.is_empty()
    }

    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[
            Relation::Required("models"),
            Relation::Excludes("contacts", "feet"),
            Relation::Needs("default_pose", "contacts"),
            Relation::Needs("count", "feet"),
            Relation::Needs("pad", "feet"),
            Relation::Needs("geometry_dir", "feet"),
            Relation::Needs("friction", "from"),
            // What is given is not scaled.
            Relation::Excludes("friction", "viscous_friction"),
            Relation::Excludes("friction", "transition_velocity"),
            // Places of a table or under bones are this model's own.
            Relation::Needs("mirror", "from"),
            Relation::Excludes("mirror", "contacts"),
            Relation::Excludes("mirror", "feet"),
            Relation::Excludes("body_map", "contacts"),
            Relation::Excludes("body_map", "feet"),
            Relation::Excludes("body_scale", "contacts"),
            Relation::Excludes("body_scale", "feet"),
            Relation::Needs("load", "indentation"),
            Relation::Needs("body_weights", "indentation"),
            Relation::Excludes("gravity", "from"),
        ],
        NumberOptions::RELATIONS,
        LoadOptions::RELATIONS,
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}

/// Gives a model the contacts of another model or of a preset, at its own size.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct TransferRequest {
    #[serde(with = "path::List")]
    pub models: Vec<PathBuf>,
    #[serde(with = "path::Optional")]
    pub from: Option<PathBuf>,
    #[serde(with = "path::Optional")]
    pub presets: Option<PathBuf>,
    #[serde(flatten)]
    pub counts: CountOptions,
    #[serde(flatten)]
    pub reference: ReferenceOptions,
    #[serde(flatten)]
    pub follow: FollowOptions,
    #[serde(flatten)]
    pub masses: MassOptions,
    #[serde(flatten)]
    pub scaling: ScalingOptions,
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

impl TransferRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Required("models"), Relation::Required("from")],
        FollowOptions::RELATIONS,
        ScalingOptions::RELATIONS,
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}
