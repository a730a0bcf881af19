//! A sphere has no counterpart on the other side.

use crate::messages::shown;

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::sides::{Alone, BothSides};

pub(crate) static RULE: Rule = Rule {
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
pub(super) fn find(sides: &BothSides<'_>) -> Option<Finding> {
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
    Some(Finding::at(&RULE, sphere.line, text).about(&sphere.path).of_spheres(names))
}
