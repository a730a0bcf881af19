//! One sphere is used by two contact forces.

use foldhash::{HashMap, HashMapExt};

use crate::model::contacts::{SphereId, moving_spheres};
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::SphereInTwoForces,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "One sphere is used by two contact forces.",
    why: "Both forces act, so the sphere is stiffer than either stiffness says, and the sphere count by which parameters scale is not what it seems.",
    advice: "Leave the sphere in one force",
    repair: Repair::NotPossible("only you know which force is meant"),
    example: Example::Piece {
        model: "format/unequal_radii.osim",
        good: "<socket_sphere>/contactgeometryset/toe_r</socket_sphere>",
        bad: "<socket_sphere>/contactgeometryset/heel_r</socket_sphere>",
    },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut users: HashMap<SphereId, Vec<&str>> = HashMap::new();
    for force in model.forces().iter().filter(|force| force.applies && model.meets_half_space(force)) {
        for sphere in moving_spheres(model, &[force.id]) {
            users.entry(sphere).or_default().push(&force.path);
        }
    }
    let mut shared: Vec<_> = users.into_iter().filter(|(_, forces)| forces.len() > 1).collect();
    shared.sort_unstable();
    for (index, forces) in shared {
        let Some(sphere) = model.sphere(index) else { continue };
        let text = format!("sphere {} meets the ground through {}", sphere.path, forces.join(" and "));
        found.push(Finding::at(&RULE, sphere.line, text).about(&sphere.path));
    }
    found
}
