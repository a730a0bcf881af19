//! Rules, and findings: cases of rules in a model or a change.

mod code;

use contact_scaling::limits;

use crate::messages::{Dialect, Phrase};
pub use code::{FindingCode, Severity, VerdictOn};

/// One case of a rule in a model or in a change, with its place and message.
///
/// ```
/// use osim_model::{FindingCode, Model, Severity};
///
/// # let text = include_str!("../../../tests/data/one_foot.osim");
/// let off = "<stiffness>1000000</stiffness><appliesForce>false</appliesForce>";
/// let model = Model::parse(text.replace("<stiffness>1000000</stiffness>", off))?;
/// let finding = &model.remarks_on(&model.force_ids())[0];
/// assert_eq!((finding.code(), finding.code().as_str()), (FindingCode::DisabledForce, "disabled-force"));
/// assert_eq!(finding.place.as_deref(), Some("/forceset/contact_heel_r"));
/// // The rule is shared by all findings of one code.
/// assert_eq!(finding.rule.severity, Severity::Remark);
/// assert!(finding.advice.to_string().starts_with("Nothing, if that is meant"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Finding {
    pub rule: &'static Rule,
    /// The severity of the rule; lower for the published state of known contacts.
    pub severity: Severity,
    pub message: Phrase,
    pub why: Phrase,
    /// Advice about the finding, from the rule.
    pub advice: Phrase,
    /// Component path of the force, sphere or body concerned, where it is one; of the worst where it is several.
    pub place: Option<String>,
    /// Names of all spheres concerned, where it is about spheres.
    pub spheres: Vec<String>,
    /// Line in the model, from 1, where there is one.
    pub line: Option<usize>,
    /// Of the result of a change: whether the model before it, or the reference, has this finding, too.
    pub had_before: bool,
    /// A sentence for each element that it is about, where there is more to say than its name.
    pub details: Vec<String>,
    /// How bad it is, to compare it with the same finding in other models.
    pub measure: Option<Measure>,
}

/// How bad a finding is.
#[derive(Debug, Clone, PartialEq)]
pub struct Measure {
    /// The larger, the worse.
    pub size: f64,
    /// In a few words, with the unit; may be empty.
    pub text: String,
}

impl Finding {
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
            had_before: false,
            details: Vec::new(),
            measure: None,
        }
    }

    pub fn at(rule: &'static Rule, line: usize, message: impl Into<Phrase>) -> Self {
        Self { line: Some(line), ..Self::new(rule, message) }
    }

    pub fn code(&self) -> FindingCode {
        self.rule.code
    }

    pub fn with_place(self, path: &str) -> Self {
        Self { place: Some(path.to_owned()), ..self }
    }

    pub fn with_line(self, line: Option<usize>) -> Self {
        Self { line, ..self }
    }

    pub fn with_spheres(self, spheres: Vec<String>) -> Self {
        Self { spheres, ..self }
    }

    pub fn with_details(self, details: Vec<String>) -> Self {
        Self { details, ..self }
    }

    pub fn with_measure(self, size: f64, text: impl Into<String>) -> Self {
        Self { measure: Some(Measure { size, text: text.into() }), ..self }
    }

    pub fn with_message(self, message: impl Into<Phrase>) -> Self {
        Self { message: message.into(), ..self }
    }

    pub fn with_advice(self, advice: impl Into<Phrase>) -> Self {
        Self { advice: advice.into(), ..self }
    }

    pub fn with_severity(self, severity: Severity) -> Self {
        Self { severity, ..self }
    }

    /// Spells its texts in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        for phrase in [&mut self.message, &mut self.why, &mut self.advice] {
            phrase.spell(dialect);
        }
    }
}

/// A kind of finding: its code, its texts and an example. In the texts, inputs and calls are in backticks, see
/// [`Phrase::template`], and numbers of limits are in braces.
#[derive(Debug, PartialEq, Eq)]
#[expect(clippy::exhaustive_structs, reason = "every rule is written out in full")]
pub struct Rule {
    pub code: FindingCode,
    pub severity: Severity,
    /// The verdict that it decides, if one.
    pub verdict: Option<VerdictOn>,
    pub what: &'static str,
    pub why: &'static str,
    pub advice: &'static str,
    /// The command that repairs the model, or why no command does.
    pub repair: Repair,
    pub example: Example,
}

/// Whether a command can be proposed that puts a finding right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Repair {
    /// Yes, if the model can be changed: what the command does.
    Command(&'static str),
    /// No request repairs it; the text says why.
    NotPossible(&'static str),
    /// No, and why: only a change raises the finding, not a model.
    OnlyInChange(&'static str),
}

/// An example that raises a finding, and one that does not. Models are those of `fixtures/`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Example {
    /// A piece of a model: it has `good`, and raises the finding with `bad` in its place.
    Piece {
        model: &'static str,
        good: &'static str,
        bad: &'static str,
    },
    Models {
        good: &'static str,
        bad: &'static str,
    },
    /// A request, as JSON, that raises the finding.
    Request {
        good: &'static str,
        bad: &'static str,
    },
    /// Files beside each other, in words: a test of its own makes them.
    InWords {
        good: &'static str,
        bad: &'static str,
    },
}

impl Rule {
    pub fn what(&self) -> Phrase {
        with_limits(self.what)
    }

    pub fn why(&self) -> Phrase {
        with_limits(self.why)
    }

    pub fn advice(&self) -> Phrase {
        with_limits(self.advice)
    }
}

impl Repair {
    /// The text as a sentence, without its full stop.
    pub fn sentence(self) -> String {
        match self {
            Self::Command(what) => format!("check proposes a command that {what}"),
            Self::NotPossible(why) | Self::OnlyInChange(why) => format!("no command is proposed: {why}"),
        }
    }
}

/// The phrase of a template in which the limits of contact-scaling have names in braces.
fn with_limits(text: &str) -> Phrase {
    if !text.contains('{') {
        return Phrase::template(text.trim_ascii());
    }
    let named = [
        ("{indentation}", limits::INDENTATION.value),
        ("{restitution}", limits::RESTITUTION.value),
        ("{constant_indentation}", limits::CONSTANT_INDENTATION.value),
        ("{suggested_indentation}", limits::SUGGESTED_CONSTANT_INDENTATION),
        ("{suggested_width}", limits::SUGGESTED_TRANSITION_WIDTH),
    ];
    let text =
        named.iter().fold(text.to_owned(), |text, (name, value)| text.replace(name, &value.to_string()));
    Phrase::template(text.trim_ascii())
}
