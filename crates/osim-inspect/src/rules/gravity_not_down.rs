//! Gravity does not press spheres on their floor.

use osim_model::messages::{readable, shown};
use osim_model::{Example, Finding, FindingCode, Model, Repair, Rule, Seen, Severity, VerdictOn};

use super::turned_floors::UPSIDE_DOWN_DEGREES;
use crate::floors::{Floors, JudgedPlane, PlaneKind};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::GravityNotDown,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Floor),
    what: "Gravity points out of the floor or along it, not into it.",
    why: "The body is where the floor faces, and gravity pulls it away from there or along the floor: the model falls for ever.",
    advice: "Write gravity against the direction in which the floor faces, as a rule 0 -9.80665 0",
    repair: Repair::NotPossible(
        "gravity is changed by hand; the finding names the line and what to write there",
    ),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<gravity>0 -9.81 0</gravity>",
        bad: "<gravity>0 9.81 0</gravity>",
    },
};

/// Components of gravity below this share of its size are what rounding left.
const NOISE: f64 = 1e-6;

/// The finding, from the first floor that shows it.
pub(crate) fn find(model: &Model, floors: &Floors) -> Option<Finding> {
    floors.iter().find_map(|judged| of_plane(model, judged))
}

fn of_plane(model: &Model, judged: &JudgedPlane) -> Option<Finding> {
    let PlaneKind::GravityAside(degrees) = judged.kind else { return None };
    let (surface, size) = judged.plane.surface.zip(model.gravity())?;
    let down = surface.normal.map(|value| if value.abs() < NOISE { 0.0 } else { -value * size });
    let points = if degrees > UPSIDE_DOWN_DEGREES { "out of" } else { "along" };
    let text = format!(
        "gravity is {} m/s2, which points {points} the floor {}, not into it; write <gravity>{}</gravity>",
        model.gravity_m_s2.unwrap_or_default().map(readable).join(" "),
        shown(&judged.plane.name),
        down.map(readable).join(" "),
    );
    Some(Finding::new(&RULE, text).on_line(model.gravity_line()))
}
