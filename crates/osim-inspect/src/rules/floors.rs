//! Rules about floors that are turned wrongly, that slope, or that are on the body which stands on them; and about gravity that is absent,
//! in another unit, or not towards the floor.

use osim_model::feet::{ContactPlane, STEEPEST_FLOOR_RAD};
use osim_model::messages::{Input, four_significant, phrase, readable, shown, three_significant};
use osim_model::{
    Example, Finding, FindingCode, GravityFor, MissingFact, Model, Repair, Rule, Severity,
    are_equal_gravities,
};

use crate::plane_judgement::{Floors, JudgedPlane, PlaneJudgement};
use crate::{InspectOptions, Inspection};
use osim_model::rule;

/// A floor that leans by more than this, degrees, counts as upside down; a less steep one counts as upright.
pub(super) const UPSIDE_DOWN_DEGREES: f64 = 135.0;

/// The finding about a floor that is too steep, and upside down or not, with the orientation that it should have; `None` for other planes.
fn find_turned_floor(judged: &JudgedPlane, rule: &'static Rule, is_upside_down: bool) -> Option<Finding> {
    let (PlaneJudgement::Steep(degrees), plane) = (judged.kind, &judged.plane) else { return None };
    let (orientation, surface) = plane.orientations.first().zip(plane.surface)?;
    if (degrees > UPSIDE_DOWN_DEGREES) != is_upside_down {
        return None;
    }
    let tag = orientation.tag;
    let text = format!(
        "the surface of {} faces {} degrees away from up, expected less than 45, and its spheres have no other floor; to make it \
         level write <{tag}>{}</{tag}>",
        shown(&plane.name),
        three_significant(degrees),
        surface.level_orientation.map(readable).join(" "),
    );
    Some(Finding::at(rule, orientation.position, text).with_place(&plane.path).with_measure(degrees, ""))
}

rule! { pub(super) FLOOR_UPSIDE_DOWN: FloorUpsideDown, Error, Floor;
    what: "A floor is upside down: its solid side is above.",
    why: "The half-space is solid where the body is, so its spheres begin deep inside it and are pushed down. In OpenSim the solid side of a half-space is where x is above 0 in its own frame.",
    advice: "Turn the half-space: orientation 0 0 -1.5707963267948966 makes it face y, 0 0 1.5707963267948966 makes it face −y",
    repair: Repair::NotPossible("the floor has to be corrected in the file; the finding names the line and what to write"),
    example: Example::ElementText { tag: "orientation", good: "0 0 -1.5707963267948966",
        bad: "0 0 1.5707963267948966" },
}

/// The finding about a floor whose surface faces down.
pub(super) fn find_upside_down_floor(judged: &JudgedPlane) -> Option<Finding> {
    find_turned_floor(judged, &FLOOR_UPSIDE_DOWN, true)
}

rule! { pub(super) FLOOR_UPRIGHT: FloorUpright, Error, Floor;
    what: "A floor is upright: it is tilted by more than 45 degrees.",
    why: "The spheres of a limb press on it and on no other floor, so the model falls past it for ever, or is inside it from the beginning. No published floor is tilted by more than 20.5 degrees. Walls that no foot presses on, such as the net of a goal, do not count as floors.",
    advice: "Turn the half-space: its surface faces along the −x of its own frame, and orientation 0 0 -1.5707963267948966 turns that to y",
    repair: Repair::NotPossible("the floor has to be corrected in the file; the finding names the line and what to write"),
    example: Example::ElementText { tag: "orientation", good: "0 0 -1.5707963267948966", bad: "0 0 0" },
}

/// The finding about a floor that stands upright like a wall.
pub(super) fn find_upright_floor(judged: &JudgedPlane) -> Option<Finding> {
    find_turned_floor(judged, &FLOOR_UPRIGHT, false)
}

rule! { pub(super) FLOOR_ON_LIMB: FloorOnLimb, Error, Floor;
    what: "A floor is fixed to a body from which the spheres that press on it cannot be lifted.",
    why: "A floor on the pelvis moves with the pelvis: joints turn the feet against it and lift nothing, so it carries no weight and the model falls for ever. Published floors are fixed to ground, to a chair or to a platform, which the body can leave.",
    advice: "Attach the half-space to ground, or to the platform that it belongs to, and check its location and orientation there",
    repair: Repair::NotPossible("the floor has to be attached in the file; the finding names the line and what to write"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/floor_on_limb.osim" },
}

/// The finding about a floor that is on a body of the limb which presses on it; `None` for other planes.
pub(super) fn find_floor_on_limb(judged: &JudgedPlane) -> Option<Finding> {
    let (PlaneJudgement::OnLimb, plane) = (judged.kind, &judged.plane) else { return None };
    let (body, frame) = (plane.body.as_deref()?, &plane.frame);
    let tag = shown(&frame.tag);
    let text = format!(
        "{} is fixed to {}, and only joints that rotate are between that body and the spheres that press on it; for a floor on ground write \
         <{tag}>{}</{tag}>",
        shown(&plane.name),
        shown(body),
        frame.ground,
    );
    Some(Finding::at(&FLOOR_ON_LIMB, frame.position, text).with_place(&plane.path))
}

rule! { pub(super) FLOOR_SLOPES: FloorSlopes, Remark, Floor;
    what: "A floor is tilted by more than 1 degree, and by no more than 45: a slope.",
    why: "On a slope only the part of gravity along its normal presses spheres into it; values under body weight use that part. Published slopes have up to 20.5 degrees.",
    advice: "Nothing, if this is intended; else turn the half-space",
    repair: Repair::NotPossible("only you know whether a slope is intended"),
    example: Example::ElementText { tag: "orientation", good: "0 0 -1.5707963267948966", bad: "0 0 -1.4" },
}

/// The remark on a floor that slopes; `None` for other planes.
pub(super) fn find_sloping_floor(judged: &JudgedPlane) -> Option<Finding> {
    let (PlaneJudgement::Slope(degrees), plane) = (judged.kind, &judged.plane) else { return None };
    let text = format!(
        "{} is tilted by {} degrees: {} of the weight presses on it",
        shown(&plane.name),
        three_significant(degrees),
        readable((1e4 * degrees.to_radians().cos()).round() / 1e4),
    );
    Some(Finding::at(&FLOOR_SLOPES, plane.position, text).with_place(&plane.path).with_measure(degrees, ""))
}

rule! { pub(super) FLOOR_STEP: FloorStep, Remark, Floor;
    what: "Two floors that face the same way are at different heights.",
    why: "Each sphere presses only on the floors of its own force. A step or a platform is right; a floor that was moved by mistake leaves one foot in the air, or inside the ground.",
    advice: "Nothing, if a step is intended; else give both floors the same location",
    repair: Repair::NotPossible("only you know whether a step is intended"),
    example: Example::Models { good: "format/two_floors.osim", bad: "check/floor_step.osim" },
}

/// Floors face the same way if the cosine of the angle between them is larger than this, which is 1 degree.
const SAME_DIRECTION: f64 = 0.99985;
/// Floors whose heights differ by no more than this, m, are one floor.
const SAME_FLOOR_M: f64 = 1e-3;

/// One finding for the floor that is highest above the first floor, or lowest below it.
pub(super) fn find_floor_step(floors: &Floors) -> Option<Finding> {
    let is_floor =
        |judged: &&JudgedPlane| matches!(judged.kind, PlaneJudgement::Fine | PlaneJudgement::Slope(_));
    let surface_of = |plane: &ContactPlane| plane.surface.filter(|own| own.tilt_rad <= STEEPEST_FLOOR_RAD);
    let mut planes = floors.iter().filter(is_floor).map(|judged| &judged.plane);
    let (first, base) = planes.find_map(|plane| Some((plane, surface_of(plane)?)))?;
    let step = |plane| {
        let surface = surface_of(plane)?;
        let height_m = (surface.point_m - base.point_m).dot(base.normal);
        let is_step = surface.normal.dot(base.normal) > SAME_DIRECTION && height_m.abs() > SAME_FLOOR_M;
        is_step.then_some((height_m, plane))
    };
    let (height_m, plane) = planes.filter_map(step).max_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()))?;
    let mm = four_significant(1e3 * height_m.abs());
    let word = if height_m > 0.0 { "higher" } else { "lower" };
    let text = format!("{} is {mm} mm {word} than {}", shown(&plane.name), shown(&first.name));
    let finding = Finding::at(&FLOOR_STEP, plane.position, text).with_place(&plane.path);
    Some(finding.with_measure(height_m.abs(), ""))
}

rule! { pub(crate) NO_GRAVITY: NoGravity, Error, Floor;
    what: "Spheres press on a floor, and the model has no gravity.",
    why: "Nothing holds the body on its floor, so it drifts away after the first push; without body weight indentations are not judged. All published models in our tests have gravity.",
    advice: "Set gravity in the model, usually to 0 -9.80665 0, or look at it under another one with `check MODEL gravity=G`",
    repair: Repair::NotPossible("only you know the gravity"),
    example: Example::ElementText { tag: "gravity", good: "0 -9.81 0", bad: "0 0 0" },
}

/// Finds a model without gravity whose moving spheres press on a plane.
pub(super) fn find_no_gravity(model: &Model, inspected: &Inspection, floors: &Floors) -> Option<Finding> {
    let gravity = inspected.gravity_m_s2.filter(|&gravity| gravity != 0.0);
    // The caller may also have given a gravity for the figures.
    let fact = MissingFact::Gravity { purpose: GravityFor::Figures };
    let is_missing = gravity.or(inspected.figures.gravity_m_s2).is_none() && floors.are_any();
    is_missing.then(|| Finding::new(&NO_GRAVITY, fact.phrase()).with_position(model.gravity_position()))
}

rule! { pub(crate) GRAVITY_TOO_LARGE: GravityTooLarge, Error, Floor;
    what: "Gravity is more than 100 m/s2: it is probably in mm/s2 or cm/s2.",
    why: "If gravity is a thousand times too large, every sphere sinks in beyond its centre, and a simulation fails. 100 m/s² is ten times the Earth's gravity and four times that of Jupiter, the largest of the planets; 981 and 9810 are the Earth's gravity in cm/s² and mm/s². Other findings that depend on the weight are left out.",
    advice: "Write gravity in m/s²",
    repair: Repair::NotPossible("gravity has to be corrected in the file; the finding names the line and what to write"),
    example: Example::ElementText { tag: "gravity", good: "0 -9.81 0", bad: "0 -9810 0" },
}

/// A gravity above this, m/s², probably is in another unit.
const LARGEST_GRAVITY: f64 = 100.0;
/// Other units in which gravity may be: how many millimetres and centimetres are in a metre.
const UNIT_FACTORS: [f64; 2] = [1000.0, 100.0];
/// If gravity divided by one of the [`UNIT_FACTORS`] is in this range, m/s², gravity is in that unit. The range is half to twice the
/// Earth's gravity.
const GRAVITY_LIKE_ON_EARTH: std::ops::RangeInclusive<f64> = 5.0..=20.0;

/// Finds a gravity that is probably in another unit.
pub(super) fn find_too_large_gravity(model: &Model) -> Option<Finding> {
    let (gravity, size) = (model.gravity_m_s2?, model.gravity().filter(|&size| size > LARGEST_GRAVITY)?);
    let mut text = format!(
        "gravity is {} in the file, which OpenSim reads in m/s2: expected at most {} m/s2",
        gravity.map(readable).join(" "),
        readable(LARGEST_GRAVITY)
    );
    if let Some(unit) = UNIT_FACTORS.into_iter().find(|unit| GRAVITY_LIKE_ON_EARTH.contains(&(size / unit))) {
        let metres = gravity.map(|value| readable(value / unit)).join(" ");
        text.push_str(&format!("; write <gravity>{metres}</gravity>"));
    }
    let finding = Finding::new(&GRAVITY_TOO_LARGE, text).with_position(model.gravity_position());
    Some(finding.with_measure(size, ""))
}

/// Gravity on planets and moons on which a body can stand, m/s²: from a small moon to more than any solid planet.
const KNOWN_GRAVITY: std::ops::RangeInclusive<f64> = 0.1..=20.0;
/// The Earth's gravity, m/s², also as a round number.
const GRAVITY_ON_EARTH: std::ops::RangeInclusive<f64> = 9.0..=10.5;

rule! { pub(crate) ODD_GRAVITY: OddGravity, Warning, Floor;
    what: "Gravity is not that of the Earth. It is a remark from 0.1 to 20 m/s2, as on the Moon.",
    why: "32.17 is the Earth's gravity in feet, 98.1 and 0.00981 have a misplaced decimal point or another unit, and 1 is in multiples of the Earth's. Loads, indentations and speeds of impact follow gravity.",
    advice: "Write gravity in m/s², usually 0 -9.80665 0; nothing, if another gravity is intended",
    repair: Repair::NotPossible("only you know the gravity"),
    example: Example::ElementText { tag: "gravity", good: "0 -9.81 0", bad: "0 -32.17 0" },
}

/// Finds a gravity that is unlike the Earth's. One that a planet or a moon has is right if the note says that the contacts are made for it.
pub(super) fn find_odd_gravity(model: &Model, floors: &Floors) -> Option<Finding> {
    let size = model.gravity().filter(|size| *size > 0.0 && *size <= LARGEST_GRAVITY && floors.are_any())?;
    let of_a_place = KNOWN_GRAVITY.contains(&size);
    let noted = model.note.as_ref().and_then(|note| note.gravity_m_s2);
    let is_noted = of_a_place && noted.is_some_and(|noted| are_equal_gravities(noted, size));
    if is_noted || GRAVITY_ON_EARTH.contains(&size) {
        return None;
    }
    let text = format!("gravity is {} m/s2, that of the Earth 9.81 m/s2", readable(size));
    let finding = Finding::new(&ODD_GRAVITY, text).with_position(model.gravity_position());
    let finding = finding.with_measure((size / 9.81).ln().abs(), "");
    Some(if of_a_place { finding.with_severity(Severity::Remark) } else { finding })
}

/// Whether figures are those under a gravity in another unit: one of `findings` says so of the model's, and the caller gave no other one.
pub(crate) fn are_figures_in_other_units<'f>(
    inspected: &Inspection,
    mut findings: impl Iterator<Item = &'f Finding>,
) -> bool {
    let is_of_model = inspected.figures.gravity_m_s2 == inspected.gravity_m_s2;
    let is_about = |code| matches!(code, FindingCode::GravityTooLarge | FindingCode::OddGravity);
    is_of_model && findings.any(|one| is_about(one.code()) && one.severity > Severity::Remark)
}

rule! { pub(crate) GRAVITY_NOT_DOWN: GravityNotDown, Error, Floor;
    what: "Gravity points out of the floor or along it, not into it.",
    why: "The body is on the free side of the floor, and gravity pulls it off the floor or along it: the model falls for ever.",
    advice: "Write gravity against the direction in which the floor faces, usually 0 -9.80665 0",
    repair: Repair::NotPossible("gravity has to be corrected in the file; the finding names the line and what to write"),
    example: Example::ElementText { tag: "gravity", good: "0 -9.81 0", bad: "0 9.81 0" },
}

/// A floor with its name, unless this says nothing more.
pub(crate) fn floor_in_words(name: &str) -> String {
    if name == "floor" { "the floor".to_owned() } else { format!("the floor {}", shown(name)) }
}

/// Components of a direction that are smaller than this are rounding errors.
const ROUNDING: f64 = 1e-6;

/// The finding that gravity does not point into this floor; `None` if it does.
pub(super) fn find_gravity_not_into_floor(model: &Model, judged: &JudgedPlane) -> Option<Finding> {
    let PlaneJudgement::GravityMisaligned(degrees) = judged.kind else { return None };
    let (surface, size) = judged.plane.surface.zip(model.gravity())?;
    let down = surface.normal.map(|value| if value.abs() < ROUNDING { 0.0 } else { -value * size });
    let points = if degrees > UPSIDE_DOWN_DEGREES { "out of" } else { "along" };
    let text = format!(
        "gravity is {} m/s2, which points {points} {}, not into it; write <gravity>{}</gravity>",
        model.gravity_m_s2.unwrap_or_default().map(readable).join(" "),
        floor_in_words(&judged.plane.name),
        down.to_array().map(readable).join(" "),
    );
    let finding = Finding::new(&GRAVITY_NOT_DOWN, text).with_position(model.gravity_position());
    Some(finding.with_measure(degrees, ""))
}

rule! { pub(crate) GRAVITY_SOURCES_DISAGREE: GravitySourcesDisagree, Warning, Mass;
    what: "The note gives another gravity than the model.",
    why: "Under another gravity than they were made for, spheres sink in more or less; values are those under the model's own.",
    advice: "Set gravity in OpenSim, or look at the model under the gravity of its contacts with `check MODEL gravity=G`",
    repair: Repair::NotPossible("only you know which gravity is right"),
    example: Example::Piece { model: "check/noted.osim", good: "<gravity>0 -9.81 0</gravity>",
        bad: "<gravity>0 -1.62 0</gravity>" },
}

/// Finds a note with another gravity than the model's, unless the caller says which one counts.
pub(crate) fn find_gravity_sources_disagree(model: &Model, options: &InspectOptions) -> Option<Finding> {
    let noted = model.note.as_ref()?.gravity_m_s2?;
    let present = model.gravity().filter(|&gravity| gravity > 0.0)?;
    if options.stance.gravity_m_s2.is_some() || are_equal_gravities(noted, present) {
        return None;
    }
    let size = (noted / present).ln().abs();
    let (noted, present) = (readable(noted), readable(present));
    let message = phrase![
        "its contacts are made for {noted} m/s2 (note in the file), and its gravity is {present} m/s2: set \
        <gravity>{}";
        Input::Gravity.either(phrase![", or give ", Input::Gravity.with_value(noted.as_str())], "")
    ];
    Some(Finding::new(&GRAVITY_SOURCES_DISAGREE, message).with_measure(size, ""))
}
