//! Things a user should know about a model or a change, each with a stable code and an explanation.

mod code;
mod rule;
mod severity;
mod verdict_on;

use crate::messages::{Dialect, Phrase};

pub use code::FindingCode;
pub use rule::{Example, Repair, Rule};
pub use severity::{Seen, Severity};
pub use verdict_on::VerdictOn;

/// One thing to know, about a model or about a change of it.
///
/// ```
/// use osim_model::{FindingCode, Model, Severity};
///
/// # let text = include_str!("../../../tests/data/one_foot.osim");
/// // A force without a stiffness has OpenSim's default, 1 N/m², which carries nothing.
/// let model = Model::parse(text.replace("<stiffness>1000000</stiffness>", ""))?;
/// let finding = &model.warnings[0];
/// assert_eq!((finding.code(), finding.code().as_str()), (FindingCode::DefaultStiffness, "default-stiffness"));
/// assert_eq!(finding.place.as_deref(), Some("/forceset/contact_heel_r"));
/// // What a code means is the same for every case of it.
/// assert_eq!(finding.rule.severity, Severity::Error);
/// assert!(finding.advice.to_string().starts_with("Set a stiffness"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Finding {
    /// Which kind.
    pub rule: &'static Rule,
    /// How bad it is: as the rule says, but for the published state of known contacts.
    pub severity: Severity,
    /// This case, in words.
    pub message: Phrase,
    /// Why it matters, from the rule.
    pub why: Phrase,
    /// What to do about it, from the rule.
    pub advice: Phrase,
    /// Component path of the force, sphere or body concerned, where it is one; of the worst where it is several.
    pub place: Option<String>,
    /// Names of all spheres concerned, where it is about spheres.
    pub spheres: Vec<String>,
    /// Line in the model, from 1, where there is one.
    pub line: Option<usize>,
}

impl Finding {
    /// A finding without a place.
    pub fn new(rule: &'static Rule, message: impl Into<Phrase>) -> Self {
        Self {
            rule,
            severity: rule.severity,
            message: message.into(),
            why: rule.why(),
            advice: rule.advice(),
            place: None,
            spheres: Vec::new(),
            line: None,
        }
    }

    /// A finding about a line of the model, from 1.
    pub fn at(rule: &'static Rule, line: usize, message: impl Into<Phrase>) -> Self {
        Self { line: Some(line), ..Self::new(rule, message) }
    }

    /// The code of its rule.
    #[must_use]
    pub fn code(&self) -> FindingCode {
        self.rule.code
    }

    /// The same, about the component at `path`.
    #[must_use]
    pub fn about(self, path: &str) -> Self {
        Self { place: Some(path.to_owned()), ..self }
    }

    /// The same, about a line of the model, from 1, where there is one.
    #[must_use]
    pub fn on_line(self, line: Option<usize>) -> Self {
        Self { line, ..self }
    }

    /// The same about these spheres, by name.
    #[must_use]
    pub fn of_spheres(self, spheres: Vec<String>) -> Self {
        Self { spheres, ..self }
    }

    /// The same in other words.
    #[must_use]
    pub fn with_message(self, message: impl Into<Phrase>) -> Self {
        Self { message: message.into(), ..self }
    }

    /// The same with other advice than its rule's.
    #[must_use]
    pub fn with_advice(self, advice: impl Into<Phrase>) -> Self {
        Self { advice: advice.into(), ..self }
    }

    /// The same, as bad as `severity`.
    #[must_use]
    pub fn with_severity(self, severity: Severity) -> Self {
        Self { severity, ..self }
    }

    /// Spells what it says in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        for phrase in [&mut self.message, &mut self.why, &mut self.advice] {
            phrase.spell(dialect);
        }
    }
}
