//! What a code means: one static in a file of its own, beside what raises it.

use crate::messages::Phrase;
use contact_scaling::limits;

use super::code::FindingCode;
use super::severity::{Seen, Severity};
use super::verdict_on::VerdictOn;

/// A kind of finding: its code, its texts and an example. In the texts, inputs and calls are in backticks, see
/// [`Phrase::template`], and numbers of limits are in braces.
#[derive(Debug, PartialEq, Eq)]
#[expect(clippy::exhaustive_structs, reason = "every rule is written out in full")]
pub struct Rule {
    /// Its name.
    pub code: FindingCode,
    /// How bad it is.
    pub severity: Severity,
    /// Where it shows.
    pub seen: Seen,
    /// The verdict that it decides, if one.
    pub verdict: Option<VerdictOn>,
    /// What it is, in a sentence.
    pub what: &'static str,
    /// Why it matters.
    pub why: &'static str,
    /// What to do about it.
    pub advice: &'static str,
    /// The command that puts it right, or why there is none.
    pub repair: Repair,
    /// What raises it, and what does not.
    pub example: Example,
}

/// Whether a command can be proposed that puts a finding right.
///
/// Exhaustive: it can, or it cannot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Repair {
    /// Yes, where the model can be changed: what it does.
    Command(&'static str),
    /// No, and why.
    NotPossible(&'static str),
}

/// What raises a finding, and what does not. Models are those of `fixtures/`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Example {
    /// A piece of a model: it has `good`, and raises the finding with `bad` in its place.
    Piece {
        /// The model.
        model: &'static str,
        /// As it is there.
        good: &'static str,
        /// What raises the finding.
        bad: &'static str,
    },
    /// Whole models.
    Models {
        /// One without the finding.
        good: &'static str,
        /// One that has it.
        bad: &'static str,
    },
    /// Requests, as JSON.
    Request {
        /// One that raises nothing.
        good: &'static str,
        /// What raises the finding.
        bad: &'static str,
    },
    /// Files beside each other, in words: a test of its own makes them.
    InWords {
        /// Where nothing is wrong.
        good: &'static str,
        /// Where it is.
        bad: &'static str,
    },
}

impl Rule {
    /// What it is, in a sentence.
    #[must_use]
    pub fn what(&self) -> Phrase {
        template(self.what)
    }

    /// Why it matters.
    #[must_use]
    pub fn why(&self) -> Phrase {
        template(self.why)
    }

    /// What to do about it.
    #[must_use]
    pub fn advice(&self) -> Phrase {
        template(self.advice)
    }
}

impl Repair {
    /// In a sentence without its full stop.
    #[must_use]
    pub fn sentence(self) -> String {
        match self {
            Self::Command(what) => format!("check proposes a command that {what}"),
            Self::NotPossible(why) => format!("no command is proposed: {why}"),
        }
    }
}

/// A text in which the numbers of limits have names.
fn template(text: &str) -> Phrase {
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
