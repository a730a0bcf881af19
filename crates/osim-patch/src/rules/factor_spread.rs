//! Spheres of one ContactParameters follow bodies with different factors.

use osim_model::{Example, Finding, FindingCode, Force, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::FactorSpread,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "Spheres of one ContactParameters follow bodies with different factors.",
    why: "One ContactParameters has one modulus for all its spheres; the mean of R squared is used before and after, so single spheres sink in more or less than they did.",
    advice: "Give each sphere its own force, or accept it; `strict` refuses instead",
    repair: Repair::NotPossible("forces cannot be divided yet: only numbers are changed"),
    example: Example::Request {
        good: r#"{"verb": "transfer", "models": ["scale_tool/scaled_hunt_crossley.osim"], "from": "scale_tool/generic_hunt_crossley.osim", "follow_bodies": true}"#,
        bad: r#"{"verb": "transfer", "models": ["scale_tool/scaled_hunt_crossley.osim"], "from": "scale_tool/generic_hunt_crossley.osim", "follow_bodies": true, "body_scale": {"toes_r": 1.1}}"#,
    },
};

/// Factors that differ by no more than this, relatively, are the same.
const SAME: f64 = 0.01;

/// The message if the largest factor of its spheres is `spread` times the smallest. A strict change is refused with it.
pub(crate) fn message(force: &Force, spread: f64) -> Option<String> {
    (spread > 1.0 + SAME).then(|| {
        format!(
            "{}: its spheres grow by factors that differ by {:.1} %; the mean of R squared is used",
            force.path,
            (spread - 1.0) * 100.0
        )
    })
}

pub(crate) fn of_force(force: &Force, message: String) -> Finding {
    Finding::at(&RULE, force.line, message)
}
