//! The note, `mass` and the bodies give different masses.

use crate::messages::{Phrase, phrase, readable};

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::MassSourcesDisagree,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "The note, `mass` and the bodies give different masses.",
    why: "The factor of every change follows from the mass the contacts are made for; a wrong one scales all of them wrongly.",
    advice: "Check the mass that was taken (the first line of the output) and say `contacts_mass=KG` if it is not the right one",
    repair: Repair::NotPossible("only you know which of the masses is right"),
    example: Example::Models { good: "walks/child.osim", bad: "walks/scaled_noted.osim" },
};

/// A mass, and where it is from, in words.
pub(crate) struct Said {
    pub(crate) kg: f64,
    pub(crate) source: Phrase,
}

/// Contacts are taken as made for one mass, and something else says another.
pub(crate) fn of_masses(taken: &Said, other: &Said) -> Finding {
    let message = phrase![
        format!("contacts are taken as made for {} kg (", readable(taken.kg)),
        &taken.source,
        "), but ",
        &other.source,
        format!(" says {} kg", readable(other.kg)),
    ];
    Finding::new(&RULE, message)
}
