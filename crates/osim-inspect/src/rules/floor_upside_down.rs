//! A floor is upside down.

use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::turned_floors::{UPSIDE_DOWN_DEGREES, turned};
use crate::floors::Floors;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::FloorUpsideDown,
    severity: Severity::Error,
    seen: Seen::Model,
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

pub(crate) fn find(floors: &Floors) -> Vec<Finding> {
    turned(floors, &RULE, |degrees| degrees > UPSIDE_DOWN_DEGREES)
}
