//! A sphere of a contact force stands on ground or on a body welded to it.

use crate::messages::readable;

use crate::model::contacts::{Force, Sphere};
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};
use crate::model::skeleton::Body;
use crate::model::typed_model::Model;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::Terrain,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "A sphere stands on ground or a body welded to it, or such a body has mass.",
    why: "Such a sphere or body is scenery: it does not grow with the animal and carries nobody. It counts in no limb, no mass and no figure, and no verb changes it. A body on which others hang is none: a model whose pelvis is held weighs all that it weighs.",
    advice: "Nothing, if that is meant",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/terrain_on_ground.osim" },
};

/// One finding for all spheres that are scenery, and one for all bodies.
pub(super) fn find(model: &Model) -> Vec<Finding> {
    spheres(model).into_iter().chain(bodies(model)).collect()
}

fn bodies(model: &Model) -> Option<Finding> {
    let heavy: Vec<(&Body, f64)> = model
        .bodies()
        .iter()
        .filter(|body| body.scenery)
        .filter_map(|body| Some((body, body.mass_kg().ok().filter(|kg| *kg > 0.0)?)))
        .collect();
    let (first, kg) = heavy.first()?;
    let kg = readable(*kg);
    let text = match heavy.len() {
        1 => format!(
            "{} ({kg} kg) is welded to ground: it is scenery, which does not count in what the model weighs",
            first.path
        ),
        count => format!(
            "{} ({kg} kg) and {} more {} are welded to ground: they are scenery, which does not count in what the model weighs",
            first.path,
            count - 1,
            if count == 2 { "body" } else { "bodies" }
        ),
    };
    Some(Finding::new(&RULE, text).about(&first.path))
}

fn spheres(model: &Model) -> Option<Finding> {
    let mut used: Vec<_> = model.forces().iter().flat_map(Force::spheres).collect();
    used.sort_unstable();
    used.dedup();
    let fixed: Vec<&Sphere> =
        used.into_iter().filter_map(|id| model.sphere(id)).filter(|sphere| sphere.fixed).collect();
    let first = fixed.first()?;
    let text = match fixed.len() {
        1 => {
            format!("{} stands on ground: it is scenery, which counts nowhere and stays as it is", first.path)
        }
        2 => format!("{} and one more sphere stand on ground: {SCENERY}", first.path),
        count => format!("{} and {} more spheres stand on ground: {SCENERY}", first.path, count - 1),
    };
    let finding = Finding::at(&RULE, first.line, text).about(&first.path);
    Some(finding.of_spheres(fixed.iter().map(|sphere| sphere.name.clone()).collect()))
}

const SCENERY: &str = "they are scenery, which counts nowhere and stays as it is";
