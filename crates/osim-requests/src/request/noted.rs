//! What the note of a changed model says of the request.

use std::path::Path;

use osim_model::messages::Verb;
use serde_json::Value;

use super::any::Request;
use crate::dictionary::map;
use crate::options::{AnswerOptions, MassOptions, OutputOptions, RunOptions, SetFiles};
use crate::values::typed::trimmed;

/// Fields that the operation, the mass or the reference of a note gives: see `Step` of `osim-model`.
const SAID_ELSEWHERE: [&str; 6] = ["verb", "models", "from", "target_mass", "set", "stance_limbs"];

/// What the note of a changed model says of the request.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct NoteDetails {
    /// The options that decide which numbers result, as `name=value`: without files, masses and answers. Of files that are read, no
    /// folders, because a model travels.
    pub options: String,
    /// Limbs that share the body weight, where the request says so.
    pub stance_limbs: Option<f64>,
}

impl Request {
    /// What the note of a model that it changes says of it.
    #[must_use]
    pub fn noted(&self) -> NoteDetails {
        let others = [
            map(&AnswerOptions::default()),
            map(&MassOptions::default()),
            map(&OutputOptions::default()),
            map(&RunOptions::default()),
            map(&SetFiles::default()),
        ];
        let is_elsewhere = |name: &str, value: &Value| match name {
            // A factor is in the operation.
            "radius" => value.as_str().is_some_and(|text| text.starts_with('x')),
            "level" => self.verb() == Verb::Set,
            name => SAID_ELSEWHERE.contains(&name) || others.iter().any(|fields| fields.contains_key(name)),
        };
        let said = self.to_map();
        let stance_limbs = said.get("stance_limbs").and_then(Value::as_f64);
        let noted = said.into_iter().filter(|(name, value)| !is_elsewhere(name, value));
        let options = noted.map(|(name, value)| format!("{name}={}", in_a_word(&value)));
        NoteDetails { options: options.collect::<Vec<_>>().join(" "), stance_limbs }
    }
}

fn in_a_word(value: &Value) -> String {
    match value {
        Value::String(text) => {
            let name = Path::new(text).file_name().unwrap_or_default().to_string_lossy().into_owned();
            trimmed(&name).replace(' ', "_")
        }
        Value::Array(items) => items.iter().map(in_a_word).collect::<Vec<_>>().join(","),
        Value::Object(fields) => {
            let each = fields.iter().map(|(name, value)| format!("{name}:{}", in_a_word(value)));
            each.collect::<Vec<_>>().join(",")
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn notes(json: &str, noted: &str) {
        assert_eq!(Request::from_json(json.as_bytes()).unwrap().noted().options, noted);
    }

    #[test]
    fn what_decides_numbers_is_told_and_where_files_are_is_not() {
        notes(r#"{"verb": "rescale", "models": "/home/me/a.osim", "target_mass": 80, "radius": "x2"}"#, "");
        notes(
            r#"{"verb": "rescale", "models": "a.osim", "target_mass": 80, "radius": "keep", "level": true, "only": ["radius", "stiffness"],
                "output": "b.osim", "yes": ["implausible-mass"]}"#,
            "radius=keep level=true only=radius,stiffness",
        );
        notes(
            r#"{"verb": "transfer", "models": "a.osim", "from": "b.osim", "body_scale_file": "/home/me/my scales.xml",
                "follow_bodies": true, "stance_limbs": 2}"#,
            "follow_bodies=true body_scale_file=my_scales.xml",
        );
    }
}
