//! Spheres of a body that are all in nearly one place.

use std::collections::{BTreeMap, BTreeSet};

use crate::messages::{shown, three_significant};

use crate::model::contacts::Sphere;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::side::Side;
use crate::model::sides::{BothSides, distance, place_key};

/// In the corpus the spheres of a body extend over 0.077 (the forefoot of D'Hondt et al.) to 0.9 of the limb's longest bone.
const OF_BONE: f64 = 0.02;
/// And the nearest two are 1.36 radii apart.
const OF_RADIUS: f64 = 0.5;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::CrowdedSpheres,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "The spheres of a body are all in nearly one place.",
    why: "The spheres of a published foot extend over at least 0.077 of the limb's longest bone, and no two are closer than 1.36 radii. Spheres that nearly coincide carry like one that is several times as stiff. Mostly places in metres were taken for millimetres.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`; write places in metres, in the frame of the body",
    repair: Repair::NotPossible("only you know the places that are meant"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/crowded_spheres.osim" },
};

/// One finding, about the body whose spheres are the most crowded.
pub(super) fn find(sides: &BothSides<'_>) -> Option<Finding> {
    let mut by_body: BTreeMap<&str, Vec<(&Sphere, [f64; 3])>> = BTreeMap::new();
    for (sphere, body, place_m) in sides.spheres().filter(|(_, body, _)| Side::of_name(body).is_some()) {
        by_body.entry(body).or_default().push((sphere, place_m));
    }
    let crowds = by_body.iter().filter_map(|(body, spheres)| crowd(spheres, sides.longest_of_limb_m(body)?));
    let mut all: Vec<Crowd<'_>> = crowds.collect();
    all.sort_by(|a, b| a.of_bone().total_cmp(&b.of_bone()));
    let worst = all.first()?;
    let sphere = worst.spheres.first()?;
    let finding = Finding::at(&RULE, sphere.line, text(worst, all.len())?).about(&sphere.path);
    let names = all.iter().flat_map(|crowd| &crowd.spheres).map(|sphere| sphere.name.clone());
    Some(finding.of_spheres(names.collect()))
}

/// Spheres of one body that are nearly in one place.
struct Crowd<'m> {
    spheres: Vec<&'m Sphere>,
    extent_m: f64,
    bone_m: f64,
}

impl Crowd<'_> {
    fn of_bone(&self) -> f64 {
        self.extent_m / self.bone_m
    }
}

/// Spheres at one place are doubled, which is another finding.
fn crowd<'m>(spheres: &[(&'m Sphere, [f64; 3])], bone_m: f64) -> Option<Crowd<'m>> {
    let places: BTreeSet<[i64; 3]> = spheres.iter().map(|(_, place_m)| place_key(*place_m)).collect();
    let least_m = spheres.iter().map(|(sphere, _)| sphere.radius.number).fold(f64::INFINITY, f64::min);
    let crowd = Crowd {
        spheres: spheres.iter().map(|(sphere, _)| *sphere).collect(),
        extent_m: extent_m(spheres),
        bone_m,
    };
    let is_crowd = crowd.of_bone() < OF_BONE && crowd.extent_m < OF_RADIUS * least_m;
    (places.len() > 1 && is_crowd).then_some(crowd)
}

/// The diagonal of the box around the centres, m.
fn extent_m(spheres: &[(&Sphere, [f64; 3])]) -> f64 {
    let corner = |start: f64, of: fn(f64, f64) -> f64| -> [f64; 3] {
        std::array::from_fn(|axis| spheres.iter().map(|(_, place_m)| place_m[axis]).fold(start, of))
    };
    distance(corner(f64::INFINITY, f64::min), corner(f64::NEG_INFINITY, f64::max))
}

fn text(worst: &Crowd<'_>, count: usize) -> Option<String> {
    let more = match count {
        1 => String::new(),
        2 => "; those of another body, too".to_owned(),
        count => format!("; those of {} other bodies, too", count - 1),
    };
    let first = worst.spheres.first()?;
    Some(format!(
        "the {} spheres of {} are within {} m, {} of the limb's longest bone ({} m), expected at least {OF_BONE}{more}",
        worst.spheres.len(),
        shown(first.body.as_deref().unwrap_or_default()),
        three_significant(worst.extent_m),
        three_significant(worst.of_bone()),
        three_significant(worst.bone_m),
    ))
}
