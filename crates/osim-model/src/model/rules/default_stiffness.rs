//! A stiffness is left at its class default.

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::property::Property;
use crate::model::typed_model::Model;
use crate::model::value::{Origin, Value};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::DefaultStiffness,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "A stiffness is left at its class default.",
    why: "OpenSim's default stiffness (1 N/m2 in SmoothSphereHalfSpaceForce) carries nothing; it is nearly always a forgotten value.",
    advice: "Set a stiffness, for example that of a published model",
    repair: Repair::Command("takes the contacts of a published model"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<stiffness>4.4876e7</stiffness>",
        bad: "<!-- no stiffness -->",
    },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        for set in &force.sets {
            if let Some(value) = set.value(Property::Stiffness).filter(|value| applies(value)) {
                let text = format!("{}: stiffness is OpenSim's default, {} N/m2", force.path, value.number);
                found.push(Finding::at(&RULE, set.line, text).about(&force.path));
            }
        }
    }
    found
}

/// Whether a value is a stiffness that nobody wrote.
pub(super) fn applies(value: &Value) -> bool {
    value.property == Property::Stiffness && value.origin == Origin::ClassDefault
}
