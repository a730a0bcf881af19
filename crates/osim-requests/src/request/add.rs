//! Contacts for models that have none, and contacts of another model or of a preset.

use std::path::PathBuf;

use crate::options::{
    AnswerOptions, ClassChoice, CountOptions, FollowOptions, ForceOptions, LoadOptions, MassOptions,
    MirrorChoice, NumberOptions, OutputOptions, ReferenceOptions, RunOptions, ScalingOptions, SetFiles,
};
use crate::values::serial::{self, fields};
use crate::values::{BodyMap, BodyScale, Metres, NewRadius, SpheresOfFoot, bodies, path};

fields! {
    /// Gives a model that has no foot contacts those of another model or of a preset, of a table, or spheres under its bones.
    struct AddRequest {
        models: Vec<PathBuf> as "path::List",
        from: Option<PathBuf> as "path::Optional",
        contacts: Option<PathBuf> as "path::Optional",
        default_pose: bool,
        feet: Vec<String> as "serial::Texts",
        count: Option<SpheresOfFoot>,
        pad: Option<Metres>,
        geometry_dir: Option<PathBuf> as "path::Optional",
        mirror: Option<MirrorChoice>,
        class: Option<ClassChoice>,
        friction: bool,
        radius: NewRadius,
        #[cfg_attr(feature = "schemas", schemars(schema_with = "bodies::body_scale_schema"))]
        body_scale: Vec<BodyScale> as "bodies",
        body_map: Vec<BodyMap> as "serial::Texts",
        level: bool,
        replace: bool,
        choice: ..ForceOptions,
        numbers: ..NumberOptions,
        load: ..LoadOptions,
        counts: ..CountOptions,
        reference: ..ReferenceOptions,
        masses: ..MassOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
    } where
        Required("models"), Excludes("contacts", "feet"), Needs("default_pose", "contacts"),
        Needs("count", "feet"), Needs("pad", "feet"), Needs("geometry_dir", "feet"),
        Needs("friction", "from"), Excludes("friction", "viscous_friction"),
        Excludes("friction", "transition_velocity"), Needs("mirror", "from"), Excludes("mirror", "contacts"),
        Excludes("mirror", "feet"), Excludes("body_map", "contacts"), Excludes("body_map", "feet"),
        Excludes("body_scale", "contacts"), Excludes("body_scale", "feet"), Needs("load", "indentation"),
        Needs("body_weights", "indentation"), Excludes("gravity", "from");

    /// Gives a model the contacts of another model or of a preset, at its own size.
    struct TransferRequest {
        models: Vec<PathBuf> as "path::List",
        from: Option<PathBuf> as "path::Optional",
        presets: Option<PathBuf> as "path::Optional",
        counts: ..CountOptions,
        reference: ..ReferenceOptions,
        follow: ..FollowOptions,
        masses: ..MassOptions,
        scaling: ..ScalingOptions,
        choice: ..ForceOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
        set_files: ..SetFiles,
    } where Required("models"), Required("from");
}

impl AddRequest {
    /// Whether the request gives the places of the spheres, in a table or by feet.
    pub fn has_places(&self) -> bool {
        self.contacts.is_some() || !self.feet.is_empty()
    }
}
