//! Spells requests for a page with fields and buttons.

use osim_model::messages::{Call, Dialect, Example, Input, Verb, readable};

use crate::request::{Request, verb_title};
use crate::spell::speller::{Field, FieldValue, Fields, FrontEnd};

/// Text of the button with which a user answers a question.
const ANSWER_BUTTON: &str = "“This is correct: continue”";

/// A page: the field “mass of the model”.
///
/// ```
/// use osim_model::messages::{Input, phrase};
/// use osim_requests::spell::Page;
///
/// let way_out = phrase!["give the mass of the model with ", Input::Mass.with_placeholder("KG")];
/// assert_eq!(way_out.spelled(&Page), "give the mass of the model with the field “mass of the model”");
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct Page;

impl Dialect for Page {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        match example {
            _ if input == Input::Yes => ANSWER_BUTTON.to_owned(),
            Some(Example::Value(value)) => format!("the field “{}” ({value})", input.label()),
            _ => format!("the field “{}”", input.label()),
        }
    }

    fn call(&self, call: &Call) -> String {
        // The page checks each model and plays each motion; its second step asks for the original.
        let has = |wanted| call.inputs.iter().any(|(input, _)| *input == wanted);
        match call.verb {
            Verb::Check if has(Input::From) => return "step 2 (“Scaled from another model?”)".to_owned(),
            Verb::Check if has(Input::Motion) => {
                return "open both here, this one with the ending .mot".to_owned();
            }
            _ => {}
        }
        let verb = std::iter::once(format!("“{}”", call.verb.name()));
        let inputs = call.inputs.iter().map(|(input, example)| self.input(*input, example.as_ref()));
        verb.chain(inputs).collect::<Vec<_>>().join(" and ")
    }
}

impl FrontEnd for Page {
    /// The action, and the fields with their values; without the model, because the model is already open in the page.
    fn request(&self, request: &Request) -> String {
        let fields = Fields::of(request);
        let wanted: Vec<String> = fields.options.iter().flat_map(field_words).collect();
        let what = verb_title(fields.verb);
        match wanted.as_slice() {
            [] => format!("{what}."),
            wanted => format!("{what}: {}.", wanted.join(", ")),
        }
    }
}

/// A field of a request in words: its label and its value; for `set`, one text for each property.
fn field_words((name, value): &Field) -> Vec<String> {
    let label = Input::find(name).map_or(name.as_str(), |input| input.label());
    match value {
        FieldValue::Map(properties) if name == "set" => properties.iter().map(spelled_assignment).collect(),
        FieldValue::Map(entries) => {
            entries.iter().map(|(name, value)| format!("{label} {name} {}", spelled_value(value))).collect()
        }
        FieldValue::Flag => vec![label.to_owned()],
        value => vec![format!("{label} {}", spelled_value(value))],
    }
}

/// Spells an assignment, for example `stiffness × 2` or `dissipation 1.5`.
fn spelled_assignment((property, value): &Field) -> String {
    let factor = match value {
        FieldValue::Text(text) => text.strip_prefix('x').and_then(|factor| factor.parse().ok()),
        _ => None,
    };
    match factor {
        Some(factor) => format!("{property} × {}", readable(factor)),
        None => format!("{property} {}", spelled_value(value)),
    }
}

fn spelled_value(value: &FieldValue) -> String {
    match value {
        FieldValue::Number(number) => number.as_f64().map_or_else(|| number.to_string(), readable),
        FieldValue::List(items) => items.iter().map(spelled_value).collect::<Vec<_>>().join(" and "),
        value => value.text(),
    }
}

#[cfg(test)]
mod tests {
    use osim_model::messages::Phrase;
    use serde_json::json;

    use super::*;

    #[test]
    fn requests_are_fields_with_their_values() {
        for (request, expected) in [
            (
                json!({"verb": "set", "models": "a.osim", "set": {"stiffness": "x2", "dissipation": 1.5}, "select": ["*_r", "toe"]}),
                "Set: stiffness × 2, dissipation 1.5, forces to choose *_r and toe.",
            ),
            (
                json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "follow_bodies": true, "body_scale": {"toes": [1, 2, 3]}}),
                "Take the contacts of another model: source of the contacts g.osim, spheres follow their bodies, \
             scale factors of a body toes 1 and 2 and 3.",
            ),
            (json!({"verb": "remove", "models": "a.osim"}), "Remove the contacts."),
        ] {
            let request = Request::from_json(request.to_string().as_bytes()).unwrap();
            assert_eq!(Page.request(&request), expected);
        }
    }

    #[test]
    fn the_page_spells_fields_with_their_labels() {
        let text =
            Phrase::template("leave radii as they are with `radius=keep`; `design MODEL indentation=0.16`");
        assert_eq!(
            text.spelled(&Page),
            "leave radii as they are with the field “radius” (keep); “design” and the field “relative indentation” \
         (0.16)"
        );
        let text = Phrase::template("`check MODEL from=GENERIC` compares with the model that was scaled");
        assert_eq!(
            text.spelled(&Page),
            "step 2 (“Scaled from another model?”) compares with the model that was scaled"
        );
        let text = Phrase::template("to compare the two, `check MODEL motion=FILE plates=FORCES`");
        assert_eq!(text.spelled(&Page), "to compare the two, open both here, this one with the ending .mot");
    }
}
