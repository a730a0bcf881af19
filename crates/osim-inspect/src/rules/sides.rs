//! Rules about the left and the right side: contacts that differ between the sides, and spheres without a counterpart. If it is known which
//! side is wrong, the remedy gives it the values of the other side.

use osim_model::messages::{counted, listed, shown, three_significant};
use osim_model::{
    Assignment, Example, Finding, Force, Model, Property, Repair, Rule, Severity, Side, Sphere, without_side,
};
use osim_requests::options::ForceOptions;
use osim_requests::{Request, SetRequest};

use crate::findings::{FindingWithRemedy, Remedies, exact_pattern};
use crate::inspection::Inspection;
use crate::known_contacts::KnownContacts;
use crate::rules::spheres::{finding_about_spheres, other_cases_in_words};
use crate::sides::{BothSides, SAME_PLACE_OF_BONE, SideDifference, SideSphere, SpherePair};
use osim_model::rule;

rule! { pub(super) LEFT_RIGHT_DIFFER: LeftRightDiffer, Warning, Sides;
    what: "Left and right contacts differ.",
    why: "Contacts of a symmetric model should nearly always be symmetric; a difference is usually a mistake. Contacts are compared with those at the mirrored place, whatever their names are; numbers that follow the sizes of the bones are right.",
    advice: "Compare the two sides with `inspect` and correct the one that is wrong",
    repair: Repair::Command("writes the values of one side into the force of the other, where other forces, known contacts or the original model show which is right"),
    example: Example::Piece { model: "table1/human_62kg_smooth_sphere.osim",
        good: "<stiffness>1000000</stiffness>", bad: "<stiffness>2000000</stiffness>" },
}

/// Finds pairs of forces on mirrored spheres whose parameters are not equal and do not follow the sizes of the bones. Pairs with
/// differences as small as in published models come last.
pub(super) fn find_side_differences(sides: &BothSides<'_>) -> Vec<Finding> {
    let pairs = sides.differences();
    let large = pairs.iter().filter_map(|(left, right, all)| {
        finding_of_side_difference(&LEFT_RIGHT_DIFFER, left, right, all, false)
    });
    let are_small = |(_, _, all): &&(_, _, Vec<SideDifference>)| all.iter().all(|one| one.is_small);
    let small = pairs.iter().filter(are_small);
    let small = small.filter_map(|(left, right, all)| {
        finding_of_side_difference(&LEFT_RIGHT_CLOSE, left, right, all, true)
    });
    large.chain(small).collect()
}

/// The finding about the first difference between two forces that is as small as in published models (`is_small`), or larger.
fn finding_of_side_difference(
    rule: &'static Rule,
    left: &Force,
    right: &Force,
    differences: &[SideDifference],
    is_small: bool,
) -> Option<Finding> {
    let of_size = || differences.iter().filter(move |difference| difference.is_small == is_small);
    let first = of_size().next()?;
    let text = |what: &str| format!("{} and {} differ: {what}", left.path, right.path);
    let times = of_size().map(|difference| difference.times).fold(1.0, f64::max);
    let finding = Finding::at(rule, left.position, text(&first.text)).with_place(&left.path);
    let all: Vec<&str> = differences.iter().map(|difference| difference.text.as_str()).collect();
    let details = if all.len() > 1 { vec![text(&all.join("; "))] } else { Vec::new() };
    Some(finding.with_details(details).with_measure(times, ""))
}

/// The side with right contacts, if only one side has them: contacts of the reference that the caller names, or published ones from the
/// table of known contacts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct KnownSide {
    pub side: Side,
    /// The title of the reference or publication whose contacts this side has.
    pub title: String,
}

impl KnownSide {
    /// The only side that has contacts of the reference, or else published ones; `None` if neither side or both have them.
    pub(crate) fn of(model: &Model, sides: &BothSides<'_>, inspected: &Inspection) -> Option<Self> {
        let reference = inspected.reference_contacts.as_ref();
        if let Some((side, reference)) =
            reference.and_then(|one| Some((one.side_like_reference(model, sides)?, one)))
        {
            return Some(Self { side, title: reference.title() });
        }
        let count = inspected.spheres_per_limb.map(|count| count as f64);
        let known_on = |side| KnownContacts::find(model, &sides.forces_on(side), count, inspected.mass_kg);
        match (known_on(Side::Right), known_on(Side::Left)) {
            (Some(contacts), None) => Some(Self { side: Side::Right, title: contacts.title.to_string() }),
            (None, Some(contacts)) => Some(Self { side: Side::Left, title: contacts.title.to_string() }),
            _ => None,
        }
    }
}

/// Adds to `finding`, about a difference of the sides, which side is wrong, and the remedy, if they are known.
pub(crate) fn with_odd_side(
    model: &Model,
    sides: &BothSides<'_>,
    known: Option<&KnownSide>,
    finding: &Finding,
    remedies: &Remedies<'_>,
) -> FindingWithRemedy {
    let of_each = finding.paths().map(|path| copy_other_side(remedies, model, sides, known, path));
    let of_each: Option<Vec<SetRequest>> = of_each.collect();
    // Forces that get other values follow in the next step.
    let join = |one: SetRequest, other| join_forces(one.clone(), other).unwrap_or(one);
    let remedy = of_each.and_then(|all| all.into_iter().reduce(join));
    let mut finding = finding.clone();
    name_odd_side(&mut finding, sides, known);
    FindingWithRemedy::new(finding, remedy.map(Request::from))
}

/// Adds to the message which side is wrong, and why; or which forces, if these are on both sides. If most other contacts of the model show
/// it, the message has their number already.
fn name_odd_side(finding: &mut Finding, sides: &BothSides<'_>, known: Option<&KnownSide>) {
    let odd_side = known.map(|known| known.side.other());
    let odd: Option<Vec<_>> = finding.paths().map(|path| sides.odd_and_other(path, odd_side)).collect();
    let Some((first, odd)) = odd.as_deref().and_then(|odd| Some((odd.first()?.0, odd))) else { return };
    if odd.iter().any(|(side, _)| *side != first) {
        let paths: Vec<&str> = odd.iter().map(|(_, [wrong, _])| wrong.path.as_str()).collect();
        finding.message.push(format!("; {} differ from the others", listed(&paths, MOST_FORCES_NAMED)));
        return;
    }
    finding.message.push(format!("; the one on the {} differs from the others", first.as_str()));
    if let Some(known) = known {
        let (side, title) = (known.side.as_str(), &known.title);
        finding.message.push(format!(", since the contacts on the {side} are those of {title}"));
    }
}

/// The largest number of forces that a message names.
const MOST_FORCES_NAMED: usize = 4;

/// The request `one`, extended to the forces of `other`; `None` if the requests differ in something else.
fn join_forces(mut one: SetRequest, mut other: SetRequest) -> Option<SetRequest> {
    let added = std::mem::take(&mut other.choice.select);
    other.choice.select.clone_from(&one.choice.select);
    let are_alike = one == other;
    one.choice.select.extend(added);
    are_alike.then_some(one)
}

/// A remedy that writes the values of the right force into the wrong force of the pair whose left force has the path `left`; `None` if it
/// is not known which force is wrong.
fn copy_other_side(
    remedies: &Remedies<'_>,
    model: &Model,
    sides: &BothSides<'_>,
    known: Option<&KnownSide>,
    left: &str,
) -> Option<SetRequest> {
    // Known contacts come first, because there is no majority if every contact of one side is wrong.
    let (_, [wrong, correct]) = sides.odd_and_other(left, known.map(|known| known.side.other()))?;
    let values = values_to_copy(model, wrong, correct, || sides.bones_differ(left))?;
    can_be_set(&values).then_some(())?;
    if !remedies.options.selection.select.is_empty() {
        return None;
    }
    let assignments = values.iter().map(|(property, value)| (*property, Assignment::Value(*value)));
    let set = remedies.set(assignments.collect())?;
    let choice = ForceOptions { select: vec![exact_pattern(&wrong.name)?], ..remedies.choice() };
    Some(SetRequest { choice, ..set })
}

/// Whether `set` accepts these values; it refuses a `constant_contact_force` of 0.
fn can_be_set(values: &[(Property, f64)]) -> bool {
    values.iter().all(|(property, value)| property.allows(*value))
        && !values.contains(&(Property::ConstantContactForce, 0.0))
}

/// The values of the correct force that differ from those of the wrong one; `None` if one `set` cannot make them equal.
fn values_to_copy(
    model: &Model,
    wrong: &Force,
    correct: &Force,
    bones_differ: impl FnOnce() -> bool,
) -> Option<Vec<(Property, f64)>> {
    let ([wrong_set], [correct_set]) = (wrong.sets.as_slice(), correct.sets.as_slice()) else { return None };
    let pairs = wrong_set.values.iter().zip(&correct_set.values);
    let uneven = pairs.filter(|(wrong, correct)| wrong.number != correct.number);
    let mut values: Vec<(Property, f64)> = uneven.map(|(_, one)| (one.property, one.number)).collect();
    let [wrong_radii, correct_radii] = [wrong, correct].map(|force| -> Vec<f64> {
        let spheres = force.spheres().iter().filter_map(|&id| model.sphere(id));
        spheres.map(|sphere| sphere.radius.number).collect()
    });
    if wrong_radii != correct_radii {
        // On bones of another size, the radius of the other side and what follows from it would be wrong.
        if bones_differ() {
            return None;
        }
        common_number(&wrong_radii)?;
        values.push((Property::Radius, common_number(&correct_radii)?));
    }
    Some(values).filter(|values| !values.is_empty())
}

/// The first of `numbers`, if all are equal.
fn common_number(numbers: &[f64]) -> Option<f64> {
    let first = *numbers.first()?;
    numbers.iter().all(|&one| one == first).then_some(first)
}

rule! { pub(super) LEFT_RIGHT_CLOSE: LeftRightClose, Remark, Sides;
    what: "Left and right contacts differ as little as those of published models.",
    why: "Of 150 published models with contacts on both sides, the radii of five differ by 0.7 to 5.7 %, and the transition velocity of one by 5 %. Up to 10 % in radii, 20 % in transition velocities and 1 % in other numbers, as by rounding, count as intended.",
    advice: "Nothing, if this is intended; else write the number of one side into the other",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Piece { model: "table1/human_62kg_smooth_sphere.osim",
        good: "<radius>0.032000000000000001</radius>", bad: "<radius>0.0331</radius>" },
}

rule! { pub(super) LEFT_RIGHT_PLACES: LeftRightPlaces, Warning, Sides;
    what: "A sphere is not at the mirrored place of its counterpart on the other side.",
    why: "In published models each sphere is at most 2.3 % of the limb's longest bone from the mirror image of its counterpart, in the frames of the two bodies and by the sizes of their bones. More is a sign that was forgotten, another unit, or another body.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`, and correct the place, or the body, of the sphere that is wrong",
    repair: Repair::NotPossible("only you know which side is right"),
    example: Example::Piece { model: "table1/human_62kg_smooth_sphere.osim",
        good: "<location>0.05024 -0.037199999999999997 -0.048000000000000001</location>",
        bad: "<location>0.05024 -0.037199999999999997 0.008</location>" },
}

/// One finding for all pairs of spheres whose places are not mirror images. It is about the pair that is farthest apart; spheres on bodies
/// that are not counterparts count as the farthest.
pub(super) fn find_left_right_places(sides: &BothSides<'_>) -> Option<Finding> {
    let are_copied = sides.pairs.iter().all(|pair| pair.right.place_m == pair.left.place_m);
    let limit = if are_copied { COPIED_PLACE_OF_BONE } else { SAME_PLACE_OF_BONE };
    let mut far_pairs: Vec<(f64, &SpherePair<'_>)> =
        sides.pairs.iter().filter_map(|pair| Some((distance_too_far(pair, limit)?, pair))).collect();
    far_pairs.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let (apart, worst) = far_pairs.first()?;
    let more = other_cases_in_words(far_pairs.len(), "another pair, too", "other pairs, too");
    let text = format!("{}{more}", describe_places(worst));
    let spheres = far_pairs.iter().map(|(_, pair)| pair.left.sphere);
    Some(finding_about_spheres(&LEFT_RIGHT_PLACES, text, spheres)?.with_measure(*apart, ""))
}

/// Like [`SAME_PLACE_OF_BONE`], if all numbers of the left places are those of the right ones: they were copied, not mirrored.
const COPIED_PLACE_OF_BONE: f64 = 0.002;

/// The distance between the places of a pair, as a part of the limb's longest bone, if it exceeds `limit`.
fn distance_too_far(pair: &SpherePair<'_>, limit: f64) -> Option<f64> {
    let Some(bodies) = &pair.bodies else { return Some(f64::INFINITY) };
    let apart = bodies.apart_m(pair.right.place_m, pair.left.place_m)? / bodies.bone_m?;
    (apart > limit).then_some(apart)
}

/// The places of a left and a right sphere in words, and how they differ.
fn describe_places(pair: &SpherePair<'_>) -> String {
    let (left, right) = (&pair.left, &pair.right);
    let names = [left, right].map(|placed| (shown(&placed.sphere.name), shown(placed.body)));
    let [(left_name, left_body), (right_name, right_body)] = names;
    let bodies = pair.bodies.as_ref();
    let apart = bodies.and_then(|one| Some((one, one.apart_m(right.place_m, left.place_m)?, one.bone_m?)));
    let Some((bodies, apart_m, bone_m)) = apart else {
        return format!("{left_name} is on {left_body}, its counterpart {right_name} on {right_body}");
    };
    let sign = bodies.axis_with_wrong_sign(right.place_m, left.place_m, SAME_PLACE_OF_BONE / 3.0 * bone_m);
    let sign = sign.map(|axis| format!(": the sign of {axis} is wrong on one of them")).unwrap_or_default();
    let [apart_mm, bone_mm] = [apart_m, bone_m].map(|m| three_significant(m * 1e3));
    let part = three_significant(100.0 * apart_m / bone_m);
    format!(
        "{left_name} on {left_body} is {apart_mm} mm from the mirror image of {right_name} on {right_body}, \
         {part} % of the limb's longest bone ({bone_mm} mm), expected at most {} %{sign}",
        100.0 * SAME_PLACE_OF_BONE
    )
}

rule! { pub(super) LEFT_RIGHT_MISSING: LeftRightMissing, Warning, Sides;
    what: "A sphere has no counterpart on the other side.",
    why: "The other side has the body but fewer spheres, so that each of them carries more of the weight. Of 150 published models with contacts on both sides four have different numbers, all with prostheses.",
    advice: "Add the sphere that is missing, or remove the extra one from the file",
    repair: Repair::NotPossible("only you know which side is right"),
    example: Example::Piece { model: "format/v40000.osim", good: "<geometry>floor heel_l toe_l</geometry>",
        bad: "<geometry>floor heel_l</geometry>" },
}

/// One finding for all spheres without a counterpart.
pub(super) fn find_left_right_missing(sides: &BothSides<'_>) -> Option<Finding> {
    let all: Vec<(&Sphere, &str, &str)> = sides
        .unpaired
        .iter()
        .filter_map(|unpaired| Some((unpaired.sphere.sphere, unpaired.sphere.body, unpaired.other_body?)))
        .collect();
    let (sphere, body, other_body) = all.first()?;
    // A counterpart on another body, such as the pelvis.
    let series = without_side(&sphere.name);
    let mut by_name = sides.model.spheres().iter().filter(|one| without_side(&one.name) == series);
    let elsewhere = by_name.find_map(|one| {
        let carrier = one.body.as_deref().filter(|carrier| ![*body, *other_body].contains(carrier))?;
        Some(format!(": {} is on {}", shown(&one.name), shown(carrier)))
    });
    let text = format!(
        "{} on {} has no counterpart on {}{}{}",
        shown(&sphere.name),
        shown(body),
        shown(other_body),
        elsewhere.unwrap_or_default(),
        other_cases_in_words(all.len(), "another sphere neither", "other spheres neither")
    );
    finding_about_spheres(&LEFT_RIGHT_MISSING, text, all.iter().map(|(sphere, _, _)| *sphere))
}

rule! { pub(super) LEFT_RIGHT_OFF: LeftRightOff, Warning, Sides;
    what: "A contact is switched off on one side alone.",
    why: "The side that is switched off carries nothing there: the body sinks in, or falls to that side.",
    advice: "Switch it on in the file (appliesForce), or switch the other side off, too",
    repair: Repair::NotPossible("only numbers are changed, and only you know which side is right"),
    example: Example::Piece { model: "table1/human_62kg_smooth_sphere.osim",
        good: r#"<SmoothSphereHalfSpaceForce name="contact_s1_r">"#,
        bad: r#"<SmoothSphereHalfSpaceForce name="contact_s1_r"><appliesForce>false</appliesForce>"# },
}

/// One finding for all contacts that are switched off on one side.
pub(super) fn find_left_right_off(sides: &BothSides<'_>) -> Option<Finding> {
    let pairs = sides.pairs.iter();
    let off: Vec<[&SideSphere<'_>; 2]> = pairs
        .filter_map(|pair| match (sides.applies(pair.right.sphere), sides.applies(pair.left.sphere)) {
            (true, false) => Some([&pair.left, &pair.right]),
            (false, true) => Some([&pair.right, &pair.left]),
            _ => None,
        })
        .collect();
    let [first, counterpart] = *off.first()?;
    let more = other_cases_in_words(off.len(), "another pair, too", "other pairs, too");
    let text = format!(
        "the contact of {} on the {} is switched off, that of {}, its counterpart, is not{more}",
        shown(&first.sphere.name),
        first.side.as_str(),
        shown(&counterpart.sphere.name)
    );
    finding_about_spheres(&LEFT_RIGHT_OFF, text, off.iter().map(|[off, _]| off.sphere))
}

rule! { pub(super) LEFT_RIGHT_SWAPPED: LeftRightSwapped, Warning, Sides;
    what: "Spheres on the right have names of the left, and the reverse.",
    why: "No name of 1,321 published spheres contradicts the side of its body. Where both sides of a table are swapped, each foot has the places of the other: the mirror image of a foot under a foot, and results are of the wrong side.",
    advice: "Look at `plot MODEL output=FILE.svg kind=feet`, and give each sphere a body and a place of the side in its name",
    repair: Repair::NotPossible("only you know whether the names are wrong, or the bodies"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/left_right_swapped.osim" },
}

/// One finding for all swapped pairs; or for all spheres, if only one side has spheres and their names are of the other side. A single
/// sphere on the wrong side has no counterpart, which is another finding.
pub(super) fn find_left_right_swapped(sides: &BothSides<'_>) -> Option<Finding> {
    let of_other_side = sides
        .one_side
        .iter()
        .filter(|placed| Side::of_name(&placed.sphere.name) == Some(placed.side.other()));
    if let Some(first) = of_other_side.clone().next() {
        let more =
            other_cases_in_words(of_other_side.clone().count(), "another sphere, too", "other spheres, too");
        let text = format!("{} is on {}{more}", shown(&first.sphere.name), shown(first.body));
        return finding_about_spheres(&LEFT_RIGHT_SWAPPED, text, of_other_side.map(|placed| placed.sphere));
    }
    let swapped: Vec<&SpherePair<'_>> = sides.pairs.iter().filter(|pair| is_swapped(pair)).collect();
    let first = swapped.first()?;
    let more = other_cases_in_words(swapped.len(), "another pair, too", "other pairs, too");
    let [right, left] =
        [&first.right, &first.left].map(|placed| (shown(&placed.sphere.name), shown(placed.body)));
    let text = format!("{} is on {}, and {} on {}{more}", right.0, right.1, left.0, left.1);
    let spheres = swapped.iter().flat_map(|pair| [pair.right.sphere, pair.left.sphere]);
    finding_about_spheres(&LEFT_RIGHT_SWAPPED, text, spheres)
}

/// Whether the name of each sphere of the pair has the side of the other sphere.
fn is_swapped(pair: &SpherePair<'_>) -> bool {
    let names_side = |placed: &SideSphere<'_>, side| Side::of_name(&placed.sphere.name) == Some(side);
    pair.bodies.is_some() && names_side(&pair.right, Side::Left) && names_side(&pair.left, Side::Right)
}

rule! { pub(super) ONE_SIDE_ONLY: OneSideOnly, Remark, Sides;
    what: "Spheres are on one side alone: the other one has none, or no body for them. It is a warning if the other side has spheres that no force presses.",
    why: "A model that kicks, hops on one leg or has a prosthesis may need no more; one that walks falls to the other side. Spheres that no force presses do nothing in OpenSim.",
    advice: "Nothing, if this is intended; else give the other side contacts, too",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "check/one_side_only.osim" },
}

/// One finding for all spheres, if only one side has spheres.
pub(super) fn find_one_side_only(sides: &BothSides<'_>) -> Option<Finding> {
    if let Some(first) = sides.one_side.first() {
        let other = first.side.other();
        let idle =
            sides.model.spheres().iter().filter(|sphere| {
                !sphere.fixed && sphere.body.as_deref().and_then(Side::of_name) == Some(other)
            });
        let count = idle.clone().count();
        if count > 0 {
            let text = format!(
                "no force presses {} on the {} side on a floor",
                counted(count, "sphere"),
                other.as_str()
            );
            return Some(finding_about_spheres(&ONE_SIDE_ONLY, text, idle)?.with_severity(Severity::Warning));
        }
        let text = format!("only the {} side has contact spheres that meet a floor", first.side.as_str());
        let spheres = sides.one_side.iter().map(|placed| placed.sphere);
        return finding_about_spheres(&ONE_SIDE_ONLY, text, spheres);
    }
    let without_body = sides.unpaired.iter().filter(|unpaired| unpaired.other_body.is_none());
    let first = without_body.clone().next()?.sphere;
    let text = format!(
        "{} on {} has no counterpart: the other side has no such body",
        shown(&first.sphere.name),
        shown(first.body)
    );
    finding_about_spheres(&ONE_SIDE_ONLY, text, without_body.map(|unpaired| unpaired.sphere.sphere))
}
