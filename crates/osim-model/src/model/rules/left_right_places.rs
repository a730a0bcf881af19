//! A sphere is not at the mirrored place of its counterpart.

use crate::messages::{shown, three_significant};

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::sides::{BothSides, SAME_PLACE, SpherePair};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::LeftRightPlaces,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "A sphere is not at the mirrored place of its counterpart on the other side.",
    why: "In published models each sphere is at most 2.3 % of the limb's longest bone from the mirror image of its counterpart, in the frames of the two bodies and by the sizes of their bones. More is a sign that was forgotten, another unit, or another body.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`, and correct the place, or the body, of the sphere that is wrong",
    repair: Repair::NotPossible("only you know which side is right"),
    example: Example::Piece {
        model: "table1/human_62kg_smooth_sphere.osim",
        good: "<location>0.05024 -0.037199999999999997 -0.048000000000000001</location>",
        bad: "<location>0.05024 -0.037199999999999997 0.008</location>",
    },
};

/// One finding, about the pair that is farthest apart. Spheres on bodies that are not counterparts are the farthest.
pub(super) fn find(sides: &BothSides<'_>) -> Option<Finding> {
    let mut all: Vec<(f64, &SpherePair<'_>)> =
        sides.pairs.iter().filter_map(|pair| Some((beyond(pair)?, pair))).collect();
    all.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let (_, worst) = all.first()?;
    let sphere = worst.left.sphere;
    let more = match all.len() {
        1 => String::new(),
        2 => "; another pair, too".to_owned(),
        count => format!("; {} other pairs, too", count - 1),
    };
    let finding = Finding::at(&RULE, sphere.line, format!("{}{more}", text(worst))).about(&sphere.path);
    Some(finding.of_spheres(all.iter().map(|(_, pair)| pair.left.sphere.name.clone()).collect()))
}

/// How far a pair is apart, as a part of the limb's longest bone, if that is too far.
fn beyond(pair: &SpherePair<'_>) -> Option<f64> {
    let Some(bodies) = &pair.bodies else { return Some(f64::INFINITY) };
    let apart = bodies.apart_m(pair.right.place_m, pair.left.place_m)? / bodies.bone_m?;
    (apart > SAME_PLACE).then_some(apart)
}

fn text(pair: &SpherePair<'_>) -> String {
    let (left, right) = (&pair.left, &pair.right);
    let names = [left, right].map(|placed| (shown(&placed.sphere.name), shown(placed.body)));
    let [(left_name, left_body), (right_name, right_body)] = names;
    let apart = pair
        .bodies
        .as_ref()
        .and_then(|bodies| Some((bodies, bodies.apart_m(right.place_m, left.place_m)?, bodies.bone_m?)));
    let Some((bodies, apart_m, bone_m)) = apart else {
        return format!("{left_name} is on {left_body}, its counterpart {right_name} on {right_body}");
    };
    let sign = bodies.other_sign(right.place_m, left.place_m, SAME_PLACE / 3.0 * bone_m);
    let sign = sign.map(|axis| format!(": the sign of {axis} is wrong on one of them")).unwrap_or_default();
    let [apart_mm, bone_mm] = [apart_m, bone_m].map(|m| three_significant(m * 1e3));
    let part = three_significant(100.0 * apart_m / bone_m);
    format!(
        "{left_name} on {left_body} is {apart_mm} mm from the mirror image of {right_name} on {right_body}, \
         {part} % of the limb's longest bone ({bone_mm} mm), expected at most {} %{sign}",
        100.0 * SAME_PLACE
    )
}
