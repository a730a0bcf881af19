//! Things a user should know about a model or a change, each with a stable code and an explanation.

mod register;
mod severity;

use crate::wording::{Dialect, Phrase};

pub use register::WarningCode;
pub use severity::{Seen, Severity};

/// One thing to know, about a model or about a change of it.
///
/// ```
/// use osim_model::{Model, Severity, WarningCode};
///
/// # let text = include_str!("../../tests/data/one_foot.osim");
/// // A force without a stiffness has OpenSim's default, 1 N/m², which carries nothing.
/// let model = Model::parse(text.replace("<stiffness>1000000</stiffness>", ""))?;
/// let warning = &model.warnings[0];
/// assert_eq!((warning.code, warning.code.as_str()), (WarningCode::DefaultStiffness, "default-stiffness"));
/// assert_eq!(warning.subject.as_deref(), Some("/forceset/contact_heel_r"));
/// // What a code means is the same for every case of it.
/// assert_eq!(warning.code.severity(), Severity::Error);
/// assert!(warning.code.remedy().to_string().starts_with("Set a stiffness"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Warning {
    /// Which kind.
    pub code: WarningCode,
    /// This case, in words.
    pub message: Phrase,
    /// Line in the model, from 1, where there is one.
    pub line: Option<usize>,
    /// Component path of the force, sphere or body concerned, where it is one.
    pub subject: Option<String>,
}

impl Warning {
    /// A warning without a place.
    pub fn new(code: WarningCode, message: impl Into<Phrase>) -> Self {
        Self { code, message: message.into(), line: None, subject: None }
    }

    /// A warning about a line of the model, from 1.
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
