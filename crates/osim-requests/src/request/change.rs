//! Requests to change a model's own contacts: to another mass, by values and factors, to another force class, or to remove them.

use std::path::PathBuf;

use crate::options::{
    AnswerOptions, ClassChoice, ForceOptions, MassOptions, OutputOptions, RunOptions, ScalingOptions,
    SetFiles,
};
use crate::values::serial::fields;
use crate::values::{Assignments, Kilograms, Positive, path};

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

impl RescaleRequest {
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
