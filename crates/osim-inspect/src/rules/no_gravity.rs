//! The model has no gravity.

use osim_model::{
    Example, Finding, FindingCode, GravityFor, Needed, Repair, Rule, Seen, Severity, VerdictOn,
};

use crate::inspection::Inspection;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::NoGravity,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Floor),
    what: "The model has no gravity.",
    why: "Without gravity there is no body weight, so indentations are not judged.",
    advice: "Nothing, if that is meant; else set gravity in the model, or look under another one with `check MODEL gravity=G`",
    repair: Repair::NotPossible("only you know the gravity"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<gravity>0 -9.81 0</gravity>",
        bad: "<gravity>0 0 0</gravity>",
    },
};

pub(crate) fn find(inspected: &Inspection) -> Option<Finding> {
    let own = inspected.gravity_m_s2.filter(|&gravity| gravity != 0.0);
    // Where figures are made, it may also have been given.
    let needed = Needed::Gravity { purpose: GravityFor::Figures };
    own.or(inspected.figures.gravity_m_s2).is_none().then(|| Finding::new(&RULE, needed.phrase()))
}
