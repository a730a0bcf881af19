//! Two spheres at one place.

use crate::messages::shown;
use foldhash::{HashMap, HashMapExt};

use crate::model::contacts::Sphere;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::sides::{BothSides, place_key};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::DoubledSpheres,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "Two spheres are at the same place of the same body.",
    why: "Both carry: the contact is twice as stiff as it looks, and figures share the weight among too many spheres. None of 200 published models has such spheres; a copy with another name makes them.",
    advice: "Take one of the two and its force out of the file",
    repair: Repair::NotPossible("only you know which of the two is meant"),
    example: Example::Piece {
        model: "format/v40000.osim",
        good: "<location>0.01 -0.02 0</location>",
        bad: "<location>0.18 -0.02 0</location>",
    },
};

/// One finding for all spheres that share their place with an earlier one.
pub(super) fn find(sides: &BothSides<'_>) -> Option<Finding> {
    let mut first_at: HashMap<(&str, [i64; 3]), &Sphere> = HashMap::new();
    let mut doubled: Vec<[&Sphere; 2]> = Vec::new();
    for (sphere, body, place_m) in sides.spheres().filter(|(sphere, _, _)| sides.applies(sphere)) {
        let first = *first_at.entry((body, place_key(place_m))).or_insert(sphere);
        if first.id != sphere.id {
            doubled.push([first, sphere]);
        }
    }
    let [first, second] = *doubled.first()?;
    let more = match doubled.len() {
        1 => String::new(),
        2 => "; another pair, too".to_owned(),
        count => format!("; {} other pairs, too", count - 1),
    };
    let body = second.body.as_deref().unwrap_or_default();
    let text = format!(
        "{} and {} are at the same place of {}{more}",
        shown(&first.name),
        shown(&second.name),
        shown(body)
    );
    let finding = Finding::at(&RULE, second.line, text).about(&second.path);
    Some(finding.of_spheres(doubled.iter().map(|[_, second]| second.name.clone()).collect()))
}
