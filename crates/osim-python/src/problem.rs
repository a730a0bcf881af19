//! Turns failures and faults into exceptions of Python.

use std::ffi::OsString;

use osim_library::LibraryFault;
use osim_model::files::Failure;
use osim_model::messages::{Dialect, Input, Phrase, PhrasePart, Verb, phrase};
use osim_requests::spell::{Python as PythonWords, python_quoted};
use osim_requests::{RequestError, RequestFault};
use pyo3::exceptions::{PyException, PyRuntimeError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::Value;

/// The module with the classes of exceptions.
const ERRORS_MODULE: &str = "osim_contact_scale._errors";

/// A failure or fault that is about to become an exception of Python.
#[derive(Default)]
pub(crate) struct Problem {
    class: &'static str,
    code: &'static str,
    message: String,
    /// The file's path as the caller named it.
    path: Option<OsString>,
    line: Option<usize>,
    column: Option<usize>,
    /// The line of the file in which the error is, if the error is in a file.
    excerpt: Option<String>,
    /// Keyword arguments that the message names, in the order of the message.
    keywords: Vec<String>,
    /// An exception that Python raised during the call, which is raised again.
    raised: Option<PyErr>,
}

impl Problem {
    /// A problem that concerns no single model.
    pub(crate) fn general(class: &'static str, code: &'static str, message: impl Into<Phrase>) -> Self {
        let message = message.into();
        let (message, keywords) = (spelled(&message), keywords(&message));
        Self { class, code, message, keywords, ..Self::default() }
    }

    /// An internal error, which a user should report.
    pub(crate) fn defect(message: impl std::fmt::Display) -> Self {
        let text = format!("this is a defect of osim-contact-scale, please report it: {message}");
        Self { message: text, ..Self::general("ContactScaleError", "internal", "") }
    }

    /// A problem for wrong rows of a table, after which nothing was written.
    pub(crate) fn wrong_rows(wrong: &[Failure]) -> Self {
        const MAX_SHOWN_ROWS: usize = 20;
        let line =
            |failure: &Failure| format!("{}: {}", failure.model, failure.message.spelled(&PythonWords));
        let mut lines: Vec<String> = wrong.iter().take(MAX_SHOWN_ROWS).map(line).collect();
        if wrong.len() > MAX_SHOWN_ROWS {
            lines.push(format!("and {} more", wrong.len() - MAX_SHOWN_ROWS));
        }
        let rows = if wrong.len() == 1 { "1 row is".to_owned() } else { format!("{} rows are", wrong.len()) };
        // Each line is harmless by itself; as one text, their ends would be shown as numbers.
        let message = format!("{rows} wrong, so nothing was written:\n{}", lines.join("\n"));
        Self { message, ..Self::general("RequestError", "usage", "") }
    }

    /// An exception that Python raised during the call, as a problem.
    pub(crate) fn raised(error: PyErr) -> Self {
        Self { raised: Some(error), ..Self::general("ContactScaleError", "raised", "") }
    }

    /// The Python exception for this problem.
    pub(crate) fn into_error(mut self, py: Python<'_>) -> PyErr {
        if let Some(raised) = self.raised.take() {
            return raised;
        }
        let new_error = || -> PyResult<PyErr> {
            let class = py.import(ERRORS_MODULE)?.getattr(self.class)?;
            let fields = PyDict::new(py);
            fields.set_item("path", &self.path)?;
            fields.set_item("line", self.line)?;
            fields.set_item("column", self.column)?;
            fields.set_item("excerpt", &self.excerpt)?;
            fields.set_item("keywords", &self.keywords)?;
            let error = class.call((self.code, &self.message), Some(&fields))?;
            Ok(PyErr::from_value(error))
        };
        // Python runs while the exception is made. A Ctrl-C that comes up there must not get lost.
        new_error().unwrap_or_else(|error| match error.is_instance_of::<PyException>(py) {
            true => PyRuntimeError::new_err(self.message.clone()),
            false => error,
        })
    }
}

/// A message as Python spells options. If it begins with a keyword and its value, no blank is between them.
fn spelled(message: &Phrase) -> String {
    let text = message.spelled(&PythonWords);
    let Some(PhrasePart::Input(input, None)) = message.parts().first() else { return text };
    let keyword = PythonWords.input(*input, None);
    match text.strip_prefix(&keyword).and_then(|rest| rest.strip_prefix(" '")) {
        Some(value) => format!("{keyword}'{value}"),
        None => text,
    }
}

/// The inputs that a message names, as keyword arguments of Python.
fn keywords(message: &Phrase) -> Vec<String> {
    let mut all: Vec<String> =
        message.inputs().into_iter().filter_map(|input| keyword_for_field(input.name())).collect();
    all.dedup();
    all
}

impl From<Failure> for Problem {
    fn from(failure: Failure) -> Self {
        let class = if failure.needs_answer { "NeedsAnswer" } else { "ModelError" };
        let mut problem = Self::general(class, failure.code, &failure.message);
        // A question is answered by `yes`; the other keywords in the message are those that the caller gave.
        problem.keywords.sort_by_key(|keyword| keyword != Input::Yes.name());
        Self {
            path: Some(failure.model.to_path().into_os_string()),
            line: failure.line,
            column: failure.column,
            excerpt: failure.excerpt.as_ref().map(|excerpt| excerpt.text.clone()),
            ..problem
        }
    }
}

impl From<RequestFault> for Problem {
    fn from(fault: RequestFault) -> Self {
        // In Python every property is a keyword of its own.
        if matches!(fault, RequestFault::Missing { field: "set" }) {
            let example = Verb::Set.call_with_model().with_value(Input::Stiffness, "x2");
            return Self::general("RequestError", "usage", phrase!["say what to set, as in ", example]);
        }
        if let Some((message, keyword)) = fault_of_call(&fault) {
            let problem = Self::general("RequestError", "usage", message);
            return Self { keywords: keyword.into_iter().collect(), ..problem };
        }
        let mut problem = Self::general("RequestError", "usage", fault.phrase());
        if let Some(own) = fault.field().and_then(keyword_for_field) {
            problem.keywords.retain(|keyword| *keyword != own);
            problem.keywords.insert(0, own);
        }
        problem
    }
}

impl From<LibraryFault> for Problem {
    fn from(fault: LibraryFault) -> Self {
        // A message that begins with a keyword is about its value.
        match fault.phrase().parts().first() {
            Some(PhrasePart::Input(..)) => Self::general("RequestError", "usage", fault.phrase()),
            _ => Self::general("OutputError", "output", fault.phrase()),
        }
    }
}

impl From<RequestError> for Problem {
    fn from(error: RequestError) -> Self {
        match error {
            RequestError::Fault(fault) => fault.into(),
            RequestError::Failure(failure) => failure.into(),
        }
    }
}

// What is wrong with a call, in Python's words. A request has the values and types of JSON; a call has keywords and Python's own.

/// Most letters of a wrong value that a message shows.
const MAX_SHOWN_LETTERS: usize = 80;

/// Texts of serde and of the standard library, each with the text that replaces it in messages for Python.
const REASONS_IN_PYTHON: [(&str, &str); 6] = [
    ("expected a boolean", "expected True or False"),
    ("expected a sequence", "expected a text, or a list of texts"),
    ("expected a string", "expected a text"),
    (", as text or as {\"bytes\": [...]}", ""),
    ("invalid digit found in string", "expected a whole number, 1 or more"),
    ("cannot parse integer from empty string", "expected a whole number, 1 or more"),
];

/// A fault of a call, and the keyword argument that is wrong, if the fault concerns one.
type CallFault = (Phrase, Option<String>);

/// The fault of a request with a message for Python; `None` if the message of the request suits Python, too.
fn fault_of_call(fault: &RequestFault) -> Option<CallFault> {
    match fault {
        RequestFault::BadValue { field, value, reason } if field == "set" => {
            Some(fault_of_property(value, reason))
        }
        RequestFault::BadValue { field, value, reason } => Some(fault_of_value(field, value, reason)),
        RequestFault::UnknownField { field, nearest } => {
            let own = keyword_for_field(field).unwrap_or_else(|| field.clone());
            let mut message = Phrase::from(format!("there is no keyword '{own}' here"));
            if let Some(name) = nearest.as_deref().and_then(keyword_for_field) {
                message.push(&phrase![format!(": did you mean {name}=?")]);
            }
            Some((message, Some(own)))
        }
        RequestFault::Missing { field: "models" } => {
            Some(("there are no models: the list is empty".into(), None))
        }
        _ => None,
    }
}

fn fault_of_value(field: &str, value: &str, reason: &str) -> CallFault {
    let keyword = keyword_for_field(field);
    let name = keyword.as_deref().map_or(String::new(), |keyword| format!("{keyword}="));
    let reason = reason_in_python(reason);
    // Of a number that is too long for any message there is no value.
    let beginning = match value {
        "..." => keyword.clone().unwrap_or_else(|| "a value".to_owned()),
        value => format!("{name}{}", python_literal(value)),
    };
    (format!("{beginning}: {reason}").into(), keyword)
}

/// The fault of a property in the JSON object `all` of values to set. In Python each property is a keyword argument of its own.
fn fault_of_property(all: &str, reason: &str) -> CallFault {
    let assigned = reason.split_once('=').filter(|(name, _)| all.contains(&format!("{name}=")));
    let Some((name, rest)) = assigned else {
        return (reason_in_python(reason).into(), None);
    };
    let ends = rest.match_indices(": ").map(|(end, _)| end);
    // The value ends where the longest text ends that was given: there may be such a mark in it, too.
    let end = ends.clone().filter(|end| all.contains(&format!("{name}={}", &rest[..*end]))).last();
    let end = end.or_else(|| ends.clone().next()).unwrap_or(rest.len());
    let (value, why) = rest.split_at(end);
    let message = format!("{name}={}{}", python_literal(value), reason_in_python(why)).into();
    (message, Some(name.to_owned()))
}

/// The keyword argument for a field of a request; `None` for a field without a keyword, such as the model.
pub(crate) fn keyword_for_field(field: &str) -> Option<String> {
    let input = Input::ALL.iter().find(|input| input.name() == field)?;
    PythonWords.input(*input, None).split('=').next().map(str::to_owned)
}

/// The expectation `reason` with words of Python in place of words of JSON.
fn reason_in_python(reason: &str) -> String {
    let expected = reason.find(", expected").filter(|_| reason.starts_with("invalid type: "));
    let reason = expected.and_then(|place| reason.get(place + 2..)).unwrap_or(reason);
    REASONS_IN_PYTHON.iter().fold(reason.to_owned(), |reason, (from, to)| reason.replace(from, to))
}

/// A value as Python writes it. The value `given` is plain text, or JSON for anything else than text.
fn python_literal(given: &str) -> String {
    match serde_json::from_str(given) {
        Ok(value @ (Value::Bool(_) | Value::Number(_) | Value::Array(_) | Value::Object(_)))
            if given.len() <= MAX_SHOWN_LETTERS =>
        {
            literal_of_json(&value)
        }
        _ => shortened_quotation(given),
    }
}

fn literal_of_json(value: &Value) -> String {
    match value {
        Value::Null => "None".to_owned(),
        Value::Bool(true) => "True".to_owned(),
        Value::Bool(false) => "False".to_owned(),
        Value::Number(number) => number.to_string(),
        Value::String(string) => shortened_quotation(string),
        Value::Array(items) => {
            format!("[{}]", items.iter().map(literal_of_json).collect::<Vec<_>>().join(", "))
        }
        Value::Object(entries) => {
            let entries = entries
                .iter()
                .map(|(name, value)| format!("{}: {}", shortened_quotation(name), literal_of_json(value)));
            format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
        }
    }
}

/// A text in quotation marks; for a long text, its beginning and its length.
fn shortened_quotation(whole: &str) -> String {
    match whole.char_indices().nth(MAX_SHOWN_LETTERS) {
        None => python_quoted(whole),
        Some((end, _)) => {
            let letters = whole.chars().count();
            format!("{}... ({letters} letters)", python_quoted(whole.get(..end).unwrap_or_default()))
        }
    }
}
