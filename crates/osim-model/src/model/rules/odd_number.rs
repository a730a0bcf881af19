//! A number is written in a way that OpenSim reads differently from what it looks like.

use crate::xml::opensim_text::is_plain_triple;

use crate::model::finding::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::value::Value;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::OddNumber,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "A number is written in a way that OpenSim reads differently from what it looks like.",
    why: "OpenSim reads the start of a text as far as it looks like a number and ignores the rest, or silently takes its default.",
    advice: "Write the number plainly, like 1.5e6",
    repair: Repair::NotPossible("only you know which number was meant"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<radius>0.0325</radius>",
        bad: "<radius>0,0325</radius>",
    },
};

/// What is odd about a value, in words that follow its name.
pub(super) fn of_value(value: &Value) -> Option<String> {
    value.fault.is_some().then(|| format!("is '{}', which OpenSim reads as {}", value.text, value.number))
}

/// The same of three numbers, written as `text` and read as `read`.
pub(super) fn of_triple(text: &str, [x, y, z]: [f64; 3]) -> Option<String> {
    (!is_plain_triple(text)).then(|| {
        // A blank that is not ASCII looks like one and does not count as one: show it.
        let text = if text.is_ascii() { text.to_owned() } else { text.escape_default().to_string() };
        format!("is '{text}', which OpenSim reads as {x} {y} {z}")
    })
}
