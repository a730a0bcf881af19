//! The model has no gravity.

use osim_model::{
    Example, Finding, FindingCode, GravityFor, Model, Needed, Repair, Rule, Seen, Severity, VerdictOn,
};

use crate::inspection::Inspection;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::NoGravity,
    severity: Severity::Error,
    seen: Seen::Model,
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
pub(crate) fn find(
    model: &Model,
    inspected: &Inspection,
    are_floors: impl FnOnce() -> bool,
) -> Option<Finding> {
    let own = inspected.gravity_m_s2.filter(|&gravity| gravity != 0.0);
    // Where figures are made, it may also have been given.
    let needed = Needed::Gravity { purpose: GravityFor::Figures };
    let is_missing = own.or(inspected.figures.gravity_m_s2).is_none() && are_floors();
    is_missing.then(|| Finding::new(&RULE, needed.phrase()).on_line(model.gravity_line()))
}
