//! A sphere of a contact force stands on ground or on a body welded to it.

use crate::contacts::{Force, Sphere};
use crate::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::Terrain,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "A sphere of a contact force stands on ground or on a body welded to it.",
    why: "Such a sphere is scenery: it does not grow with the animal and carries nobody. It counts in no limb and no figure, and no verb changes it.",
    advice: "Nothing, if that is meant",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/terrain_on_ground.osim" },
};

/// One finding for all scenery of the model.
pub(super) fn find(model: &Model) -> Vec<Finding> {
    let mut used: Vec<_> = model.forces().iter().flat_map(Force::spheres).collect();
    used.sort_unstable();
    used.dedup();
    let fixed: Vec<&Sphere> =
        used.into_iter().filter_map(|id| model.sphere(id)).filter(|sphere| sphere.fixed).collect();
    let Some(first) = fixed.first() else { return Vec::new() };
    let text = match fixed.len() {
        1 => {
            format!("{} stands on ground: it is scenery, which counts nowhere and stays as it is", first.path)
        }
        2 => format!("{} and one more sphere stand on ground: {SCENERY}", first.path),
        count => format!("{} and {} more spheres stand on ground: {SCENERY}", first.path, count - 1),
    };
    let finding = Finding::at(&RULE, first.line, text).about(&first.path);
    vec![finding.of_spheres(fixed.iter().map(|sphere| sphere.name.clone()).collect())]
}

const SCENERY: &str = "they are scenery, which counts nowhere and stays as it is";
