//! Spheres stand where they were before OpenSim scaled their bodies.

use crate::messages::{Phrase, readable};
use crate::model::{Example, Finding, FindingCode, Repair, Rule, ScaledSinceNote, Seen, Severity, VerdictOn};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::SpheresLeftBehind,
    severity: Severity::Error,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Spheres stand where they were before OpenSim scaled their bodies.",
    why: "OpenSim's Scale Tool scales bones, joints and masses. It leaves contact spheres where they were, as large and as stiff as before, so that they hang beyond the foot of a smaller animal and end short of a larger one's.",
    advice: "Compare with the model that was scaled: `check MODEL from=ORIGINAL` gives the command that moves the spheres with their bodies and makes the contacts right for this mass, too",
    repair: Repair::Command(
        "lets the spheres follow their bodies, where the note has their sizes or the original is named",
    ),
    example: Example::Models { good: "drawn_feet/six_spheres.osim", bad: "drawn_feet/left_behind.osim" },
};

/// By the note, bodies were scaled since.
pub(crate) fn of_note(noted: &ScaledSinceNote) -> Finding {
    let bodies: Vec<String> =
        noted.factors.iter().map(|(body, factors)| format!("{body} x{}", size(*factors))).collect();
    let text: Phrase = format!(
        "bodies were scaled after the note was written, and the spheres stayed: {}",
        bodies.join(", ")
    )
    .into();
    Finding::new(&RULE, text)
}

/// A sphere is where it was in the model that was scaled.
pub(crate) fn of_sphere(name: &str, here_mm: &str, belongs_mm: &str) -> Finding {
    Finding::new(&RULE, format!("{name} stayed at {here_mm} mm and belongs at {belongs_mm} mm"))
}

/// One number for equal factors.
pub(crate) fn size([x, y, z]: [f64; 3]) -> String {
    if x == y && y == z { readable(x) } else { [x, y, z].map(readable).join(",") }
}
