//! A floor is so steep that nothing stands on it.

use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::turned_floors::{UPSIDE_DOWN_DEGREES, turned};
use crate::floors::Floors;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::FloorUpright,
    severity: Severity::Error,
    seen: Seen::Model,
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

pub(crate) fn find(floors: &Floors) -> Vec<Finding> {
    turned(floors, &RULE, |degrees| degrees <= UPSIDE_DOWN_DEGREES)
}
