//! One HuntCrossleyForce has several spheres.

use crate::model::contacts::ForceKind;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::SeveralSpheres,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "One HuntCrossleyForce has several spheres.",
    why: "In Simbody, when one sphere of a HuntCrossleyForce leaves the ground faster than 2/(3 dissipation), the spheres evaluated after it lose their force in that step.",
    advice: "Nothing, where feet leave the ground slowly: half of the published models have one force for each foot. Else give each sphere a HuntCrossleyForce of its own",
    repair: Repair::NotPossible("published models are made so on purpose"),
    example: Example::Models { good: "table1/human_62kg_hunt_crossley.osim", bad: "format/v40000.osim" },
};

pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let moving =
            force.spheres().into_iter().filter(|&s| model.sphere(s).is_some_and(|s| !s.fixed)).count();
        if matches!(force.kind, ForceKind::HuntCrossley) && moving > 1 {
            let text = format!("{} holds {moving} spheres: Simbody can drop the force of some", force.path);
            found.push(Finding::at(&RULE, force.line, text).about(&force.path));
        }
    }
    found
}
