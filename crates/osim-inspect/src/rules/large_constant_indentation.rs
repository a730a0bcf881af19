//! The constant indentation of constant_contact_force is a large part of the radius.

use contact_scaling::limits::CONSTANT_INDENTATION;
use osim_model::messages::four_significant;
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::limits::{Limits, beyond};
use crate::figures::Figure;
use crate::findings::Found;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::LargeConstantIndentation,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "The constant indentation of constant_contact_force is a large part of the radius.",
    why: "constant_contact_force is a squared indentation and does not grow with the sphere by itself: OpenSim's default of 1e-5 m2, made for spheres of 32 mm, is 3.2 mm. On smaller spheres it holds the body up before they touch (C.2).",
    advice: "Make constant_contact_force smaller, for a constant indentation of {constant_indentation} of the radius at most; where spheres sink in by less than {indentation} R, of {suggested_indentation}",
    repair: Repair::Command("designs constant_contact_force for the limit"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<constant_contact_force>1.5e-05</constant_contact_force>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(|sphere| beyond(sphere, Figure::ConstantIndentation))?;
    let x = four_significant(found.most);
    let text = format!("sqrt(constant_contact_force)/R is {x}, {}", CONSTANT_INDENTATION.in_words());
    let remedy = limits.remedies.constant_indentation(CONSTANT_INDENTATION.value);
    Some(Found::new(limits.about_force(&RULE, &text, &found), remedy))
}
