//! What is wrong with a call, in Python's words. A request has the values and types of JSON; a call has keywords and Python's own.

use osim_model::messages::{Dialect, Input, Phrase, phrase};
use osim_requests::RequestFault;
use osim_requests::spell::{Python as PythonWords, python_quoted};
use serde_json::Value;

/// Letters of a value that are shown.
const SHOWN: usize = 80;

/// What serde and the standard library say, beside what Python says for it.
const REASONS: [(&str, &str); 6] = [
    ("expected a boolean", "expected True or False"),
    ("expected a sequence", "expected a text, or a list of texts"),
    ("expected a string", "expected a text"),
    (", as text or as {\"bytes\": [...]}", ""),
    ("invalid digit found in string", "expected a whole number, 1 or more"),
    ("cannot parse integer from empty string", "expected a whole number, 1 or more"),
];

/// What is wrong, and the keyword that it is about, where it is one.
pub(crate) struct Wrong {
    pub(crate) message: Phrase,
    pub(crate) keyword: Option<String>,
}

impl Wrong {
    /// Of faults that JSON's words are in; none of all others.
    pub(crate) fn of(fault: &RequestFault) -> Option<Self> {
        match fault {
            RequestFault::BadValue { field, value, reason } if field == "set" => {
                Some(Self::property(value, reason))
            }
            RequestFault::BadValue { field, value, reason } => Some(Self::value(field, value, reason)),
            RequestFault::UnknownField { field, nearest } => {
                let own = keyword_of(field).unwrap_or_else(|| field.clone());
                let mut message = Phrase::from(format!("there is no keyword '{own}' here"));
                if let Some(name) = nearest.as_deref().and_then(keyword_of) {
                    message.push(&phrase![format!(": did you mean {name}=?")]);
                }
                Some(Self { message, keyword: Some(own) })
            }
            RequestFault::Missing { field: "models" } => {
                let message = "there are no models: the list is empty".into();
                Some(Self { message, keyword: None })
            }
            _ => None,
        }
    }

    fn value(field: &str, value: &str, reason: &str) -> Self {
        let keyword = keyword_of(field);
        let name = keyword.as_deref().map_or(String::new(), |keyword| format!("{keyword}="));
        let reason = in_python(reason);
        // Of a number that is too long for any message there is no value.
        let said = match value {
            "..." => keyword.clone().unwrap_or_else(|| "a value".to_owned()),
            value => format!("{name}{}", literal_of(value)),
        };
        Self { message: format!("{said}: {reason}").into(), keyword }
    }

    /// Of one of the properties that are set: each is a keyword of its own.
    fn property(all: &str, reason: &str) -> Self {
        let assigned = reason.split_once('=').filter(|(name, _)| all.contains(&format!("{name}=")));
        let Some((name, rest)) = assigned else {
            return Self { message: in_python(reason).into(), keyword: None };
        };
        let ends = rest.match_indices(": ").map(|(end, _)| end);
        // The value ends where the longest text ends that was given: there may be such a mark in it, too.
        let end = ends.clone().filter(|end| all.contains(&format!("{name}={}", &rest[..*end]))).last();
        let end = end.or_else(|| ends.clone().next()).unwrap_or(rest.len());
        let (value, why) = rest.split_at(end);
        let message = format!("{name}={}{}", literal_of(value), in_python(why)).into();
        Self { message, keyword: Some(name.to_owned()) }
    }
}

/// The keyword for a field; none for what has no keyword, such as the model.
pub(crate) fn keyword_of(field: &str) -> Option<String> {
    let input = Input::ALL.iter().find(|input| input.name() == field)?;
    PythonWords.input(*input, None).split('=').next().map(str::to_owned)
}

/// What was expected, where the words are those of JSON.
fn in_python(reason: &str) -> String {
    let expected = reason.find(", expected").filter(|_| reason.starts_with("invalid type: "));
    let reason = expected.and_then(|place| reason.get(place + 2..)).unwrap_or(reason);
    REASONS.iter().fold(reason.to_owned(), |reason, (from, to)| reason.replace(from, to))
}

/// A value as Python writes it. `given` is a text as it is, and all else in JSON.
fn literal_of(given: &str) -> String {
    match serde_json::from_str(given) {
        Ok(value @ (Value::Bool(_) | Value::Number(_) | Value::Array(_) | Value::Object(_)))
            if given.len() <= SHOWN =>
        {
            literal(&value)
        }
        _ => text(given),
    }
}

fn literal(value: &Value) -> String {
    match value {
        Value::Null => "None".to_owned(),
        Value::Bool(true) => "True".to_owned(),
        Value::Bool(false) => "False".to_owned(),
        Value::Number(number) => number.to_string(),
        Value::String(string) => text(string),
        Value::Array(items) => format!("[{}]", items.iter().map(literal).collect::<Vec<_>>().join(", ")),
        Value::Object(entries) => {
            let entries = entries.iter().map(|(name, value)| format!("{}: {}", text(name), literal(value)));
            format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
        }
    }
}

/// A text in quotation marks; of a long one, its beginning and how long it is.
fn text(whole: &str) -> String {
    match whole.char_indices().nth(SHOWN) {
        None => python_quoted(whole),
        Some((end, _)) => {
            let letters = whole.chars().count();
            format!("{}... ({letters} letters)", python_quoted(whole.get(..end).unwrap_or_default()))
        }
    }
}
