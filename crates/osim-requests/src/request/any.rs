//! Any request: from a dictionary, from and to JSON, and its text in the note of a changed model.

use std::path::Path;

use osim_model::messages::Verb;
use serde_json::error::Category;
use serde_json::{Map, Value};

use crate::dictionary::{self, all_fields};
use crate::fault::RequestFault;
use crate::options::{AnswerOptions, MassOptions, OutputOptions, RunOptions, SetFiles};
use crate::request::verbs::{Request, VERB_FIELD};
use crate::values::typed_numbers::trimmed;

impl Request {
    /// Reads the fields of a request for `verb`.
    ///
    /// # Errors
    /// An unknown field of the verb, a value of the wrong form, or fields that contradict or need each other.
    pub fn read(verb: Verb, fields: Map<String, Value>) -> Result<Self, RequestFault> {
        Self::read_checking(verb, fields, |_| true)
    }

    /// The mass options of a verb that changes models.
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
    /// Reads a request from a JSON object with its verb and its fields.
    ///
    /// # Errors
    /// The bytes are not a JSON object, have no verb, or have a fault of [`Request::read`].
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

    /// Reads a request from a dictionary with its verb and its fields.
    ///
    /// # Errors
    /// The dictionary has no verb, or has a fault of [`Request::read`].
    pub fn from_map(mut fields: Map<String, Value>) -> Result<Self, RequestFault> {
        let verb = fields.shift_remove(VERB_FIELD).ok_or(RequestFault::Missing { field: VERB_FIELD })?;
        let known = verb.as_str().and_then(Verb::find);
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

    /// The request as a JSON object, without fields that have their default values.
    pub fn to_json(&self) -> String {
        Value::Object(self.to_map()).to_string()
    }
}

// What results follow from, and what the note of a changed model says of it.

/// The fields with the names of the models to change.
const FIELDS_OF_MODELS: [&str; 2] = ["models", "file"];

/// Fields that are not in the list of options in a note, because its operation, mass or reference has them: see `Step` of
/// `osim-model`.
const FIELDS_NOTED_ELSEWHERE: [&str; 5] = ["verb", "from", "target_mass", "set", "stance_limbs"];

/// The parts of a request that the note of a changed model records.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct NoteDetails {
    /// The options on which the new numbers depend, as `name=value`: without models, masses and answers. For files that are
    /// read, only the name without folders, because a model is copied to other computers.
    pub options: String,
    /// Limbs that share the body weight, if the request gives them.
    pub stance_limbs: Option<f64>,
}

impl Request {
    /// The given fields on which the numbers of a result depend. Not among them: the models, the places of results, the
    /// options of a run, and answers to questions.
    pub fn settings(&self) -> Map<String, Value> {
        let others = [
            all_fields(&AnswerOptions::default()),
            all_fields(&OutputOptions::default()),
            all_fields(&RunOptions::default()),
        ];
        let is_other = |name: &String| {
            FIELDS_OF_MODELS.contains(&name.as_str()) || others.iter().any(|fields| fields.contains_key(name))
        };
        self.to_map().into_iter().filter(|(name, _)| !is_other(name)).collect()
    }
}

impl NoteDetails {
    /// Chooses what the note records of a request for `verb` with these [`settings`](Request::settings).
    pub fn of(verb: Verb, settings: &Map<String, Value>) -> Self {
        let others = [all_fields(&MassOptions::default()), all_fields(&SetFiles::default())];
        let is_elsewhere = |name: &str, value: &Value| match name {
            // A factor is in the operation.
            "radius" => value.as_str().is_some_and(|text| text.starts_with('x')),
            "level" => verb == Verb::Set,
            name => {
                FIELDS_NOTED_ELSEWHERE.contains(&name)
                    || others.iter().any(|fields| fields.contains_key(name))
            }
        };
        let stance_limbs = settings.get("stance_limbs").and_then(Value::as_f64);
        let noted = settings.iter().filter(|(name, value)| !is_elsewhere(name, value));
        let options = noted.map(|(name, value)| format!("{name}={}", as_one_word(value)));
        Self { options: options.collect::<Vec<_>>().join(" "), stance_limbs }
    }
}

fn as_one_word(value: &Value) -> String {
    match value {
        Value::String(text) => {
            let name = Path::new(text).file_name().unwrap_or_default().to_string_lossy().into_owned();
            trimmed(&name).replace(' ', "_")
        }
        Value::Array(items) => items.iter().map(as_one_word).collect::<Vec<_>>().join(","),
        Value::Object(fields) => {
            let each = fields.iter().map(|(name, value)| format!("{name}:{}", as_one_word(value)));
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
        let request = Request::from_json(json.as_bytes()).unwrap();
        assert_eq!(NoteDetails::of(request.verb(), &request.settings()).options, noted);
    }

    #[test]
    fn a_note_has_options_for_numbers_without_folders() {
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
