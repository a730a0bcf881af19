//! One verdict, as data.

use osim_model::messages::Phrase;
use osim_model::{FindingCode, Severity, VerdictOn};
use osim_requests::spell::Speller;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::findings::Found;

/// The answer to one of the six questions, or to that of a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
pub struct Verdict {
    /// What it is on: `floor`, `standing`, `mass`, `sides`, `sizes` or `solver`; with a recording `motion`, too.
    #[serde(serialize_with = "name")]
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub on: VerdictOn,
    /// How it is: `good`, `info`, `warn`, `error` or `unknown`.
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub sign: Sign,
    /// The answer in words, with the number that decides.
    #[serde(serialize_with = "text")]
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub text: Phrase,
    /// Component path of the force, sphere or body that decides, where there is one.
    pub place: Option<String>,
    /// Codes of the findings that are about it, the worst first; empty if it is right or not known.
    #[serde(serialize_with = "codes")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub codes: Vec<FindingCode>,
}

/// How a question is answered: right, as bad as the worst finding, or not at all.
///
/// Exhaustive: the JSON of a verdict promises these five.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Sign {
    /// Nothing was found.
    Good,
    /// A remark.
    Info,
    /// A warning.
    Warn,
    /// An error.
    Error,
    /// Something that decides is not known.
    Unknown,
}

impl Sign {
    /// As in JSON.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Info => "info",
            Self::Warn => "warn",
            Self::Error => "error",
            Self::Unknown => "unknown",
        }
    }
}

impl From<Severity> for Sign {
    fn from(severity: Severity) -> Self {
        match severity {
            Severity::Info => Self::Info,
            Severity::Warn => Self::Warn,
            Severity::Error => Self::Error,
        }
    }
}

impl Verdict {
    /// The answer to the question whether contacts fit a recording.
    #[must_use]
    pub fn on_recording(sign: Sign, text: Phrase) -> Self {
        Self { on: VerdictOn::Recording, sign, text, place: None, codes: Vec::new() }
    }

    /// The worst finding decides; the codes of `others` are named.
    pub(super) fn of_findings(on: VerdictOn, worst: &Found, others: &[&Found]) -> Self {
        let mut codes = vec![worst.code()];
        for code in others.iter().map(|found| found.code()) {
            if !codes.contains(&code) {
                codes.push(code);
            }
        }
        let (sign, text) = (worst.severity.into(), worst.message.clone());
        Self { on, sign, text, place: worst.place.clone(), codes }
    }

    /// The same with something more that is known.
    pub(super) fn and(mut self, more: Option<Phrase>) -> Self {
        if let Some(more) = more {
            self.text.push("; ");
            self.text.push(&more);
        }
        self
    }

    /// What is right, or why that is not known.
    pub(super) fn without_findings(on: VerdictOn, right: Result<Phrase, Phrase>) -> Self {
        let (sign, text) = match right {
            Ok(text) => (Sign::Good, text),
            Err(why) => (Sign::Unknown, why),
        };
        Self { on, sign, text, place: None, codes: Vec::new() }
    }

    /// Spells what it says in the words of a front end.
    pub(crate) fn spell(&mut self, speller: &dyn Speller) {
        self.text.spell(speller);
    }
}

fn name<S: Serializer>(on: &VerdictOn, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(on.as_str())
}

fn text<S: Serializer>(text: &Phrase, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(text)
}

fn codes<S: Serializer>(codes: &[FindingCode], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(codes.iter().map(|code| code.as_str()))
}
