//! What went wrong with one file, by its name.

use crate::messages::Phrase;

use super::file_name::FileName;
use crate::model::fault::{Excerpt, Fault, FaultKind};

/// One model that could not be read or changed, or a file that it needs.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Failure {
    /// The file, as it was named.
    pub model: FileName,
    /// Stable short name, as in the JSON `code`.
    pub code: &'static str,
    /// What is wrong, what was expected, and a way out.
    pub message: Phrase,
    /// Line of the place, from 1.
    pub line: Option<usize>,
    /// Column of the place in characters, from 1.
    pub column: Option<usize>,
    /// The line itself.
    pub excerpt: Option<Excerpt>,
    /// Whether it could be done if the caller answered something that must not be guessed.
    pub needs_answer: bool,
}

impl Failure {
    /// `fault` in the file `model`, with the place that it has once it is [`located`](Fault::located).
    #[must_use]
    pub fn of_fault(model: impl Into<FileName>, fault: Fault) -> Self {
        Self {
            model: model.into(),
            code: fault.code(),
            message: fault.phrase(),
            line: fault.position.map(|position| position.line),
            column: fault.position.map(|position| position.column),
            needs_answer: matches!(fault.kind, FaultKind::Needed(_) | FaultKind::NeedsAnswer(_)),
            excerpt: fault.excerpt,
        }
    }

    /// Something outside the contents of the file: folders, permissions, other files.
    pub fn outside(model: impl Into<FileName>, code: &'static str, message: impl Into<Phrase>) -> Self {
        Self {
            model: model.into(),
            code,
            message: message.into(),
            line: None,
            column: None,
            excerpt: None,
            needs_answer: false,
        }
    }
}
