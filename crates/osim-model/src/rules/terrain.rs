//! A sphere stands on ground or on a body welded to it.

use std::collections::HashSet;

use crate::contacts::SphereId;
use crate::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::Terrain,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "A sphere stands on ground or on a body welded to it.",
    why: "Terrain does not grow with the animal: its radius stays.",
    advice: "Nothing, if that is meant",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/terrain_on_ground.osim" },
};

/// Which of `spheres` are on ground or on bodies welded to it.
pub(super) fn of_spheres(model: &Model, spheres: &HashSet<SphereId>) -> Option<Finding> {
    let fixed: Vec<_> =
        model.spheres().iter().filter(|sphere| sphere.fixed && spheres.contains(&sphere.id)).collect();
    let first = fixed.first()?;
    let text = match fixed.len() {
        1 => format!("{} stands on ground: its radius stays", first.path),
        2 => format!("{} and one more sphere stand on ground: their radii stay", first.path),
        count => format!("{} and {} more spheres stand on ground: their radii stay", first.path, count - 1),
    };
    let finding = Finding::at(&RULE, first.line, text).about(&first.path);
    Some(finding.of_spheres(fixed.iter().map(|sphere| sphere.name.clone()).collect()))
}
