//! Left and right contacts differ as little as those of published models.

use super::left_right_differ::of_pair;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::sides::BothSides;

pub(crate) static RULE: Rule = Rule {
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
pub(super) fn find(sides: &BothSides<'_>) -> Vec<Finding> {
    let found = sides.differences().into_iter().filter(|(_, _, all)| all.iter().all(|one| one.is_small));
    found.filter_map(|(left, right, all)| of_pair(&RULE, left, right, &all, true)).collect()
}
