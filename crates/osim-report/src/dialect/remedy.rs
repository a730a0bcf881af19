//! The inputs of a remedy, in the order in which they are written.

use std::path::{Path, PathBuf};

use osim_messages::{Call, Input, Verb};
use osim_model::{Assignment, Property, Remedy, RemedyChange};
use osim_requests::Request;
use serde_json::Value;

/// What comes first where a remedy has it; the rest follows in the order of its request.
const ORDER: [Input; 20] = [
    Input::ContactsMass,
    Input::TargetMass,
    Input::From,
    Input::To,
    Input::FollowBodies,
    Input::BodyScaleFile,
    Input::MovedSpheres,
    Input::Level,
    Input::Indentation,
    Input::BodyWeights,
    Input::ConstantIndentation,
    Input::Restitution,
    Input::ImpactSpeed,
    Input::StateWidth,
    Input::Mass,
    Input::Gravity,
    Input::ExcludeBody,
    Input::Spheres,
    Input::StanceLimbs,
    Input::Select,
];

/// Whether `input` is a property that `call` sets.
pub(super) fn is_assignment(call: &Call, input: Input) -> bool {
    call.verb == Verb::Set && input.name().parse::<Property>().is_ok()
}

/// The value of an input.
pub(super) enum InputValue {
    Number(f64),
    Text(String),
    /// One or more patterns.
    Patterns(Vec<String>),
    /// The input alone says it.
    Flag,
}

/// A remedy, taken apart.
pub(super) struct RemedyParts {
    pub(super) verb: Verb,
    /// Properties and what happens to them.
    pub(super) assignments: Vec<(Property, Assignment)>,
    pub(super) inputs: Vec<(Input, InputValue)>,
}

impl RemedyParts {
    /// The fields of its request, but for the model; `None` for a change that this version does not know.
    pub(super) fn of(remedy: &Remedy) -> Option<Self> {
        let request = Request::try_from(remedy).ok()?;
        let assignments = match &request {
            Request::Set(request) => request.set.as_slice().to_vec(),
            _ => Vec::new(),
        };
        let input = |name: &str| Input::ALL.iter().copied().find(|input| input.name() == name);
        let fields = request.to_map().into_iter();
        let mut inputs: Vec<(Input, InputValue)> =
            fields.filter_map(|(name, value)| input(&name).zip(value_of(remedy, &name, value))).collect();
        let place = |input: Input| ORDER.iter().position(|known| *known == input).unwrap_or(ORDER.len());
        inputs.sort_by_key(|(input, _)| place(*input));
        Some(Self { verb: request.verb(), assignments, inputs })
    }
}

/// The value of the field `name`.
fn value_of(remedy: &Remedy, name: &str, value: Value) -> Option<InputValue> {
    Some(match value {
        Value::Number(number) => InputValue::Number(number.as_f64()?),
        Value::String(text) => InputValue::Text(text),
        Value::Bool(_) => InputValue::Flag,
        Value::Array(patterns) => {
            InputValue::Patterns(patterns.iter().filter_map(Value::as_str).map(str::to_owned).collect())
        }
        // The name of a file that is no text.
        _ => InputValue::Text(file_of(remedy, name)?.display().to_string()),
    })
}

/// A file of a remedy, by the name of its input.
fn file_of<'r>(remedy: &'r Remedy, name: &str) -> Option<&'r Path> {
    let (from, factors) = match &remedy.change {
        RemedyChange::Follow { from, body_scale_file, .. } => (Some(from), body_scale_file.as_ref()),
        _ => (None, None),
    };
    let files = [
        (Input::Geometry, remedy.geometry.as_ref()),
        (Input::Model, remedy.set_model.as_ref()),
        (Input::From, from),
        (Input::BodyScaleFile, factors),
    ];
    files.into_iter().find(|(input, _)| input.name() == name)?.1.map(PathBuf::as_path)
}
