//! The file has a derivative_smoothing element, which OpenSim ignores.

use crate::model::contacts::Force;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::DeadDerivativeSmoothing,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "The file has a derivative_smoothing element, which OpenSim ignores.",
    why: "derivative_smoothing was the name of constant_contact_force in early Moco. OpenSim ignores it and uses its default of 1e-5 m2 for constant_contact_force.",
    advice: "Remove the element; set constant_contact_force if another value is meant",
    repair: Repair::NotPossible("only you know which value was meant"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<derivative_smoothing>9e-07</derivative_smoothing>",
    },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    // Where the force keeps its sphere inside itself, its class is that of early Moco, and the element is alive.
    let inside = |force: &&Force| force.sets.iter().any(|set| set.half_space_inside.is_some());
    for force in model.forces().iter().filter(|force| !inside(force)) {
        let document = model.file(force.file);
        if let Some(dead) = document.tree().child(force.element, "derivative_smoothing") {
            let line = document.line(document.tree().span(dead).start);
            let text = format!("{}: derivative_smoothing is ignored by OpenSim", force.path);
            found.push(Finding::at(&RULE, line, text).about(&force.path));
        }
    }
    found
}
