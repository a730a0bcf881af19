//! A floor hangs on the body that stands on it.

use osim_model::messages::shown;
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use crate::floors::{Floors, JudgedPlane, PlaneKind};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::FloorOnLimb,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Floor),
    what: "A floor hangs on a body from which the spheres that press on it cannot be lifted.",
    why: "A floor on the pelvis moves with the pelvis: joints turn the feet against it and lift nothing, so it carries no weight and the model falls for ever. Published floors hang on ground, on a chair or on a platform, which the body can leave.",
    advice: "Attach the half-space to ground, or to the platform that is meant, and look at its location and orientation there",
    repair: Repair::NotPossible(
        "a floor is attached by hand; the finding names the line and what to write there",
    ),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/floor_on_limb.osim" },
};

pub(crate) fn find(floors: &Floors) -> Vec<Finding> {
    floors.iter().filter_map(of_plane).collect()
}

fn of_plane(judged: &JudgedPlane) -> Option<Finding> {
    let (PlaneKind::OnLimb, plane) = (judged.kind, &judged.plane) else { return None };
    let (body, frame) = (plane.body.as_deref()?, &plane.frame);
    let tag = shown(&frame.tag);
    let text = format!(
        "{} hangs on {}, and nothing but turning joints is between that and the spheres that press on it; for a floor on ground write \
         <{tag}>{}</{tag}>",
        shown(&plane.name),
        shown(body),
        frame.ground,
    );
    Some(Finding::at(&RULE, frame.line, text).about(&plane.path))
}
