//! A SmoothSphereHalfSpaceForce has a constant_contact_force of 0.

use crate::model::contacts::SetId;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::property::Property;
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::ZeroConstantContactForce,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "A SmoothSphereHalfSpaceForce has a constant_contact_force of 0.",
    why: "Simbody divides by the root of the squared slip speed plus constant_contact_force: with 0, the force is NaN whenever the sphere does not slip, even without friction. Scaling leaves a value of 0 as it is.",
    advice: "Give it a small value, for example for a constant indentation of {suggested_indentation} of the radius",
    repair: Repair::Command("designs constant_contact_force for a small constant indentation"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<constant_contact_force>0</constant_contact_force>",
    },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let zero =
            force.value(SetId::FIRST, Property::ConstantContactForce).filter(|value| value.number == 0.0);
        if let Some(value) = zero {
            let line = model.file(force.file).line(value.offset);
            let text =
                format!("{}: constant_contact_force is 0: OpenSim computes NaN without slip", force.path);
            found.push(Finding::at(&RULE, line, text).about(&force.path));
        }
    }
    found
}
