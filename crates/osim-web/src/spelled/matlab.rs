//! A line of MATLAB or GNU Octave.

use super::fields::{FieldValue, Fields};

/// What has no use in MATLAB, because results are structs.
const LEFT_OUT: [&str; 5] = ["format", "quiet", "diff", "full", "deny"];

/// Words that cannot be the name of a field.
const RESERVED: [&str; 20] = [
    "break",
    "case",
    "catch",
    "classdef",
    "continue",
    "else",
    "elseif",
    "end",
    "for",
    "function",
    "global",
    "if",
    "otherwise",
    "parfor",
    "persistent",
    "return",
    "spmd",
    "switch",
    "try",
    "while",
];

/// The longest name of a field.
const LONGEST: usize = 63;

/// The line.
pub(super) fn matlab(fields: &Fields) -> String {
    let mut arguments = match fields.models.as_slice() {
        [] => Vec::new(),
        [model] => vec![quoted(model)],
        models => vec![cell(models.iter().map(|model| quoted(model)))],
    };
    for (name, value) in fields.without(&LEFT_OUT) {
        arguments.extend([quoted(&option(name)), literal(value)]);
    }
    format!("result = osimcontact.{}({});", fields.verb.name().replace('-', "_"), arguments.join(", "))
}

/// `TargetMass` for `target_mass`.
fn option(name: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect::<String>()
    };
    name.split('_').map(capital).collect()
}

fn literal(value: &FieldValue) -> String {
    match value {
        FieldValue::Flag => "true".to_owned(),
        FieldValue::Number(number) => number.clone(),
        FieldValue::Text(text) => quoted(text),
        FieldValue::List(items) if items.iter().all(|item| matches!(item, FieldValue::Number(_))) => {
            format!("[{}]", items.iter().map(literal).collect::<Vec<_>>().join(", "))
        }
        FieldValue::List(items) => cell(items.iter().map(literal)),
        FieldValue::Map(entries) if entries.iter().all(|(name, _)| is_field(name)) => {
            let pairs: Vec<String> =
                entries.iter().flat_map(|(name, value)| [quoted(name), literal(value)]).collect();
            format!("struct({})", pairs.join(", "))
        }
        FieldValue::Map(entries) => {
            let names = cell(entries.iter().map(|(name, _)| quoted(name)));
            format!("containers.Map({names}, {})", cell(entries.iter().map(|(_, value)| literal(value))))
        }
    }
}

/// Whether a struct can have a field of this name.
fn is_field(name: &str) -> bool {
    let is_word = name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
    let is_name = name.starts_with(|first: char| first.is_ascii_alphabetic());
    is_word && is_name && name.len() <= LONGEST && !RESERVED.contains(&name)
}

fn cell(items: impl Iterator<Item = String>) -> String {
    format!("{{{}}}", items.collect::<Vec<_>>().join(", "))
}

/// A text between single quotation marks, which are doubled in it. What is not a letter or a sign is written by its number.
fn quoted(text: &str) -> String {
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
    use osim_requests::Request;
    use serde_json::{Value, json};

    use super::*;

    #[track_caller]
    fn is_spelled(request: &Value, expected: &str) {
        let request = Request::from_json(request.to_string().as_bytes()).unwrap();
        assert_eq!(matlab(&Fields::of(&request)), format!("result = osimcontact.{expected};"));
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
            assert_eq!(quoted(text), expected);
        }
    }

    #[test]
    fn options_are_pairs_of_a_name_and_a_value() {
        is_spelled(
            &json!({"verb": "rescale", "models": "human.osim", "target_mass": 500, "level": true, "diff": true, "quiet": true}),
            "rescale('human.osim', 'TargetMass', 500, 'Level', true)",
        );
        is_spelled(
            &json!({"verb": "design", "radius": 0.032, "indentation": 0.16, "mass": 62, "spheres": 6}),
            "design('Radius', 0.032, 'Indentation', 0.16, 'Mass', 62, 'Spheres', 6)",
        );
        is_spelled(
            &json!({"verb": "add", "models": "bare.osim", "from": "-x.osim", "class": "smooth"}),
            "add('bare.osim', 'From', '-x.osim', 'Class', 'smooth')",
        );
    }

    #[test]
    fn lists_are_cells_and_maps_are_structs() {
        is_spelled(
            &json!({"verb": "set", "models": ["a.osim", "b.osim"], "set": {"stiffness": "x2", "dissipation": 1.5}, "select": ["*_r", "*_l"]}),
            "set({'a.osim', 'b.osim'}, 'Set', struct('stiffness', 'x2', 'dissipation', 1.5), 'Select', {'*_r', '*_l'})",
        );
        is_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "follow_bodies": true, "body_scale": {"calcn_r": [1.1, 1.05, 1.1]}}),
            "transfer('a.osim', 'From', 'g.osim', 'FollowBodies', true, 'BodyScale', struct('calcn_r', [1.1, 1.05, 1.1]))",
        );
    }

    #[test]
    fn names_that_no_field_of_a_struct_can_have_are_keys() {
        is_spelled(
            &json!({"verb": "transfer", "models": "a.osim", "from": "g.osim", "follow_bodies": true, "body_scale": {"foot l": 2, "toes": [1, 2, 3]}}),
            "transfer('a.osim', 'From', 'g.osim', 'FollowBodies', true, \
             'BodyScale', containers.Map({'foot l', 'toes'}, {[2, 2, 2], [1, 2, 3]}))",
        );
        assert!(["end", "_a", "1a", "ä", ""].into_iter().all(|name| !is_field(name)) && is_field("calcn_r"));
    }
}
