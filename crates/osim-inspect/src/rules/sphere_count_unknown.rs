//! How many spheres share the weight is not known.

use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use crate::inspection::Inspection;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::CountUnknown,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "How many spheres share the weight is not known.",
    why: "Limbs are found by left and right sides below the joint tree. Where that does not work, figures under body weight are absent, and indentations are not judged.",
    advice: "Say it with `spheres=N`; where spheres of several bodies are there that only ground joins, choose those of one with `select=GLOB`",
    repair: Repair::NotPossible("only you know how many spheres share the weight"),
    example: Example::Models { good: "check/within_limits.osim", bad: "format/no_sides.osim" },
};

/// Limbs are not known either where forces of several animals are there and nobody chose among them.
pub(crate) fn find(inspected: &Inspection) -> Option<Finding> {
    let limbs = &inspected.figures.limbs;
    let counted = !limbs.is_empty() && limbs.iter().all(|limb| limb.sphere_count.is_some());
    match (&inspected.limbs, counted, &inspected.limbs_unknown) {
        (None, false, Some(why)) => Some(Finding::new(&RULE, why.clone())),
        _ => None,
    }
}
