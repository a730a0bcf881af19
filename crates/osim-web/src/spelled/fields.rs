//! The fields of a request, as every language writes them.

use osim_messages::{Verb, shortest};
use osim_requests::Request;
use serde_json::{Map, Value};

/// A request, taken apart.
#[derive(Debug)]
pub(super) struct Fields {
    pub(super) verb: Verb,
    /// What has no name in a call.
    pub(super) models: Vec<String>,
    /// Everything else that says something, by the names of requests and in their order.
    pub(super) options: Vec<(String, FieldValue)>,
}

/// What a field says.
#[derive(Debug)]
pub(super) enum FieldValue {
    /// Its name alone says it.
    Flag,
    /// A number, in the shortest digits that give it back.
    Number(String),
    Text(String),
    List(Vec<FieldValue>),
    /// Properties or bodies with their values.
    Map(Vec<(String, FieldValue)>),
}

impl Fields {
    pub(super) fn of(request: &Request) -> Self {
        let (mut models, mut options) = (Vec::new(), Vec::new());
        for (name, value) in request.to_map() {
            match (name.as_str(), FieldValue::of(value)) {
                ("verb", _) | (_, None) => {}
                ("models", Some(FieldValue::List(names))) => {
                    models.extend(names.into_iter().map(FieldValue::into_text));
                }
                (_, Some(value)) => options.push((name, value)),
            }
        }
        Self { verb: request.verb(), models, options }
    }

    /// The options, but for those of these names.
    pub(super) fn without(&self, names: &[&str]) -> impl Iterator<Item = &(String, FieldValue)> {
        self.options.iter().filter(move |(name, _)| !names.contains(&name.as_str()))
    }

    /// The options of these names.
    pub(super) fn only(&self, names: &[&str]) -> impl Iterator<Item = &(String, FieldValue)> {
        self.options.iter().filter(move |(name, _)| names.contains(&name.as_str()))
    }

    /// Whether one of these options says something.
    pub(super) fn says(&self, names: &[&str]) -> bool {
        self.only(names).next().is_some()
    }
}

impl FieldValue {
    /// `None` where it says nothing.
    fn of(value: Value) -> Option<Self> {
        Some(match value {
            Value::Null | Value::Bool(false) => return None,
            Value::Bool(true) => Self::Flag,
            Value::Number(number) if number.is_f64() => {
                Self::Number(shortest(number.as_f64().unwrap_or_default()))
            }
            Value::Number(number) => Self::Number(number.to_string()),
            Value::String(text) => Self::Text(text),
            Value::Array(items) => Self::List(items.into_iter().filter_map(Self::of).collect()),
            Value::Object(entries) => match bytes_of(&entries) {
                Some(bytes) => Self::Text(String::from_utf8_lossy(&bytes).into_owned()),
                None => Self::Map(
                    entries.into_iter().filter_map(|(name, value)| Some((name, Self::of(value)?))).collect(),
                ),
            },
        })
    }

    /// The text or number; with commas between those of a list.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Number(text) | Self::Text(text) => text.clone(),
            Self::List(items) => items.iter().map(Self::text).collect::<Vec<_>>().join(","),
            Self::Flag | Self::Map(_) => String::new(),
        }
    }

    fn into_text(self) -> String {
        match self {
            Self::Number(text) | Self::Text(text) => text,
            other => other.text(),
        }
    }
}

/// The bytes of a name that is not UTF-8, which is `{"bytes": [...]}`. Factors of a body of that name are not whole numbers to JSON.
fn bytes_of(entries: &Map<String, Value>) -> Option<Vec<u8>> {
    let bytes = entries.get("bytes").filter(|_| entries.len() == 1)?.as_array()?;
    bytes.iter().map(|byte| byte.as_u64().and_then(|byte| u8::try_from(byte).ok())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn models_and_options_are_apart_and_numbers_are_short() {
        let request = br#"{"verb": "add", "models": ["a.osim", "b.osim"], "count": 3, "pad": 0.010, "feet": ["calcn_r"], "replace": true,
            "load": null, "force": false}"#;
        let fields = Fields::of(&Request::from_json(request).unwrap());
        assert_eq!(fields.models, ["a.osim", "b.osim"]);
        let options: Vec<(&str, String)> =
            fields.options.iter().map(|(name, value)| (name.as_str(), value.text())).collect();
        let expected = [("feet", "calcn_r"), ("count", "3"), ("pad", "0.01"), ("replace", "")];
        assert_eq!(options, expected.map(|(name, text)| (name, text.to_owned())));
    }

    #[test]
    #[cfg(unix)]
    fn names_that_are_not_text_are_not_bodies() {
        let request = br#"{"verb": "add", "models": {"bytes": [97, 255]}, "from": "b.osim", "body_scale": {"bytes": [1, 2, 1]}}"#;
        let fields = Fields::of(&Request::from_json(request).unwrap());
        assert_eq!(fields.models, ["a\u{fffd}"]);
        assert!(matches!(&fields.options[1], (name, FieldValue::Map(_)) if name == "body_scale"));
    }
}
