//! Whether spheres followed a scaling of their bodies cannot be seen in this file.

use crate::messages::{Input, Phrase, Verb, phrase};
use crate::model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::SpheresNotCompared,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Whether spheres followed a scaling of their bodies cannot be seen in this file.",
    why: "The bones were scaled; OpenSim leaves contact spheres where they were, and this file alone does not show whether somebody moved them afterwards.",
    advice: "Compare with the model that was scaled: `check MODEL from=GENERIC`",
    repair: Repair::NotPossible("only you know which model was scaled"),
    example: Example::Models { good: "check/within_limits.osim", bad: "check/spheres_not_compared.osim" },
};

/// Bones were scaled, and this file alone shows nothing else.
pub(crate) fn of_scaled_bones() -> Finding {
    let generic = Verb::Check.of_model().with(Input::From, "GENERIC");
    let text = phrase![
        "the bones were scaled; whether the spheres followed cannot be seen here: ",
        generic,
        " compares with the model that was scaled"
    ];
    Finding::new(&RULE, text)
}

/// The two models cannot be compared.
pub(crate) fn of_models(why: &Phrase) -> Finding {
    Finding::new(
        &RULE,
        phrase!["the spheres cannot be compared with those of the model that was scaled: ", why],
    )
}

/// A sphere has none that it could be compared with: `why`.
pub(crate) fn of_sphere(why: Phrase) -> Finding {
    Finding::new(&RULE, why)
}
