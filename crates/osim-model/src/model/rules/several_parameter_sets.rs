//! A force has several ContactParameters.

use crate::model::contacts::Force;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::SeveralParameterSets,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "A force has several ContactParameters.",
    why: "The surfaces have moduli of their own and the contact uses their composite (A.3); all are multiplied by the same factor.",
    advice: "Nothing, if that is meant",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/three_materials.osim" },
};

pub(super) fn of_force(force: &Force) -> Option<Finding> {
    let used = force.sets.iter().filter(|set| !set.spheres.is_empty() || set.half_spaces > 0).count();
    let text = format!("{} has {} ContactParameters: all get the same factor", force.path, force.sets.len());
    (used > 1).then(|| Finding::at(&RULE, force.line, text).about(&force.path))
}
