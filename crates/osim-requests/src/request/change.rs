//! Requests to change a model's own contacts (to another mass, by values and factors, to another force class, or to remove them), and to give
//! it contacts of another model or of a preset.

use std::path::PathBuf;

use crate::dictionary::{all_fields, given_fields};
use crate::options::{
    AnswerOptions, ClassChoice, CountOptions, FollowOptions, ForceOptions, InspectionOptions, LoadOptions,
    MassOptions, MirrorChoice, NumberOptions, OutputOptions, ReferenceOptions, ReportOptions, RunOptions,
    ScalingOptions, SetFiles,
};
use crate::values::serial::{self, fields};
use crate::values::{
    Assignments, BodyMap, BodyScale, Kilograms, Metres, NewRadius, Positive, SpheresOfFoot, bodies, path,
};

fields! {
    /// Rescales a model's own contacts to another mass.
    struct RescaleRequest {
        models: Vec<PathBuf> as "path::List",
        target_mass: Option<Kilograms>,
        masses: ..MassOptions,
        scaling: ..ScalingOptions,
        body_scale_file: Option<PathBuf> as "path::Optional",
        follow_bodies: bool,
        choice: ..ForceOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
        set_files: ..SetFiles,
    } where Expected("models"), Excludes("body_scale_file", "follow_bodies");

    /// Sets properties to a value, or multiplies them by a factor.
    struct SetRequest {
        // The command line has models and assignments in one list of words.
        models: Vec<PathBuf> as "path::List",
        set: Assignments,
        level: bool,
        masses: ..MassOptions,
        choice: ..ForceOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
        set_files: ..SetFiles,
    } where Expected("models"), RequiredUnless("set", "level");

    /// Makes forces of one class from those of the other, one for each sphere, or connects sockets. Stiffness, dissipation, friction and transition velocity
    /// stay as they are.
    struct ConvertRequest {
        models: Vec<PathBuf> as "path::List",
        to: Option<ClassChoice>,
        sockets: bool,
        constant_contact_force: Option<Positive>,
        hertz_smoothing: Option<Positive>,
        hunt_crossley_smoothing: Option<Positive>,
        strict: bool,
        choice: ..ForceOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
    } where Required("models"), RequiredUnless("to", "sockets"), Excludes("sockets", "to");

    /// Takes the foot contacts out of models: forces, the spheres that nothing else uses, and what was made for them.
    struct RemoveRequest {
        models: Vec<PathBuf> as "path::List",
        choice: ..ForceOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
    } where Required("models");
}

/// Fields of every call on models, also of one that changes nothing.
const FIELDS_OF_ANY_CALL: [&str; 4] = ["models", "format", "quiet", "jobs"];

impl RescaleRequest {
    /// Whether a field is given that only makes sense for a change.
    ///
    /// ```
    /// use osim_requests::{Request, RescaleRequest};
    ///
    /// let request = RescaleRequest { models: vec!["human.osim".into()], ..RescaleRequest::default() };
    /// assert!(!request.asks_for_change());
    /// let request = Request::from_json(br#"{"verb": "rescale", "models": "human.osim", "dissipation_by": "mass"}"#)?;
    /// assert!(matches!(request, Request::Rescale(rescale) if rescale.asks_for_change()));
    /// # Ok::<(), osim_requests::RequestFault>(())
    /// ```
    pub fn asks_for_change(&self) -> bool {
        let inspected = [all_fields(&InspectionOptions::default()), all_fields(&ReportOptions::default())];
        let is_inspected = |name: &String| {
            FIELDS_OF_ANY_CALL.contains(&name.as_str())
                || inspected.iter().any(|fields| fields.contains_key(name))
        };
        !given_fields(self).keys().all(is_inspected)
    }
}

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
