//! A floor is a slope.

use osim_model::messages::{readable, shown, three_significant};
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use crate::floors::{Floors, JudgedPlane, PlaneKind};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::FloorSlopes,
    severity: Severity::Info,
    seen: Seen::Model,
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

pub(crate) fn find(floors: &Floors) -> Vec<Finding> {
    floors.iter().filter_map(of_plane).collect()
}

fn of_plane(judged: &JudgedPlane) -> Option<Finding> {
    let (PlaneKind::Slope(degrees), plane) = (judged.kind, &judged.plane) else { return None };
    let text = format!(
        "{} leans by {} degrees: {} of the weight presses on it",
        shown(&plane.name),
        three_significant(degrees),
        readable((1e4 * degrees.to_radians().cos()).round() / 1e4),
    );
    Some(Finding::at(&RULE, plane.line, text).about(&plane.path))
}
