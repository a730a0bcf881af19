//! Any request: as a dictionary, as JSON, and as the note of a changed model says it.

use std::path::Path;

use osim_model::messages::Verb;
use serde_json::error::Category;
use serde_json::{Map, Value};

use crate::dictionary::{self, map};
#[cfg(feature = "clap")]
use crate::fault::Relation;
use crate::fault::RequestFault;
use crate::options::{AnswerOptions, MassOptions, OutputOptions, RunOptions, SetFiles};
use crate::request::verbs::{Request, VERB_FIELD};
use crate::values::typed::trimmed;

impl Request {
    /// Reads the fields of a request for `verb`.
    ///
    /// # Errors
    /// A field that the verb does not have, a value that cannot be taken, or fields that do not go together.
    pub fn read(verb: Verb, fields: Map<String, Value>) -> Result<Self, RequestFault> {
        Self::read_checking(verb, fields, |_| true)
    }

    /// Reads the fields that were typed, of which the parser of the command line checks whether they are required or exclude each other.
    #[cfg(feature = "clap")]
    pub(crate) fn read_typed(verb: Verb, fields: Map<String, Value>) -> Result<Self, RequestFault> {
        Self::read_checking(verb, fields, |relation| matches!(relation, Relation::Needs(..)))
    }

    /// Mass options of a verb that changes models.
    pub fn masses_mut(&mut self) -> Option<&mut MassOptions> {
        Some(match self {
            Self::Rescale(request) => &mut request.masses,
            Self::Transfer(request) => &mut request.masses,
            Self::Add(request) => &mut request.masses,
            Self::Design(request) => &mut request.masses,
            Self::Set(request) => &mut request.masses,
            _ => return None,
        })
    }
}

// Requests as JSON texts.

/// The bytes that some editors write before a text in UTF-8.
const UTF8_MARK: &[u8] = b"\xEF\xBB\xBF";

/// The bytes before a text in UTF-16, as PowerShell's `>` writes it.
const UTF16_MARKS: [&[u8]; 2] = [b"\xFF\xFE", b"\xFE\xFF"];

impl Request {
    /// Reads a request from a JSON object that has its verb and its fields.
    ///
    /// # Errors
    /// It is not a JSON object, has no verb, or as [`Request::read`].
    pub fn from_json(bytes: &[u8]) -> Result<Self, RequestFault> {
        let text = bytes.strip_prefix(UTF8_MARK).unwrap_or(bytes);
        if UTF16_MARKS.iter().any(|mark| text.starts_with(mark)) {
            return Err(RequestFault::general("this is UTF-16: save it as UTF-8"));
        }
        let value = dictionary::from_slice(text).map_err(|error| match error.classify() {
            Category::Data => RequestFault::general(error.to_string()),
            _ => RequestFault::general(format!("this is not JSON: {error}")),
        })?;
        match value {
            Value::Object(fields) => Self::from_map(fields),
            _ => Err(RequestFault::general("expected a JSON object such as {\"verb\": \"inspect\", ...}")),
        }
    }

    /// Reads a request from a dictionary that has its verb and its fields.
    ///
    /// # Errors
    /// It has no verb, or as [`Request::read`].
    pub fn from_map(mut fields: Map<String, Value>) -> Result<Self, RequestFault> {
        let verb = fields.shift_remove(VERB_FIELD).ok_or(RequestFault::Missing { field: VERB_FIELD })?;
        let known = verb.as_str().and_then(Verb::named);
        let Some(known) = known else {
            let names: Vec<&str> = Verb::ALL.iter().map(|verb| verb.name()).collect();
            return Err(RequestFault::BadValue {
                field: VERB_FIELD.to_owned(),
                value: verb.as_str().map_or_else(|| verb.to_string(), str::to_owned),
                reason: format!("expected one of {}", names.join(", ")),
            });
        };
        Self::read(known, fields)
    }

    /// The request as a JSON object, without fields that have their defaults.
    pub fn to_json(&self) -> String {
        Value::Object(self.to_map()).to_string()
    }
}

// What results follow from, and what the note of a changed model says of it.

/// The fields that name the models which are changed.
const FIELDS_OF_MODELS: [&str; 2] = ["models", "file"];

/// Fields that the operation, the mass or the reference of a note gives: see `Step` of `osim-model`.
const FIELDS_NOTED_ELSEWHERE: [&str; 6] = ["verb", "models", "from", "target_mass", "set", "stance_limbs"];

/// The parts of a request that the note of a changed model records.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct NoteDetails {
    /// The options that decide which numbers result, as `name=value`: without files, masses and answers. Of files that are read, no
    /// folders, because a model travels.
    pub options: String,
    /// Limbs that share the body weight, where the request says so.
    pub stance_limbs: Option<f64>,
}

impl Request {
    /// The fields that say something and that results follow from: all, but for the models, where results go, how the work is done,
    /// and answers, which only decide whether there is a result.
    pub fn settings(&self) -> Map<String, Value> {
        let others =
            [map(&AnswerOptions::default()), map(&OutputOptions::default()), map(&RunOptions::default())];
        let is_other = |name: &String| {
            FIELDS_OF_MODELS.contains(&name.as_str()) || others.iter().any(|fields| fields.contains_key(name))
        };
        self.to_map().into_iter().filter(|(name, _)| !is_other(name)).collect()
    }

    /// The parts of the request that the note of a changed model records.
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
            name => {
                FIELDS_NOTED_ELSEWHERE.contains(&name)
                    || others.iter().any(|fields| fields.contains_key(name))
            }
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
    fn assert_noted(json: &str, noted: &str) {
        assert_eq!(Request::from_json(json.as_bytes()).unwrap().noted().options, noted);
    }

    #[test]
    fn what_decides_numbers_is_told_and_where_files_are_is_not() {
        assert_noted(
            r#"{"verb": "rescale", "models": "/home/me/a.osim", "target_mass": 80, "radius": "x2"}"#,
            "",
        );
        assert_noted(
            r#"{"verb": "rescale", "models": "a.osim", "target_mass": 80, "radius": "keep", "level": true, "only": ["radius", "stiffness"],
            "output": "b.osim", "yes": ["implausible-mass"]}"#,
            "radius=keep level=true only=radius,stiffness",
        );
        assert_noted(
            r#"{"verb": "transfer", "models": "a.osim", "from": "b.osim", "body_scale_file": "/home/me/my scales.xml",
            "follow_bodies": true, "stance_limbs": 2}"#,
            "follow_bodies=true body_scale_file=my_scales.xml",
        );
    }
}
