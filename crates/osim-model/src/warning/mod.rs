//! Things a user should know about a model or a change, each with a stable code and an explanation.

mod register;
mod severity;

use crate::wording::{Dialect, Phrase};

pub use register::WarningCode;
pub use severity::{Seen, Severity};

/// One thing to know.
///
/// ```
/// use osim_model::{Warning, WarningCode};
///
/// let warning = Warning::new(WarningCode::NotHertz, "/forceset/foot is an ElasticFoundationForce: left as it is");
/// assert_eq!(warning.code.as_str(), "not-hertz");
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Warning {
    /// Which kind.
    pub code: WarningCode,
    /// This case, in words.
    pub message: Phrase,
    /// Line in the model, where there is one.
    pub line: Option<usize>,
    /// Component path of the force, sphere or body concerned, where it is one.
    pub subject: Option<String>,
}

impl Warning {
    /// A warning without a place.
    pub fn new(code: WarningCode, message: impl Into<Phrase>) -> Self {
        Self { code, message: message.into(), line: None, subject: None }
    }

    /// A warning about a line of the model.
    pub fn at(code: WarningCode, line: usize, message: impl Into<Phrase>) -> Self {
        Self { line: Some(line), ..Self::new(code, message) }
    }

    /// The same, about the component at `path`.
    #[must_use]
    pub fn about(self, path: &str) -> Self {
        Self { subject: Some(path.to_owned()), ..self }
    }

    /// Spells its message in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        self.message.spell(dialect);
    }
}
