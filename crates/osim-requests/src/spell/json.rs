//! Spells requests in JSON.

use osim_model::messages::{Call, Dialect, Example, Input, Verb};
use serde_json::Value;

use crate::register::{List, OptionValue, is_flag, option_named};
use crate::request::{Request, verb_entry};
use crate::spell::speller::{FrontEnd, is_assignment};

/// A request in JSON: `"mass": KG`, `{"verb": "design", "models": ["model.osim"], "indentation": 0.16}`.
///
/// ```
/// use osim_model::messages::{Dialect, Input, Verb, phrase};
/// use osim_requests::spell::JsonRequest;
///
/// let way_out = phrase!["give the mass of the model with ", Input::Mass.with_placeholder("KG")];
/// assert_eq!(way_out.spelled(&JsonRequest), "give the mass of the model with \"mass\": KG");
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct JsonRequest;

impl Dialect for JsonRequest {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        let value = match example {
            Some(Example::Value(value)) => number_or_text(value),
            Some(placeholder) => placeholder.to_string(),
            None if is_flag(input) => Value::from(true).to_string(),
            None => return format!("`{}`", input.name()),
        };
        format!("\"{}\": {value}", input.name())
    }

    fn call(&self, call: &Call) -> String {
        let mut fields = vec![format!("\"verb\": \"{}\"", call.verb.name())];
        fields.extend(call.models_or("model.osim").filter_map(|name| model_field(call.verb, name)));
        let field = |(input, example): &(Input, Option<Example>)| match example {
            None if !is_flag(*input) => format!("\"{}\": ...", input.name()),
            example => self.input(*input, example.as_ref()),
        };
        let (set, others): (Vec<_>, Vec<_>) =
            call.inputs.iter().partition(|(input, _)| is_assignment(call, *input));
        let set: Vec<String> = set.into_iter().map(field).collect();
        fields.extend((!set.is_empty()).then(|| format!("\"set\": {{{}}}", set.join(", "))));
        fields.extend(others.into_iter().map(field));
        format!("{{{}}}", fields.join(", "))
    }
}

impl FrontEnd for JsonRequest {
    fn request(&self, request: &Request) -> String {
        request.to_json()
    }
}

/// The field with the model in requests of `verb`, as JSON: the first file that a call has without a name.
fn model_field(verb: Verb, name: &str) -> Option<String> {
    let mut options = verb_entry(verb).positional.iter().filter_map(|name| option_named(verb, name));
    let option = options.find(|option| option.takes == OptionValue::FileRead)?;
    let model = if option.list == List::One { Value::from(name) } else { Value::from(vec![name]) };
    Some(format!("\"{}\": {model}", option.name))
}

/// A number unchanged, any other value in quotation marks.
fn number_or_text(value: &str) -> String {
    match serde_json::from_str::<Value>(value) {
        Ok(Value::Number(_)) => value.to_owned(),
        _ => Value::from(value).to_string(),
    }
}

#[cfg(test)]
mod tests {
    use osim_model::messages::Phrase;

    use super::*;

    fn spelled(template: &str) -> String {
        Phrase::template(template).spelled(&JsonRequest)
    }

    #[test]
    fn inputs_are_spelled_as_fields_of_json() {
        assert_eq!(
            spelled("`mass=KG`, `mass`, `mass=62`, `strict`, `radius=keep`"),
            r#""mass": KG, `mass`, "mass": 62, "strict": true, "radius": "keep""#
        );
    }

    #[test]
    fn spelled_calls_are_valid_requests_in_json() {
        for template in [
            "`drop-test MODEL gravity=1.62 duration=3`",
            "`design MODEL indentation=0.16 body_weights=2`",
            "`transfer MODEL from=falisse2022 radius=keep`",
            "`plot MODEL output=a.svg kind=force`",
            "`sweep MODEL grid=stiffness=x2`",
            "`motion MODEL motion=walk.mot plates=walk.sto correct=corrected.sto`",
            "`fit MODEL motion=walk.mot plates=walk.sto`",
            "`explain topics=floats`",
            "`rescale MODEL target_mass=5 in_place`",
            "`set MODEL stiffness=x2 dissipation=1.5 select=heel*`",
        ] {
            let request = Request::from_json(spelled(template).as_bytes());
            assert!(request.is_ok(), "{template}: {request:?}");
        }
    }
}
