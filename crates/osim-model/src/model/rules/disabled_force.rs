//! A contact force that is switched off is changed with the others.

use crate::model::contacts::Force;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::DisabledForce,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "A contact force that is switched off is changed with the others.",
    why: "A force that does not apply carries no load, so its spheres are not counted; it is still scaled, so that it is right once it is switched on.",
    advice: "Nothing, if that is meant; else `skip_disabled`",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: r#"<SmoothSphereHalfSpaceForce name="contact_heel_r">"#,
        bad: r#"<SmoothSphereHalfSpaceForce name="contact_heel_r"><appliesForce>false</appliesForce>"#,
    },
};

pub(super) fn of_force(force: &Force) -> Option<Finding> {
    let text = format!(
        "{} is switched off: it is changed with the others, and its spheres are not counted",
        force.path
    );
    (!force.applies).then(|| Finding::at(&RULE, force.line, text).about(&force.path))
}
