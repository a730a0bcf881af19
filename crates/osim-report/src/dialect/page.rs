//! The words of a page with fields and buttons.

use osim_messages::{Call, Dialect, Example, Input, Verb, readable};
use osim_model::Assignment;
use osim_requests::{Request, Speller};

use super::front_end::FrontEnd;
use super::remedy::{InputValue, RemedyParts};

/// The button that answers a question.
const MEANT: &str = "“It is meant as it is: go on”";

/// A page: the field “mass of the model”.
///
/// ```
/// use osim_messages::{Input, phrase};
/// use osim_report::dialect::Page;
///
/// let way_out = phrase!["say what the model weighs with ", Input::Mass.like("KG")];
/// assert_eq!(way_out.spelled(&Page), "say what the model weighs with the field “mass of the model”");
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct Page;

impl Dialect for Page {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        match example {
            _ if input == Input::Yes => MEANT.to_owned(),
            Some(Example::Value(value)) => format!("the field “{}” ({value})", input.label()),
            _ => format!("the field “{}”", input.label()),
        }
    }

    fn call(&self, call: &Call) -> String {
        let inputs: Vec<String> =
            call.inputs.iter().map(|(input, example)| self.input(*input, example.as_ref())).collect();
        let with = if inputs.is_empty() { String::new() } else { format!(" with {}", inputs.join(" and ")) };
        format!("“{}”{with}", call.verb.name())
    }
}

impl Speller for Page {
    fn request(&self, request: &Request) -> String {
        let parts = RemedyParts::of(request);
        let mut wanted: Vec<String> = parts
            .assignments
            .iter()
            .map(|(property, assignment)| match assignment {
                Assignment::Factor(factor) => format!("{property} × {}", readable(*factor)),
                Assignment::Value(value) => format!("{property} {}", readable(*value)),
            })
            .collect();
        wanted.extend(parts.inputs.iter().map(|(input, value)| {
            let label = input.label();
            match value {
                InputValue::Number(value) => format!("“{label}” {}", readable(*value)),
                InputValue::Text(text) => format!("“{label}” {text}"),
                InputValue::Patterns(patterns) => format!("“{label}” {}", patterns.join(" and ")),
                InputValue::Flag => format!("“{label}”"),
            }
        }));
        let what = match parts.verb {
            Verb::Rescale => "Scale the contacts",
            Verb::Transfer => "Take the contacts of another model",
            Verb::Design => "Design the contacts",
            Verb::Convert => "Convert the forces",
            _ => "Set",
        };
        format!("{what}: {}.", wanted.join(", "))
    }
}

impl FrontEnd for Page {}

#[cfg(test)]
mod tests {
    use osim_messages::Phrase;

    use super::*;

    #[test]
    fn fields_have_their_labels() {
        let text =
            Phrase::template("leave radii as they are with `radius=keep`; `design MODEL indentation=0.16`");
        assert_eq!(
            text.spelled(&Page),
            "leave radii as they are with the field “radius” (keep); “design” with the field “relative indentation” \
             (0.16)"
        );
    }
}
