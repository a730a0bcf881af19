//! A number in the file is not finite.

use crate::model::finding::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::value::Value;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::NotFinite,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "A number in the file is not finite.",
    why: "JSON has no NaN and no infinity: such a number is null there. OpenSim computes nonsense from it.",
    advice: "Correct the number in the model",
    repair: Repair::NotPossible("only you know which number was meant"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<radius>0.0325</radius>",
        bad: "<radius>nan</radius>",
    },
};

/// Why a value is not finite, in words that follow its name.
pub(super) fn of_value(value: &Value) -> Option<String> {
    (!value.number.is_finite()).then(|| format!("is {}", value.number))
}

/// The same of three numbers.
pub(super) fn of_triple(read @ [x, y, z]: [f64; 3]) -> Option<String> {
    (!read.iter().all(|value| value.is_finite())).then(|| format!("is {x} {y} {z}"))
}
