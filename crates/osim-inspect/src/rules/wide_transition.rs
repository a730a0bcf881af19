//! Contact sets in over more of the radius than in published models.

use contact_scaling::limits::{SUGGESTED_TRANSITION_WIDTH, TRANSITION_WIDTH};
use osim_model::messages::four_significant;
use osim_model::{Example, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use osim_requests::options::WantedOptions;
use osim_requests::{Positive, Request};

use super::limits::{Limits, beyond};
use crate::figures::Figure;
use crate::findings::{Found, Remedies};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::WideTransition,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "Contact sets in over more of the radius than in published models.",
    why: "hertz_smoothing is an inverse length: OpenSim's default of 300 1/m, made for spheres of 32 mm, spreads the onset of contact over 10 mm. On smaller spheres that is a large part of the radius, half of it before they touch (C.7).",
    advice: "Let contact set in over {suggested_width} of the radius, with a larger hertz_smoothing",
    repair: Repair::Command("designs hertz_smoothing for a width within the limit"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<hertz_smoothing>310</hertz_smoothing>",
        bad: "<hertz_smoothing>100</hertz_smoothing>",
    },
};

pub(crate) fn find(limits: &Limits<'_>) -> Option<Found> {
    let found = limits.concerned(|sphere| beyond(sphere, Figure::TransitionWidth))?;
    let (width, limit) = (four_significant(found.most), TRANSITION_WIDTH.in_words());
    let text = format!("contact sets in over {width} R, {limit}");
    Some(Found::new(limits.about_force(&RULE, &text, &found), remedy(limits.remedies)))
}

fn remedy(remedies: &Remedies<'_>) -> Option<Request> {
    let state_width = Some(Positive::new(SUGGESTED_TRANSITION_WIDTH).ok()?);
    remedies.design(WantedOptions { state_width, ..WantedOptions::default() }).map(Request::from)
}
