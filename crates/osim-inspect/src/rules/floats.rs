//! The smoothing alone carries body weight: the spheres do not touch the floor.

use contact_scaling::limits::{SUGGESTED_TRANSITION_WIDTH, TOUCHING_SHARE};
use osim_model::messages::four_significant;
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use osim_requests::options::WantedOptions;
use osim_requests::{ConstantIndentation, Positive, Request};

use super::limits::Limits;
use crate::figures::{Figure, SphereFigures};
use crate::findings::{Found, Remedies, standing_width, touching_indentation};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::Floats,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "The smoothing alone carries body weight: the spheres do not touch the floor.",
    why: "With constant_contact_force and hertz_smoothing far too large for the spheres, the force before contact holds the body in the air.",
    advice: "Make constant_contact_force smaller and hertz_smoothing larger, until the spheres touch the floor",
    repair: Repair::Command("designs constant_contact_force so that the spheres touch the floor"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<constant_contact_force>0.0001</constant_contact_force>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let above =
        |sphere: &SphereFigures| sphere.value(Figure::IndentationModelLaw).filter(|&x| x <= 0.0).map(|x| -x);
    let found = limits.concerned(above)?;
    let text = format!("body weight is carried {} R above the floor", four_significant(found.most));
    let finding = limits.about_force(&RULE, &text, &found);
    Some(Found::new(finding, remedy(limits.remedies, &limits.spheres)))
}

/// Brings the spheres to the floor. Where contact sets in over a long way that has to be shorter, too: far above the floor the force
/// of (C.1) is large again.
fn remedy(remedies: &Remedies<'_>, spheres: &[&SphereFigures]) -> Option<Request> {
    let (tenth, half) = (standing_width(spheres, TOUCHING_SHARE.value)?, standing_width(spheres, 0.5)?);
    let is_wide = |sphere: &&SphereFigures| {
        let width = sphere.value(Figure::TransitionWidth);
        sphere.is_within(Figure::TransitionWidth) == Some(false) || width.is_some_and(|width| width > half)
    };
    let width = spheres.iter().any(is_wide).then_some(tenth.min(SUGGESTED_TRANSITION_WIDTH));
    let wanted = WantedOptions {
        constant_indentation: Some(ConstantIndentation::new(touching_indentation(spheres)?).ok()?),
        state_width: width.map(Positive::new).transpose().ok()?,
        ..WantedOptions::default()
    };
    remedies.design(wanted).map(Request::from)
}
