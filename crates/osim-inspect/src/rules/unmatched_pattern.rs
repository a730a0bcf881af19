//! A choice of forces or bodies that chooses nothing.

use osim_model::messages::{Input, Phrase, phrase};
use osim_model::{
    Example, Finding, FindingCode, MassRequest, Model, Pattern, Repair, Rule, Seen, Selection, Severity,
};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::UnmatchedPattern,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "A choice of forces or bodies fits no name in the model.",
    why: "Nothing is chosen or left out by it. Most often the name has a slip, or is that of another model.",
    advice: "Correct the name",
    repair: Repair::NotPossible("only you know which name was meant"),
    example: Example::Request {
        good: r#"{"verb": "inspect", "models": ["table1/human_62kg_smooth_sphere.osim"], "exclude": ["contact_s1_*"]}"#,
        bad: r#"{"verb": "inspect", "models": ["table1/human_62kg_smooth_sphere.osim"], "exclude": ["contact_sl_*"]}"#,
    },
};

/// A message for each pattern of `selection` and of `masses` that fits no name in `model`.
#[must_use]
pub fn unmatched_patterns(selection: &Selection, masses: &MassRequest, model: &Model) -> Vec<Phrase> {
    let said = |input: Input, pattern: &Pattern, what: &str| {
        phrase![input.being(pattern.to_string()), format!(": no {what} of the model has such a name")]
    };
    let forces = selection.unmatched(model).into_iter();
    let forces = forces.map(|(input, pattern)| said(input, pattern, "contact force"));
    let bodies = masses.unmatched(model).map(|pattern| said(Input::ExcludeBody, pattern, "body"));
    forces.chain(bodies).collect()
}

/// One finding for each.
pub(crate) fn find(selection: &Selection, masses: &MassRequest, model: &Model) -> Vec<Finding> {
    let said = unmatched_patterns(selection, masses, model).into_iter();
    said.map(|message| Finding::new(&RULE, message)).collect()
}
