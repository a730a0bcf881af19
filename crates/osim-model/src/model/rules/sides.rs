//! Rules about the left and the right side: contacts that differ, and spheres without a counterpart.

use crate::messages::{shown, three_significant};
use crate::model::contacts::Force;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::names::Side;
use crate::model::sides::{Alone, BothSides, Difference, Placed, SAME_PLACE, SpherePair};

pub(super) static LEFT_RIGHT_DIFFER: Rule = Rule {
    code: FindingCode::LeftRightDiffer,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "Left and right contacts differ.",
    why: "Contacts of a symmetric model are nearly always meant to be symmetric; a difference usually is a slip of the hand. Contacts are compared with those at the mirrored place, whatever their names are; numbers that follow the sizes of the bones are right.",
    advice: "Compare the two sides with `inspect` and correct the one that is wrong",
    repair: Repair::Command(
        "writes the values of one side into the force of the other, where other forces, known contacts or the original model show which is right",
    ),
    example: Example::Piece {
        model: "table1/human_62kg_smooth_sphere.osim",
        good: "<stiffness>1000000</stiffness>",
        bad: "<stiffness>2000000</stiffness>",
    },
};

/// Forces whose spheres are mirror images should have equal parameters, or such as follow bones that were scaled unlike.
pub(super) fn find_left_right_differ(sides: &BothSides<'_>) -> Vec<Finding> {
    let found = sides.differences().into_iter();
    found
        .filter_map(|(left, right, all)| find_difference(&LEFT_RIGHT_DIFFER, left, right, &all, false))
        .collect()
}

/// What differs between two forces, as much as `are_small` says: the first difference of that kind.
fn find_difference(
    rule: &'static Rule,
    left: &Force,
    right: &Force,
    differences: &[Difference],
    are_small: bool,
) -> Option<Finding> {
    let first = differences.iter().find(|difference| difference.is_small == are_small)?;
    let text = format!("{} and {} differ: {}", left.path, right.path, first.text);
    Some(Finding::at(rule, left.line, text).about(&left.path))
}

pub(super) static LEFT_RIGHT_CLOSE: Rule = Rule {
    code: FindingCode::LeftRightClose,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "Left and right contacts differ as little as those of published models.",
    why: "Of 150 published models with contacts on both sides, the radii of five differ by 0.7 to 5.7 %, and the transition velocity of one by 5 %. Up to 10 % in radii and 20 % in transition velocities are taken to be meant.",
    advice: "Nothing, if that is meant; else write the number of one side into the other",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Piece {
        model: "table1/human_62kg_smooth_sphere.osim",
        good: "<radius>0.032000000000000001</radius>",
        bad: "<radius>0.0331</radius>",
    },
};

/// Of forces that differ in nothing else.
pub(super) fn find_left_right_close(sides: &BothSides<'_>) -> Vec<Finding> {
    let found = sides.differences().into_iter().filter(|(_, _, all)| all.iter().all(|one| one.is_small));
    found
        .filter_map(|(left, right, all)| find_difference(&LEFT_RIGHT_CLOSE, left, right, &all, true))
        .collect()
}

pub(super) static LEFT_RIGHT_PLACES: Rule = Rule {
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
pub(super) fn find_left_right_places(sides: &BothSides<'_>) -> Option<Finding> {
    let mut all: Vec<(f64, &SpherePair<'_>)> =
        sides.pairs.iter().filter_map(|pair| Some((distance_too_far(pair)?, pair))).collect();
    all.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let (_, worst) = all.first()?;
    let sphere = worst.left.sphere;
    let more = match all.len() {
        1 => String::new(),
        2 => "; another pair, too".to_owned(),
        count => format!("; {} other pairs, too", count - 1),
    };
    let finding = Finding::at(&LEFT_RIGHT_PLACES, sphere.line, format!("{}{more}", describe_places(worst)))
        .about(&sphere.path);
    Some(finding.of_spheres(all.iter().map(|(_, pair)| pair.left.sphere.name.clone()).collect()))
}

/// How far a pair is apart, as a part of the limb's longest bone, if that is too far.
fn distance_too_far(pair: &SpherePair<'_>) -> Option<f64> {
    let Some(bodies) = &pair.bodies else { return Some(f64::INFINITY) };
    let apart = bodies.apart_m(pair.right.place_m, pair.left.place_m)? / bodies.bone_m?;
    (apart > SAME_PLACE).then_some(apart)
}

fn describe_places(pair: &SpherePair<'_>) -> String {
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

pub(super) static LEFT_RIGHT_MISSING: Rule = Rule {
    code: FindingCode::LeftRightMissing,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "A sphere has no counterpart on the other side.",
    why: "The other side has the body but fewer spheres, so that each of them carries more of the weight. Of 150 published models with contacts on both sides four have unlike numbers, all with prostheses.",
    advice: "Add the sphere that is missing, or take the one that is too many out of the file",
    repair: Repair::NotPossible("only you know which side is right"),
    example: Example::Piece {
        model: "format/v40000.osim",
        good: "<geometry>floor heel_l toe_l</geometry>",
        bad: "<geometry>floor heel_l</geometry>",
    },
};

/// One finding for all of them.
pub(super) fn find_left_right_missing(sides: &BothSides<'_>) -> Option<Finding> {
    let mut all = sides.alone.iter().filter_map(|alone| Some((alone, alone.other_body?)));
    let (first, other_body) = all.next()?;
    let spheres: Vec<&Alone<'_>> = std::iter::once(first).chain(all.map(|(alone, _)| alone)).collect();
    let (sphere, body) = (first.sphere.sphere, first.sphere.body);
    let more = match spheres.len() {
        1 => String::new(),
        2 => "; another sphere neither".to_owned(),
        count => format!("; {} other spheres neither", count - 1),
    };
    let text = format!(
        "{} on {} has no counterpart on {}{more}",
        shown(&sphere.name),
        shown(body),
        shown(other_body)
    );
    let names = spheres.iter().map(|alone| alone.sphere.sphere.name.clone()).collect();
    Some(Finding::at(&LEFT_RIGHT_MISSING, sphere.line, text).about(&sphere.path).of_spheres(names))
}

pub(super) static LEFT_RIGHT_OFF: Rule = Rule {
    code: FindingCode::LeftRightOff,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "A contact is switched off on one side alone.",
    why: "The side that is switched off carries nothing there: the body sinks in, or falls to that side.",
    advice: "Switch it on in the file (appliesForce), or switch the other side off, too",
    repair: Repair::NotPossible("only numbers are changed, and only you know which side is meant"),
    example: Example::Piece {
        model: "table1/human_62kg_smooth_sphere.osim",
        good: r#"<SmoothSphereHalfSpaceForce name="contact_s1_r">"#,
        bad: r#"<SmoothSphereHalfSpaceForce name="contact_s1_r"><appliesForce>false</appliesForce>"#,
    },
};

/// One finding for all of them.
pub(super) fn find_left_right_off(sides: &BothSides<'_>) -> Option<Finding> {
    let pairs = sides.pairs.iter();
    let off: Vec<[&Placed<'_>; 2]> = pairs
        .filter_map(|pair| match (sides.applies(pair.right.sphere), sides.applies(pair.left.sphere)) {
            (true, false) => Some([&pair.left, &pair.right]),
            (false, true) => Some([&pair.right, &pair.left]),
            _ => None,
        })
        .collect();
    let [first, counterpart] = *off.first()?;
    let side = if first.side == Side::Left { "left" } else { "right" };
    let more = match off.len() {
        1 => String::new(),
        2 => format!("; so is 1 other of {} pairs", sides.pairs.len()),
        count => format!("; so are {} others of {} pairs", count - 1, sides.pairs.len()),
    };
    let text = format!(
        "the contact of {} on the {side} is switched off, that of {}, its counterpart, is not{more}",
        shown(&first.sphere.name),
        shown(&counterpart.sphere.name)
    );
    let finding = Finding::at(&LEFT_RIGHT_OFF, first.sphere.line, text).about(&first.sphere.path);
    Some(finding.of_spheres(off.iter().map(|[off, _]| off.sphere.name.clone()).collect()))
}

pub(super) static LEFT_RIGHT_SWAPPED: Rule = Rule {
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
pub(super) fn find_left_right_swapped(sides: &BothSides<'_>) -> Option<Finding> {
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
    Some(Finding::at(&LEFT_RIGHT_SWAPPED, sphere.line, text).about(&sphere.path).of_spheres(names.collect()))
}

/// Whether the names of both spheres say the side of the other one.
fn is_swapped(pair: &SpherePair<'_>) -> bool {
    let says = |placed: &Placed<'_>, side| Side::of_name(&placed.sphere.name) == Some(side);
    pair.bodies.is_some() && says(&pair.right, Side::Left) && says(&pair.left, Side::Right)
}

pub(super) static ONE_SIDE_ONLY: Rule = Rule {
    code: FindingCode::OneSideOnly,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "Spheres are on one side alone: the other one has none, or no body for them.",
    why: "A model that kicks, hops on one leg or has a prosthesis may need no more; one that walks falls to the other side.",
    advice: "Nothing, if that is meant; else give the other side contacts, too",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Piece {
        model: "format/v40000.osim",
        good: "<geometry>floor heel_l toe_l</geometry>",
        bad: "<geometry>floor</geometry>",
    },
};

/// One finding for all of them.
pub(super) fn find_one_side_only(sides: &BothSides<'_>) -> Option<Finding> {
    if let Some(first) = sides.one_side.first() {
        let text = format!("only the {} side has contact spheres that meet a floor", first.side.as_str());
        return Some(one_side_finding(text, &sides.one_side.iter().collect::<Vec<_>>(), first));
    }
    let without_body = sides.alone.iter().filter(|alone| alone.other_body.is_none());
    let all: Vec<&Placed<'_>> = without_body.map(|alone| &alone.sphere).collect();
    let first = all.first()?;
    let text = format!(
        "{} on {} has no counterpart: the other side has no such body",
        shown(&first.sphere.name),
        shown(first.body)
    );
    Some(one_side_finding(text, &all, first))
}

fn one_side_finding(text: String, all: &[&Placed<'_>], first: &Placed<'_>) -> Finding {
    let finding = Finding::at(&ONE_SIDE_ONLY, first.sphere.line, text).about(&first.sphere.path);
    finding.of_spheres(all.iter().map(|placed| placed.sphere.name.clone()).collect())
}
