//! Spells requests for MATLAB and GNU Octave.

use osim_model::messages::{Call, Dialect, Example, Input, Verb};

use crate::register::{FieldGroup, is_flag};
use crate::request::Request;
use crate::spell::speller::{FieldValue, Fields, FrontEnd, digits, is_assignment, is_positional};

/// MATLAB and GNU Octave: `'Mass', KG`, `osimcontact.design('model.osim', 'Indentation', 0.16)`.
///
/// ```
/// use osim_model::messages::{Dialect, Input, Verb};
/// use osim_requests::spell::Matlab;
///
/// let call = Verb::DropTest.call_with_model().with_value(Input::Duration, "2");
/// assert_eq!(Matlab.call(&call), "osimcontact.drop_test('model.osim', 'Duration', 2)");
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct Matlab;

impl Dialect for Matlab {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        let name = matlab_quoted(&option_name(input.name()));
        match example {
            Some(example) => format!("{name}, {}", example_value(example)),
            None if is_flag(input) => format!("{name}, true"),
            None => name,
        }
    }

    fn call(&self, call: &Call) -> String {
        let mut arguments = Vec::new();
        let inputs = &call.inputs;
        let first = inputs.iter().filter(|(input, _)| is_positional(*input));
        arguments.extend(first.filter_map(|(_, example)| example.as_ref().map(example_value)));
        arguments.extend(call.models_or("model.osim").map(matlab_quoted));
        let set = inputs.iter().filter(|(input, _)| is_assignment(call, *input));
        let set: Vec<String> = set
            .filter_map(|(input, example)| {
                Some(format!("{}, {}", matlab_quoted(input.name()), example_value(example.as_ref()?)))
            })
            .collect();
        arguments.extend((!set.is_empty()).then(|| format!("'Set', struct({})", set.join(", "))));
        let named = inputs.iter().filter(|(input, _)| !is_assignment(call, *input) && !is_positional(*input));
        arguments.extend(named.map(|(input, example)| self.input(*input, example.as_ref())));
        function_call(call.verb, &arguments)
    }
}

impl FrontEnd for Matlab {
    /// The call in MATLAB. Results are structs, so options for a terminal are omitted.
    fn request(&self, request: &Request) -> String {
        let fields = Fields::of(request);
        let mut arguments: Vec<String> = fields
            .positional
            .iter()
            .map(|(_, value)| match value {
                FieldValue::List(items) if items.len() == 1 => value_literal(&items[0]),
                value => value_literal(value),
            })
            .collect();
        for (name, value) in fields.outside_groups(&[FieldGroup::Shown]) {
            arguments.extend([matlab_quoted(&option_name(name)), value_literal(value)]);
        }
        function_call(fields.verb, &arguments)
    }

    fn script(&self, request: &Request) -> String {
        format!("result = {};", self.request(request))
    }

    fn word(&self, name: &str) -> String {
        matlab_quoted(name)
    }
}

fn function_call(verb: Verb, arguments: &[String]) -> String {
    format!("osimcontact.{}({})", verb.name().replace('-', "_"), arguments.join(", "))
}

/// An example value in MATLAB: placeholders and numbers unchanged, any other value as a text.
fn example_value(example: &Example) -> String {
    match example {
        Example::Placeholder(word) if !word.contains(['.', ',', '=']) => word.to_string(),
        Example::Value(value) if value.parse::<f64>().is_ok_and(f64::is_finite) => value.clone(),
        example => matlab_quoted(&example.to_string()),
    }
}

/// Words that MATLAB does not allow as names of struct fields.
const RESERVED_NAMES: &str = "break case catch classdef continue else elseif end for function global if otherwise parfor \
    persistent return spmd switch try while";

/// The largest number of letters in the name of a struct field in MATLAB.
const LONGEST_MATLAB_NAME: usize = 63;

/// The name of an option in MATLAB: `TargetMass` for `target_mass`.
fn option_name(name: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect::<String>()
    };
    name.split('_').map(capital).collect()
}

fn value_literal(value: &FieldValue) -> String {
    match value {
        FieldValue::Flag => "true".to_owned(),
        FieldValue::Number(number) => digits(number),
        FieldValue::Text(text) => matlab_quoted(text),
        FieldValue::List(items) if items.iter().all(|item| matches!(item, FieldValue::Number(_))) => {
            format!("[{}]", items.iter().map(value_literal).collect::<Vec<_>>().join(", "))
        }
        FieldValue::List(items) => cell_array(items.iter().map(value_literal)),
        FieldValue::Map(entries) if entries.iter().all(|(name, _)| is_field_name(name)) => {
            let pairs: Vec<String> = entries
                .iter()
                .flat_map(|(name, value)| [matlab_quoted(name), value_literal(value)])
                .collect();
            format!("struct({})", pairs.join(", "))
        }
        FieldValue::Map(entries) => {
            let names = cell_array(entries.iter().map(|(name, _)| matlab_quoted(name)));
            let values = cell_array(entries.iter().map(|(_, value)| value_literal(value)));
            format!("containers.Map({names}, {values})")
        }
    }
}

/// Whether MATLAB allows `name` as the name of a struct field.
fn is_field_name(name: &str) -> bool {
    let is_word = name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
    let is_name = name.starts_with(|first: char| first.is_ascii_alphabetic());
    is_word
        && is_name
        && name.len() <= LONGEST_MATLAB_NAME
        && !RESERVED_NAMES.split(' ').any(|reserved| reserved == name)
}

fn cell_array(items: impl Iterator<Item = String>) -> String {
    format!("{{{}}}", items.collect::<Vec<_>>().join(", "))
}

/// A text between single quotation marks; a quotation mark in the text is doubled. Control characters are written by their
/// numbers.
fn matlab_quoted(text: &str) -> String {
    let mut literal = String::new();
    for letter in text.chars() {
        match letter {
            '\'' => literal.push_str("''"),
            control if control.is_ascii_control() => {
                literal.push_str(&format!("' char({}) '", u32::from(control)));
            }
            plain => literal.push(plain),
        }
    }
    if text.contains(|letter: char| letter.is_ascii_control()) {
        format!("['{literal}']")
    } else {
        format!("'{literal}'")
    }
}

#[cfg(test)]
mod tests {
    use osim_model::messages::Phrase;
    use serde_json::{Value, json};

    use super::*;

    #[track_caller]
    fn assert_spelled(request: &Value, expected: &str) {
        let request = Request::from_json(request.to_string().as_bytes()).unwrap();
        assert_eq!(Matlab.script(&request), format!("result = osimcontact.{expected};"));
    }

    #[test]
    fn texts_have_their_quotation_marks_doubled() {
        for (text, expected) in [
            ("Fuß $1 \"%d\".osim", "'Fuß $1 \"%d\".osim'"),
            (r"C:\a", r"'C:\a'"),
            ("it's", "'it''s'"),
            ("", "''"),
            ("a\nb", "['a' char(10) 'b']"),
        ] {
            assert_eq!(matlab_quoted(text), expected);
        }
    }

    #[test]
    fn sentences_have_calls_that_can_be_run() {
        for (template, expected) in [
            (
                "`mass=KG`, `mass`, `strict`, `radius=keep`",
                "'Mass', KG, 'Mass', 'Strict', true, 'Radius', 'keep'",
            ),
            (
                "`set MODEL stiffness=x2 select=heel*`",
                "osimcontact.set('model.osim', 'Set', struct('stiffness', 'x2'), 'Select', 'heel*')",
            ),
            (
                "`plot MODEL output=FILE.svg kind=force`",
                "osimcontact.plot('force', 'model.osim', 'Output', 'FILE.svg')",
            ),
        ] {
            assert_eq!(Phrase::template(template).spelled(&Matlab), expected);
        }
    }

    #[test]
    fn options_are_pairs_of_a_name_and_a_value() {
        assert_spelled(
            &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500, "level": true, "diff": true, "quiet": true}),
            "rescale('human.osim', 'TargetMass', 500, 'Level', true)",
        );
        assert_spelled(
            &json!({"verb": "design", "radius": 0.032, "indentation": 0.16, "mass": 62, "spheres": 6}),
            "design('Radius', 0.032, 'Indentation', 0.16, 'Mass', 62, 'Spheres', 6)",
        );
        assert_spelled(
            &json!({"verb": "add", "models": "bare.osim", "from": "-x.osim", "class": "smooth"}),
            "add('bare.osim', 'From', '-x.osim', 'Class', 'smooth')",
        );
        assert_spelled(
            &json!({"verb": "plot", "kind": "force", "models": ["a.osim", "b.osim"], "output": "a.svg"}),
            "plot('force', {'a.osim', 'b.osim'}, 'Output', 'a.svg')",
        );
    }

    #[test]
    fn lists_are_cells_and_maps_are_structs() {
        assert_spelled(
            &json!({"verb": "set", "models": ["a.osim", "b.osim"], "set": {"stiffness": "x2", "dissipation": 1.5}, "select": ["*_r", "*_l"]}),
            "set({'a.osim', 'b.osim'}, 'Set', struct('stiffness', 'x2', 'dissipation', 1.5), 'Select', {'*_r', '*_l'})",
        );
        assert_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "follow_bodies": true, "body_scale": {"calcn_r": [1.1, 1.05, 1.1]}}),
            "transfer('a.osim', 'From', 'g.osim', 'FollowBodies', true, 'BodyScale', struct('calcn_r', [1.1, 1.05, 1.1]))",
        );
    }

    #[test]
    fn names_that_no_field_of_a_struct_can_have_are_keys() {
        assert_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "follow_bodies": true, "body_scale": {"foot l": 2, "toes": [1, 2, 3]}}),
            "transfer('a.osim', 'From', 'g.osim', 'FollowBodies', true, \
     'BodyScale', containers.Map({'foot l', 'toes'}, {[2, 2, 2], [1, 2, 3]}))",
        );
        assert!(
            ["end", "_a", "1a", "ä", ""].into_iter().all(|name| !is_field_name(name))
                && is_field_name("calcn_r")
        );
    }
}
