//! A contact is switched off on one side.

use crate::messages::shown;

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::side::Side;
use crate::model::sides::{BothSides, Placed};

pub(crate) static RULE: Rule = Rule {
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
pub(super) fn find(sides: &BothSides<'_>) -> Option<Finding> {
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
    let finding = Finding::at(&RULE, first.sphere.line, text).about(&first.sphere.path);
    Some(finding.of_spheres(off.iter().map(|[off, _]| off.sphere.name.clone()).collect()))
}
