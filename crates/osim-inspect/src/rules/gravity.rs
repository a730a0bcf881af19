//! Gravity: none, in another unit, not towards the floor, or another one than in the note.

use osim_model::messages::{Input, phrase, readable, shown};
use osim_model::{
    Example, Finding, FindingCode, GravityFor, Model, Needed, Repair, Rule, Severity, VerdictOn, same_gravity,
};

use crate::floors::{Floors, JudgedPlane, PlaneKind};
use crate::inspection::Inspection;
use crate::load::InspectOptions;
use crate::rules::floors::UPSIDE_DOWN_DEGREES;

pub(crate) static NO_GRAVITY: Rule = Rule {
    code: FindingCode::NoGravity,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Floor),
    what: "Spheres press on a floor, and the model has no gravity.",
    why: "Nothing holds the body on its floor, so it drifts away after the first push; without body weight indentations are not judged. None of the published models that we test with is so.",
    advice: "Set gravity in the model, as a rule to 0 -9.80665 0, or look at it under another one with `check MODEL gravity=G`",
    repair: Repair::NotPossible("only you know the gravity"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<gravity>0 -9.81 0</gravity>",
        bad: "<gravity>0 0 0</gravity>",
    },
};

/// `are_floors` says whether moving spheres press on any plane.
pub(crate) fn find_no_gravity(
    model: &Model,
    inspected: &Inspection,
    are_floors: impl FnOnce() -> bool,
) -> Option<Finding> {
    let own = inspected.gravity_m_s2.filter(|&gravity| gravity != 0.0);
    // Where figures are made, it may also have been given.
    let needed = Needed::Gravity { purpose: GravityFor::Figures };
    let is_missing = own.or(inspected.figures.gravity_m_s2).is_none() && are_floors();
    is_missing.then(|| Finding::new(&NO_GRAVITY, needed.phrase()).on_line(model.gravity_line()))
}

pub(crate) static GRAVITY_TOO_LARGE: Rule = Rule {
    code: FindingCode::GravityTooLarge,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Floor),
    what: "Gravity is more than 100 m/s2: it is probably in mm/s2 or cm/s2.",
    why: "Under a thousand times its weight every sphere sinks in beyond its centre, and a simulation explodes. 100 m/s² are ten times the Earth's gravity, and four times that of Jupiter, the most of all planets; 981 and 9810 are the Earth's in cm/s² and mm/s². Figures under that weight are not judged.",
    advice: "Write gravity in m/s²",
    repair: Repair::NotPossible(
        "gravity is changed by hand; the finding names the line and what to write there",
    ),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<gravity>0 -9.81 0</gravity>",
        bad: "<gravity>0 -9810 0</gravity>",
    },
};

/// The largest gravity that somebody may mean, m/s².
const LARGEST: f64 = 100.0;
/// Millimetres and centimetres in a metre.
const UNITS: [f64; 2] = [1000.0, 100.0];
/// What gravity is taken for in another unit, m/s²: within half and twice the Earth's.
const USUAL: std::ops::RangeInclusive<f64> = 5.0..=20.0;

pub(crate) fn find_too_large(model: &Model) -> Option<Finding> {
    let (gravity, size) = (model.gravity_m_s2?, model.gravity().filter(|&size| size > LARGEST)?);
    let mut text = format!(
        "gravity is {} in the file, which OpenSim reads in m/s2: expected at most {} m/s2",
        gravity.map(readable).join(" "),
        readable(LARGEST)
    );
    if let Some(unit) = UNITS.into_iter().find(|unit| USUAL.contains(&(size / unit))) {
        let metres = gravity.map(|value| readable(value / unit)).join(" ");
        text.push_str(&format!("; write <gravity>{metres}</gravity>"));
    }
    Some(Finding::new(&GRAVITY_TOO_LARGE, text).on_line(model.gravity_line()))
}

pub(crate) static GRAVITY_NOT_DOWN: Rule = Rule {
    code: FindingCode::GravityNotDown,
    severity: Severity::Error,
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
pub(crate) fn find_not_down(model: &Model, floors: &Floors) -> Option<Finding> {
    floors.iter().find_map(|judged| not_down_finding(model, judged))
}

fn not_down_finding(model: &Model, judged: &JudgedPlane) -> Option<Finding> {
    let PlaneKind::GravityAside(degrees) = judged.kind else { return None };
    let (surface, size) = judged.plane.surface.zip(model.gravity())?;
    let down = surface.normal.map(|value| if value.abs() < NOISE { 0.0 } else { -value * size });
    let points = if degrees > UPSIDE_DOWN_DEGREES { "out of" } else { "along" };
    let text = format!(
        "gravity is {} m/s2, which points {points} the floor {}, not into it; write <gravity>{}</gravity>",
        model.gravity_m_s2.unwrap_or_default().map(readable).join(" "),
        shown(&judged.plane.name),
        down.to_array().map(readable).join(" "),
    );
    Some(Finding::new(&GRAVITY_NOT_DOWN, text).on_line(model.gravity_line()))
}

pub(crate) static GRAVITY_SOURCES_DISAGREE: Rule = Rule {
    code: FindingCode::GravitySourcesDisagree,
    severity: Severity::Warn,
    verdict: Some(VerdictOn::Mass),
    what: "The note gives another gravity than the model.",
    why: "Under another gravity than they were made for, spheres sink in more or less; figures are those under the model's own.",
    advice: "Set gravity in OpenSim, or look at the model under the gravity of its contacts with `check MODEL gravity=G`",
    repair: Repair::NotPossible("only you know which gravity is meant"),
    example: Example::Piece {
        model: "check/noted.osim",
        good: "<gravity>0 -9.81 0</gravity>",
        bad: "<gravity>0 -1.62 0</gravity>",
    },
};

/// The finding, where the note in the file gives a gravity, the model another, and nobody says which is meant.
pub(crate) fn find_sources_disagree(model: &Model, options: &InspectOptions) -> Option<Finding> {
    let noted = model.note.as_ref()?.gravity_m_s2?;
    let own = model.gravity().filter(|&gravity| gravity > 0.0)?;
    if options.stance.gravity_m_s2.is_some() || same_gravity(noted, own) {
        return None;
    }
    let (noted, own) = (readable(noted), readable(own));
    let message = phrase![
        format!(
            "its contacts are made for {noted} m/s2 (note in the file), and its gravity is {own} m/s2: set <gravity>"
        ),
        Input::Gravity.either(phrase![", or say ", Input::Gravity.being(noted)], ""),
    ];
    Some(Finding::new(&GRAVITY_SOURCES_DISAGREE, message))
}
