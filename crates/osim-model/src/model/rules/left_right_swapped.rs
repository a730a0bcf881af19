//! Names of spheres say another side than their bodies.

use crate::messages::shown;

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::side::Side;
use crate::model::sides::{BothSides, Placed, SpherePair};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::LeftRightSwapped,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "Spheres on the right have names of the left, and the reverse.",
    why: "No name of 1,321 published spheres contradicts the side of its body. Where both sides of a table are swapped, each foot has the places of the other: the mirror image of a foot under a foot, and results are of the wrong side.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`, and give each sphere a body and a place of the side in its name",
    repair: Repair::NotPossible("only you know whether the names are wrong, or the bodies"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/left_right_swapped.osim" },
};

/// One finding for all pairs. A single sphere on the wrong side has no counterpart there, which is another finding.
pub(super) fn find(sides: &BothSides<'_>) -> Option<Finding> {
    let swapped: Vec<&SpherePair<'_>> = sides.pairs.iter().filter(|pair| is_swapped(pair)).collect();
    let first = swapped.first()?;
    let more = match swapped.len() {
        1 => String::new(),
        2 => "; another pair, too".to_owned(),
        count => format!("; {} other pairs, too", count - 1),
    };
    let [right, left] =
        [&first.right, &first.left].map(|placed| (shown(&placed.sphere.name), shown(placed.body)));
    let text = format!("{} is on {}, and {} on {}{more}", right.0, right.1, left.0, left.1);
    let sphere = first.right.sphere;
    let names =
        swapped.iter().flat_map(|pair| [&pair.right, &pair.left]).map(|placed| placed.sphere.name.clone());
    Some(Finding::at(&RULE, sphere.line, text).about(&sphere.path).of_spheres(names.collect()))
}

/// Whether the names of both spheres say the side of the other one.
fn is_swapped(pair: &SpherePair<'_>) -> bool {
    let says = |placed: &Placed<'_>, side| Side::of_name(&placed.sphere.name) == Some(side);
    pair.bodies.is_some() && says(&pair.right, Side::Left) && says(&pair.left, Side::Right)
}
