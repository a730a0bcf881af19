//! Floors that are turned wrongly, slope, or hang on the body that stands on them.

use osim_model::messages::{readable, shown, three_significant};
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Severity, VerdictOn};

use crate::floors::{Floors, JudgedPlane, PlaneKind};

/// A floor that leans by more than this, degrees, is nearer to upside down than to upright.
pub(super) const UPSIDE_DOWN_DEGREES: f64 = 135.0;

/// The floors that lean as `is_so` (degrees) says, with what to write instead.
fn find_turned(floors: &Floors, rule: &'static Rule, is_so: impl Fn(f64) -> bool) -> Vec<Finding> {
    let of_plane = |judged: &JudgedPlane| match judged.kind {
        PlaneKind::Steep(degrees) if is_so(degrees) => turned_finding(judged, rule, degrees),
        _ => None,
    };
    floors.iter().filter_map(of_plane).collect()
}

fn turned_finding(judged: &JudgedPlane, rule: &'static Rule, degrees: f64) -> Option<Finding> {
    let plane = &judged.plane;
    let (own, surface) = plane.orientations.first().zip(plane.surface)?;
    let tag = own.tag;
    let text = format!(
        "the surface of {} faces {} degrees away from up, expected less than 45, and its spheres have no other floor; to make it \
         level write <{tag}>{}</{tag}>",
        shown(&plane.name),
        three_significant(degrees),
        surface.level_orientation.map(readable).join(" "),
    );
    Some(Finding::at(rule, own.line, text).about(&plane.path))
}

pub(super) static FLOOR_UPSIDE_DOWN: Rule = Rule {
    code: FindingCode::FloorUpsideDown,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Floor),
    what: "A floor is upside down: its solid side is above.",
    why: "The half-space is solid where the body is, so its spheres begin deep inside it and are pushed down. In OpenSim the solid side of a half-space is where x is above 0 in its own frame.",
    advice: "Turn the half-space: orientation 0 0 -1.5707963267948966 makes it face y, 0 0 1.5707963267948966 makes it face −y",
    repair: Repair::NotPossible(
        "a floor is turned by hand; the finding names the line and what to write there",
    ),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<orientation>0 0 -1.5707963267948966</orientation>",
        bad: "<orientation>0 0 1.5707963267948966</orientation>",
    },
};

pub(super) fn find_upside_down(floors: &Floors) -> Vec<Finding> {
    find_turned(floors, &FLOOR_UPSIDE_DOWN, |degrees| degrees > UPSIDE_DOWN_DEGREES)
}

pub(super) static FLOOR_UPRIGHT: Rule = Rule {
    code: FindingCode::FloorUpright,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Floor),
    what: "A floor is upright: it leans by more than 45 degrees.",
    why: "The spheres of a limb press on it and on no other floor, so the model falls past it for ever, or is inside it from the beginning. No published floor leans by more than 20.5 degrees; walls that no foot presses on, such as the net of a goal, are none.",
    advice: "Turn the half-space: its surface faces along the −x of its own frame, and orientation 0 0 -1.5707963267948966 turns that to y",
    repair: Repair::NotPossible(
        "a floor is turned by hand; the finding names the line and what to write there",
    ),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<orientation>0 0 -1.5707963267948966</orientation>",
        bad: "<orientation>0 0 0</orientation>",
    },
};

pub(super) fn find_upright(floors: &Floors) -> Vec<Finding> {
    find_turned(floors, &FLOOR_UPRIGHT, |degrees| degrees <= UPSIDE_DOWN_DEGREES)
}

pub(super) static FLOOR_ON_LIMB: Rule = Rule {
    code: FindingCode::FloorOnLimb,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Floor),
    what: "A floor hangs on a body from which the spheres that press on it cannot be lifted.",
    why: "A floor on the pelvis moves with the pelvis: joints turn the feet against it and lift nothing, so it carries no weight and the model falls for ever. Published floors hang on ground, on a chair or on a platform, which the body can leave.",
    advice: "Attach the half-space to ground, or to the platform that is meant, and look at its location and orientation there",
    repair: Repair::NotPossible(
        "a floor is attached by hand; the finding names the line and what to write there",
    ),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/floor_on_limb.osim" },
};

pub(super) fn find_on_limb(floors: &Floors) -> Vec<Finding> {
    floors.iter().filter_map(on_limb_finding).collect()
}

fn on_limb_finding(judged: &JudgedPlane) -> Option<Finding> {
    let (PlaneKind::OnLimb, plane) = (judged.kind, &judged.plane) else { return None };
    let (body, frame) = (plane.body.as_deref()?, &plane.frame);
    let tag = shown(&frame.tag);
    let text = format!(
        "{} hangs on {}, and nothing but turning joints is between that and the spheres that press on it; for a floor on ground write \
         <{tag}>{}</{tag}>",
        shown(&plane.name),
        shown(body),
        frame.ground,
    );
    Some(Finding::at(&FLOOR_ON_LIMB, frame.line, text).about(&plane.path))
}

pub(super) static FLOOR_SLOPES: Rule = Rule {
    code: FindingCode::FloorSlopes,
    severity: Severity::Info,
    verdict: Some(VerdictOn::Floor),
    what: "A floor leans by more than 1 degree, and by no more than 45: a slope.",
    why: "On a slope only the part of gravity along its normal presses spheres into it; figures under body weight use that part. Published slopes have up to 20.5 degrees.",
    advice: "Nothing, if that is meant; else turn the half-space",
    repair: Repair::NotPossible("only you know whether a slope is meant"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<orientation>0 0 -1.5707963267948966</orientation>",
        bad: "<orientation>0 0 -1.4</orientation>",
    },
};

pub(super) fn find_slopes(floors: &Floors) -> Vec<Finding> {
    floors.iter().filter_map(slope_finding).collect()
}

fn slope_finding(judged: &JudgedPlane) -> Option<Finding> {
    let (PlaneKind::Slope(degrees), plane) = (judged.kind, &judged.plane) else { return None };
    let text = format!(
        "{} leans by {} degrees: {} of the weight presses on it",
        shown(&plane.name),
        three_significant(degrees),
        readable((1e4 * degrees.to_radians().cos()).round() / 1e4),
    );
    Some(Finding::at(&FLOOR_SLOPES, plane.line, text).about(&plane.path))
}
