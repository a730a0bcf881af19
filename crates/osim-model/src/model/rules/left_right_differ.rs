//! Left and right contacts differ.

use crate::model::contacts::Force;
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::sides::{BothSides, Difference};

pub(crate) static RULE: Rule = Rule {
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
pub(super) fn find(sides: &BothSides<'_>) -> Vec<Finding> {
    let found = sides.differences().into_iter();
    found.filter_map(|(left, right, all)| of_pair(&RULE, left, right, &all, false)).collect()
}

/// What differs between two forces, as much as `are_small` says: the first difference of that kind.
pub(super) fn of_pair(
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
