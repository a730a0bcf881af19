//! Errors as the web page shows them.

use std::ops::Range;

use osim_model::Excerpt;
use osim_model::files::Failure;
use osim_model::messages::{Input, Phrase, terminal_safe};
use osim_requests::spell::Page;
use osim_requests::{RequestError, RequestFault};
use serde::Serialize;

/// An error that the page shows.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Problem {
    /// Stable short name of the error.
    code: &'static str,
    /// What is wrong, what was expected, and a way out.
    message: String,
    /// Name of the file that the error is about.
    model: Option<String>,
    line: Option<usize>,
    column: Option<usize>,
    /// The line of the file in which the error is, if the error is in a file.
    excerpt: Option<MarkedLine>,
    /// Whether the request could be done if the user said what must not be guessed.
    needs_answer: bool,
    /// Fields that the message names. The first is the field that answers the question.
    fields: Vec<String>,
    /// The field whose value is wrong.
    field: Option<String>,
}

/// A line of a file, with the marked part that is wrong.
#[derive(Debug, Serialize)]
struct MarkedLine {
    before: String,
    marked: String,
    after: String,
}

impl MarkedLine {
    fn of(excerpt: &Excerpt) -> Self {
        let (text, Range { start, end }) = (&excerpt.text, excerpt.marked.clone());
        // A place between two letters is shown by the one that follows.
        let next = || text.get(start..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
        let end = if end > start { end } else { start + next() };
        let piece = |piece: Option<&str>| terminal_safe(piece.unwrap_or_default()).into_owned();
        Self {
            before: piece(text.get(..start)),
            marked: piece(text.get(start..end)),
            after: piece(text.get(end..)),
        }
    }
}

/// What an answer to the page needs, or its problem.
pub(crate) type Result<T, E = Problem> = std::result::Result<T, E>;

impl Problem {
    /// The error for a wrong call, which is a defect of the page.
    pub(crate) fn wrong_call(message: impl Into<Phrase>) -> Self {
        Self::with_code("usage", &message.into())
    }

    /// An internal error, which a user should report.
    pub(crate) fn defect(message: impl std::fmt::Display) -> Self {
        let text = format!("this is a defect of osim-contact-scale, please report it: {message}");
        Self::with_code("internal", &text.into())
    }

    fn with_code(code: &'static str, message: &Phrase) -> Self {
        let fields = message.inputs().into_iter().map(|input| input.name().to_owned()).collect();
        Self { code, message: message.spelled(&Page), fields, ..Self::default() }
    }
}

impl From<Failure> for Problem {
    fn from(failure: Failure) -> Self {
        let mut problem = Self::with_code(failure.code, &failure.message);
        // A question is answered by `yes`; the other fields in the message are those that the user gave.
        problem.fields.sort_by_key(|field| field != Input::Yes.name());
        let excerpt = failure.excerpt.as_ref().map(MarkedLine::of);
        Self {
            model: Some(failure.model.to_string()),
            line: failure.line,
            column: failure.column,
            needs_answer: failure.needs_answer,
            excerpt,
            ..problem
        }
    }
}

impl From<RequestFault> for Problem {
    fn from(fault: RequestFault) -> Self {
        let missing = match fault {
            RequestFault::Missing { field } | RequestFault::Needs { other: field, .. } => Some(field),
            _ => None,
        };
        let problem = Self::with_code("usage", &fault.phrase());
        let fields = match missing {
            Some(field) => vec![field.to_owned()],
            None => problem.fields,
        };
        Self { field: fault.field().map(str::to_owned), needs_answer: missing.is_some(), fields, ..problem }
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
