//! A radius that is not believable for the limb.

use crate::messages::{readable, shown, three_significant};

use crate::model::contacts::Sphere;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::mass::MassRequest;
use crate::model::sides::BothSides;
use crate::model::typed_model::Model;

/// Published radii are 0.011 to 0.2 of the longest bone of their limb.
const OF_BONE: std::ops::RangeInclusive<f64> = 0.005..=0.3;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::OddRadius,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "The radius of a sphere does not fit the length of its limb.",
    why: "Radii of published feet are 0.011 to 0.2 of the limb's longest bone, and in 95 % of them R / M^(1/3) is between 0.0002 and 0.029 m/kg^(1/3). Much more or less is another unit, mostly millimetres, or another animal's sphere.",
    advice: "Write radii in metres; contacts of a model of another size need radii that follow it",
    repair: Repair::NotPossible("only you know the size that is meant"),
    example: Example::Piece {
        model: "table1/human_62kg_smooth_sphere.osim",
        good: "<radius>0.032000000000000001</radius>",
        bad: "<radius>32</radius>",
    },
};

/// One finding, about the sphere that is farthest outside.
pub(super) fn find(model: &Model, sides: &BothSides<'_>) -> Option<Finding> {
    let odd = |(sphere, body, _): (_, &str, _)| odd(sphere, sides.longest_of_limb_m(body)?);
    let mut all: Vec<Odd<'_>> = sides.spheres().filter_map(odd).collect();
    all.sort_by(|a, b| b.beyond().total_cmp(&a.beyond()));
    let worst = all.first()?;
    let sphere = worst.sphere;
    let finding = Finding::at(&RULE, sphere.line, text(worst, all.len(), model)).about(&sphere.path);
    Some(finding.of_spheres(all.iter().map(|odd| odd.sphere.name.clone()).collect()))
}

struct Odd<'m> {
    sphere: &'m Sphere,
    bone_m: f64,
    of_bone: f64,
}

impl Odd<'_> {
    /// By how many times it is outside.
    fn beyond(&self) -> f64 {
        (self.of_bone / OF_BONE.end()).max(OF_BONE.start() / self.of_bone)
    }
}

fn odd(sphere: &Sphere, bone_m: f64) -> Option<Odd<'_>> {
    let of_bone = sphere.radius_m().ok()? / bone_m;
    (!OF_BONE.contains(&of_bone)).then_some(Odd { sphere, bone_m, of_bone })
}

fn text(worst: &Odd<'_>, count: usize, model: &Model) -> String {
    let radius_m = worst.sphere.radius.number;
    let more = match count {
        1 => String::new(),
        2 => "; another radius, too".to_owned(),
        count => format!("; {} other radii, too", count - 1),
    };
    let of_mass = MassRequest::default().bodies_kg(model).filter(|kg| *kg > 0.0);
    let of_mass = of_mass
        .map(|kg| format!(" (R / M^(1/3) is {} m/kg^(1/3))", three_significant(radius_m / libm::cbrt(kg))));
    format!(
        "radius of {} is {} m, {} of the limb's longest bone ({} m), expected {} to {}{}{more}",
        shown(&worst.sphere.name),
        readable(radius_m),
        three_significant(worst.of_bone),
        three_significant(worst.bone_m),
        OF_BONE.start(),
        OF_BONE.end(),
        of_mass.unwrap_or_default()
    )
}
