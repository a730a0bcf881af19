//! The model has no contacts.

use osim_model::{Example, Finding, FindingCode, Model, Repair, Rule, Seen, Severity};

use crate::options::InspectOptions;

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::BareModel,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "The model has no contacts.",
    why: "Nothing carries the model: it has no HuntCrossleyForce or SmoothSphereHalfSpaceForce whose moving spheres meet a half-space.",
    advice: "`add` gives it contacts: those of another model, spheres under its own bones, or places from a table",
    repair: Repair::NotPossible("only you know whose contacts it is to have"),
    example: Example::Models { good: "format/v40000.osim", bad: "bad/no_contacts.osim" },
};

/// A model in which nothing can be chosen.
pub(crate) fn find(options: &InspectOptions, model: &Model) -> Option<Finding> {
    let fault = options.selection.apply(model).err().filter(|fault| fault.code() == "no-contacts")?;
    Some(Finding::new(&RULE, fault.phrase()))
}
