//! Gravity is in another unit.

use osim_model::messages::readable;
use osim_model::{Example, Finding, FindingCode, Model, Repair, Rule, Seen, Severity, VerdictOn};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::GravityTooLarge,
    severity: Severity::Error,
    seen: Seen::Model,
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

pub(crate) fn find(model: &Model) -> Option<Finding> {
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
    Some(Finding::new(&RULE, text).on_line(model.gravity_line()))
}
