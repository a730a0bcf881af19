//! Spheres do not fit their bones, as in no published model, as in one of another size, or as on the other foot.

use crate::messages::{Input, phrase};
use crate::model::{Example, Finding, FindingCode, Model, Repair, Rule, Seen, Severity, Sphere, VerdictOn};

use super::spheres_left_behind::size;
use crate::compare::placement::Reach;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::SpheresMisplaced,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Spheres do not fit their bones, as in no published model, as in one of another size, or as on the other foot.",
    why: "OpenSim scaled the bones and left the spheres behind, the spheres were taken from a model of another size, or left and right were swapped. Then they push where the foot is not.",
    advice: "See where each belongs with `check MODEL from=ORIGINAL`, where ORIGINAL is the model that was scaled: it gives the command that puts them there, if there is one",
    repair: Repair::NotPossible(
        "it needs the model that was scaled, or the ScaleSet, and only you know where they are",
    ),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/spheres_misplaced.osim" },
};

/// A sphere is neither where it was nor where it belongs.
pub(crate) fn of_sphere(name: &str, here_mm: &str, belongs_mm: &str) -> Finding {
    let again = Input::MovedSpheres.like("replace");
    let text = phrase![
        format!(
            "{name} was moved: it is at {here_mm} mm, and at {belongs_mm} mm by the factors of its body: "
        ),
        again,
        " places it again"
    ];
    Finding::new(&RULE, text)
}

/// Spheres are where the published layout `title` has them, on a `body` that has the size `here` and not `published`.
pub(crate) fn of_layout(title: &str, body: &str, here: [f64; 3], published: [f64; 3]) -> Finding {
    let text = format!(
        "the spheres stand where {title} has them on bones of size {}, and {body} has the size {}",
        size(published),
        size(here)
    );
    Finding::new(&RULE, text)
}

/// Each foot has the places that the published layout `title` has on the other one.
pub(crate) fn of_mirrored(title: &str) -> Finding {
    let text = format!(
        "each foot has the spheres where {title} has them on the other foot: left and right are swapped, or z has the wrong sign"
    );
    Finding::new(&RULE, text)
}

/// Spheres reach further than those of published models; `None` without any.
pub(crate) fn of_reach(model: &Model, odd: &[Reach]) -> Option<Finding> {
    let named: Vec<(&Reach, &Sphere)> =
        odd.iter().filter_map(|reach| Some((reach, model.sphere(reach.sphere)?))).collect();
    let (reach, sphere) = named.first()?;
    let more = match named.len() {
        1 => String::new(),
        count => format!(" ({} more)", count - 1),
    };
    let text = format!("{} {}{more}", sphere.name, reach.describe());
    let names = named.iter().map(|(_, sphere)| sphere.name.clone()).collect();
    let finding = Finding::new(&RULE, text).about(&sphere.path);
    Some(finding.on_line(Some(sphere.line)).of_spheres(names))
}
