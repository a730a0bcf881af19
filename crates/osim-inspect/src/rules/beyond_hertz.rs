//! Spheres sink in deeper than Hertz' law is accurate for, at body weight on one limb.

use contact_scaling::limits::INDENTATION;
use osim_model::messages::four_significant;
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::limits::{CENTRE, Limits, beyond};
use crate::figures::Figure;
use crate::findings::Found;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::BeyondHertz,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "Spheres sink in deeper than Hertz' law is accurate for, at body weight on one limb.",
    why: "Hertz' law was found accurate up to a relative indentation of {indentation}, a contact patch of 0.4 R. Beyond, the contact is a non-linear spring and no longer a material; most published gait models are there (Falisse et al. 2022: 0.353).",
    advice: "Nothing, if a spring is meant; else stiffer, larger or more spheres, for a relative indentation of {indentation} at most",
    repair: Repair::NotPossible("a remark: most published contacts are so, and their authors meant it"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<stiffness>4.4876e7</stiffness>",
        bad: "<stiffness>1e7</stiffness>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(|sphere| beyond(sphere, Figure::Indentation).filter(|&x| x < CENTRE))?;
    let (x, limit) = (four_significant(found.most), INDENTATION.in_words());
    let text = format!("at body weight on one limb x/R is {x} by Hertz, {limit}");
    Some(limits.about(&RULE, &text, &found).into())
}
