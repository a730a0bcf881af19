//! The inputs of a remedy, in the order in which they are written.

use osim_messages::{Call, Input, Verb};
use osim_model::{Assignment, Property};
use osim_requests::Request;
use osim_requests::values::path;
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
    /// The model as it was named.
    pub(super) model: String,
    /// Properties and what happens to them.
    pub(super) assignments: Vec<(Property, Assignment)>,
    pub(super) inputs: Vec<(Input, InputValue)>,
}

impl RemedyParts {
    /// The fields of its request, but for the model; `None` for a change that this version does not know.
    pub(super) fn of(request: &Request) -> Self {
        let assignments = match request {
            Request::Set(request) => request.set.as_slice().to_vec(),
            _ => Vec::new(),
        };
        let mut fields = request.to_map();
        let model = match fields.shift_remove("models") {
            Some(Value::Array(models)) => models.first().map(name_of).unwrap_or_default(),
            Some(model) => name_of(&model),
            None => String::new(),
        };
        let input = |name: &str| Input::ALL.iter().copied().find(|input| input.name() == name);
        let mut inputs: Vec<(Input, InputValue)> =
            fields.into_iter().filter_map(|(name, value)| input(&name).zip(value_of(value))).collect();
        let place = |input: Input| ORDER.iter().position(|known| *known == input).unwrap_or(ORDER.len());
        inputs.sort_by_key(|(input, _)| place(*input));
        Self { verb: request.verb(), model, assignments, inputs }
    }
}

/// What a field says.
fn value_of(value: Value) -> Option<InputValue> {
    Some(match value {
        Value::Number(number) => InputValue::Number(number.as_f64()?),
        Value::String(text) => InputValue::Text(text),
        Value::Bool(_) => InputValue::Flag,
        Value::Array(patterns) => {
            InputValue::Patterns(patterns.iter().filter_map(Value::as_str).map(str::to_owned).collect())
        }
        other => InputValue::Text(name_of(&other)),
    })
}

/// The name of a file, which may be no text: then it is its bytes.
fn name_of(value: &Value) -> String {
    let path = path::optional::deserialize(value.clone()).ok().flatten();
    path.map_or_else(|| value.to_string(), |path| path.display().to_string())
}
