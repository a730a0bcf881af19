//! Requests as JSON texts.

use std::path::Path;

use osim_model::messages::Verb;
use serde_json::error::Category;
use serde_json::{Map, Value};

use crate::fault::RequestFault;
use crate::request::Request;
use crate::unique;
use crate::values::path;

/// What some editors write before a text in UTF-8.
const UTF8_MARK: &[u8] = b"\xEF\xBB\xBF";

/// What is before a text in UTF-16, as PowerShell's `>` writes it.
const UTF16_MARKS: [&[u8]; 2] = [b"\xFF\xFE", b"\xFE\xFF"];

/// Fields that name files to be read.
const FILES_READ: [&str; 10] = [
    "models",
    "model",
    "subject",
    "from",
    "compare",
    "geometry",
    "manifest",
    "file",
    "presets",
    "body_scale_file",
];

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
        let value = unique::from_slice(text).map_err(|error| match error.classify() {
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
        let verb = fields.shift_remove("verb").ok_or(RequestFault::Missing { field: "verb" })?;
        let known = Verb::ALL.iter().copied().find(|known| verb.as_str() == Some(known.name()));
        let Some(known) = known else {
            let names: Vec<&str> = Verb::ALL.iter().map(|verb| verb.name()).collect();
            return Err(RequestFault::BadValue {
                field: "verb".to_owned(),
                value: verb.as_str().map_or_else(|| verb.to_string(), str::to_owned),
                reason: format!("expected one of {}", names.join(", ")),
            });
        };
        Self::read(known, fields)
    }

    /// The request as a JSON object, without fields that have their defaults.
    #[must_use]
    pub fn to_json(&self) -> String {
        Value::Object(self.to_map()).to_string()
    }

    /// The field that names `file` as one to be read, if any does: standard input, for one, cannot be read twice.
    #[must_use]
    pub fn field_that_reads(&self, file: &Path) -> Option<&'static str> {
        let fields = self.to_map();
        let file = path::to_value(file);
        FILES_READ.into_iter().find(|field| match fields.get(*field) {
            Some(Value::Array(items)) => items.contains(&file),
            Some(value) => *value == file,
            None => false,
        })
    }
}
