//! Contacts for models that have none, and contacts of another model or of a preset.

use std::path::PathBuf;

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::Relation;
use crate::options::{
    AnswerOptions, ClassChoice, CountOptions, FollowOptions, ForceOptions, LoadOptions, MassOptions,
    MirrorChoice, NumberOptions, OutputOptions, ReferenceOptions, RunOptions, ScalingOptions, SetFiles,
};
use crate::values::{BodyMap, BodyScale, Metres, NewRadius, SpheresOfFoot, bodies, path, serial};

/// Gives a model that has no foot contacts those of another model or of a preset, of a table, or spheres under its bones.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct AddRequest {
    /// Models (.osim), folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Where the contacts come from: a model, or a preset with places: falisse2022, moco-2d-gait
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODEL|PRESET"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub from: Option<PathBuf>,
    /// Where the spheres are: a table with name, body, x, y, z [m, in the body's frame] and perhaps radius, or MuSkeMo's export
    #[cfg_attr(feature = "clap", arg(long, value_name = "TABLE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub contacts: Option<PathBuf>,
    /// Take places that the table has in ground only as those of the default pose
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub default_pose: bool,
    /// Lay spheres under the meshes of these bodies, which touch the ground, separated by commas
    #[cfg_attr(feature = "clap", arg(long, value_name = "BODY", value_delimiter = ','))]
    #[serde(deserialize_with = "serial::from_texts")]
    pub feet: Vec<String>,
    /// Spheres under each foot
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub count: Option<SpheresOfFoot>,
    /// How far below the lowest bone point the sole is, m: bones have no skin
    #[cfg_attr(feature = "clap", arg(long, value_name = "METRES", allow_hyphen_values = true))]
    pub pad: Option<Metres>,
    /// A folder with the bones' meshes, beside that of the model and its Geometry
    #[cfg_attr(feature = "clap", arg(long, value_name = "DIR", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub geometry_dir: Option<PathBuf>,
    /// Give a reference that has one side only the other one too, mirrored in this axis
    #[cfg_attr(feature = "clap", arg(long, value_enum, hide_short_help = true))]
    pub mirror: Option<MirrorChoice>,
    /// Class of the new forces [default: the reference's]
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub class: Option<ClassChoice>,
    /// Scale transition_velocity and viscous_friction of the reference too (an extension of the paper)
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub friction: bool,
    /// Radii: isometric (R ~ M^1/3), follow (with the factors of the bodies), or a radius in metres
    #[cfg_attr(feature = "clap", arg(long, value_name = "RULE", default_value_t))]
    pub radius: NewRadius,
    /// Factors of a body against the reference's (or one, BODY=f); may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "BODY=x,y,z"))]
    #[serde(with = "bodies")]
    #[cfg_attr(feature = "schemas", schemars(schema_with = "bodies::body_scale_schema"))]
    pub body_scale: Vec<BodyScale>,
    /// A body of the reference, and the one that takes its spheres here; may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "BODY=BODY"))]
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub body_map: Vec<BodyMap>,
    /// Move spheres down until all spheres of a foot are as low as its lowest one, at the default pose
    #[cfg_attr(feature = "clap", arg(long))]
    pub level: bool,
    /// Take the model's own foot contacts out first
    #[cfg_attr(feature = "clap", arg(long))]
    pub replace: bool,
    /// Which of the model's own forces are replaced.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub choice: ForceOptions,
    /// Numbers of the contacts, where no reference gives them.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub numbers: NumberOptions,
    /// The load on the spheres.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub load: LoadOptions,
    /// How many spheres share the weight.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub counts: CountOptions,
    /// What the reference is.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub reference: ReferenceOptions,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
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

impl AddRequest {
    /// Whether it says itself where the spheres are, in a table or by feet.
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
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args))]
#[serde(default)]
pub struct TransferRequest {
    /// Models (.osim), a ForceSet (.xml) with `geometry`, folders, or - for standard input
    #[cfg_attr(feature = "clap", arg(value_name = "MODEL"))]
    #[serde(with = "path::list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<path::PathSchema>"))]
    pub models: Vec<PathBuf>,
    /// Where the contacts come from: a model, or a preset such as falisse2022
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODEL|PRESET"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub from: Option<PathBuf>,
    /// A file with presets of your own (TOML)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub presets: Option<PathBuf>,
    /// How many spheres share the weight.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub counts: CountOptions,
    /// What the reference is.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub reference: ReferenceOptions,
    /// Whether spheres follow their bodies.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub follow: FollowOptions,
    /// Which mass is meant.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub masses: MassOptions,
    /// What changes, and how.
    #[cfg_attr(feature = "clap", command(flatten))]
    #[serde(flatten)]
    pub scaling: ScalingOptions,
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

impl TransferRequest {
    pub(crate) const RELATIONS: &'static [&'static [Relation]] = &[
        &[Relation::Required("models"), Relation::Required("from")],
        FollowOptions::RELATIONS,
        ScalingOptions::RELATIONS,
        OutputOptions::RELATIONS,
        RunOptions::RELATIONS,
    ];
}
