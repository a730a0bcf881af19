//! What the model weighs, or what its contacts are made for, is not known.

use osim_model::{Example, Fault, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::MassUnknown,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "What the model weighs, or what its contacts are made for, is not known.",
    why: "Every factor follows from these masses.",
    advice: "Say `mass=KG` or `contacts_mass=KG`, or correct the masses of the bodies",
    repair: Repair::NotPossible("only you know what the model weighs"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<mass>61.5</mass>",
        bad: "<mass>-1</mass>",
    },
};

/// Why a mass is not known.
pub(crate) fn of_fault(fault: &Fault) -> Finding {
    Finding::new(&RULE, fault.phrase())
}
