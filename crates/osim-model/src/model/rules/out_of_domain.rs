//! A number lies outside the domain of the contact laws.

use super::default_stiffness;
use crate::model::finding::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::value::Value;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::OutOfDomain,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "A number lies outside the domain of the contact laws.",
    why: "OpenSim accepts it and computes NaN or nonsense; such a model is not changed.",
    advice: "Correct the number in the model",
    repair: Repair::NotPossible("only you know which number was meant"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<radius>0.0325</radius>",
        bad: "<radius>-0.0325</radius>",
    },
};

/// Why OpenSim computes nonsense from a value, in words that follow its name. A default stiffness has a rule of its own.
pub(super) fn of_value(value: &Value) -> Option<String> {
    (!value.property.allows(value.number) && !default_stiffness::applies(value))
        .then(|| format!("is {}, expected {}", value.number, value.property.domain()))
}
