//! Spheres sink in deeper than Hertz' law is accurate for, at two body weights and not at one.

use contact_scaling::limits::INDENTATION;
use osim_model::messages::four_significant;
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::limits::{Limits, beyond};
use crate::figures::{Figure, SphereFigures};
use crate::findings::Found;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::BeyondHertzAtTwo,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "Spheres sink in deeper than Hertz' law is accurate for, at two body weights and not at one.",
    why: "A foot carries more than body weight in running and landing. At twice body weight the relative indentation is above {indentation}, up to which Hertz' law is accurate.",
    advice: "Nothing, if the model only walks; else stiffer, larger or more spheres, for a relative indentation of {indentation} at two body weights",
    repair: Repair::NotPossible("walking is within the limit; whether the model runs, only you know"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<stiffness>4.4876e7</stiffness>",
        bad: "<stiffness>2.5e7</stiffness>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let only_at_two = |sphere: &SphereFigures| {
        beyond(sphere, Figure::IndentationAtTwo)
            .filter(|_| sphere.is_within(Figure::Indentation) == Some(true))
    };
    let found = limits.concerned(only_at_two)?;
    let (x, limit) = (four_significant(found.most), INDENTATION.in_words());
    let text = format!("at two body weights on one limb x/R is {x} by Hertz, {limit}");
    Some(limits.about(&RULE, &text, &found).into())
}
