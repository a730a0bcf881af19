//! Radii differ within one ContactParameters.

use crate::model::contacts::Force;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::MixedRadii,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Radii differ within one ContactParameters.",
    why: "One ContactParameters has one modulus for all its spheres. The mean of R squared is used before and after: equal relative indentation, load in proportion to R squared.",
    advice: "Nothing, if that is meant; else give each sphere its own force",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/mixed_radii.osim" },
};

/// One set of parameters for spheres of different radii.
pub(super) fn of_force(model: &Model, force: &Force) -> Option<Finding> {
    let set = force.sets.iter().find(|set| {
        let spheres = set.spheres.iter().filter_map(|&id| model.sphere(id));
        let mut radii = spheres.filter(|sphere| !sphere.fixed).map(|sphere| sphere.radius.number);
        radii.next().is_some_and(|first| radii.any(|radius| radius != first))
    })?;
    let text = format!("{} has spheres of different radii: the mean of R squared is used", force.path);
    Some(Finding::at(&RULE, set.line, text).about(&force.path))
}
