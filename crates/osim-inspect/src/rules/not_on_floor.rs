//! A simulation from the default pose starts far inside the floor, or above it.

use osim_model::messages::shown;
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};

use super::limits::Limits;
use crate::findings::Found;
use crate::inspection::StandingBody;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::NotOnFloor,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Standing),
    what: "At the default pose the spheres are more than half a radius inside the floor and deeper than where they carry the body, or more than 20 mm above it.",
    why: "A simulation that starts there is thrown into the air by forces of many body weights, or falls first. Most published models are made so, and a simulation of theirs starts from another pose.",
    advice: "Nothing, if simulations start from a pose of their own; else give the coordinate the value that `inspect MODEL` says",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<location>0 -0.05 0</location>",
        bad: "<location>0 0.9 0</location>",
    },
};

/// A finding for each body that does not start on its floor.
pub(crate) fn find(limits: &Limits<'_>) -> Vec<Found> {
    let bodies = &limits.inspected.standing;
    let found = bodies.iter().filter(|body| is_off(body)).filter_map(|body| finding(body, bodies.len() > 1));
    found.map(Found::from).collect()
}

/// Whether a simulation of `body` starts inside the floor or above it.
fn is_off(body: &StandingBody) -> bool {
    body.is_above_floor() || body.is_inside_floor()
}

fn finding(body: &StandingBody, of_several: bool) -> Option<Finding> {
    let which = if of_several { format!("with {} ", shown(&body.body)) } else { String::new() };
    let (place, way) = (body.place()?, body.way_to_stand());
    let text = format!("a simulation {which}from the default pose starts {place}; {way}");
    Some(Finding::new(&RULE, text).about(&body.lowest()?.path))
}
