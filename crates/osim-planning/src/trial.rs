//! Trial plans: which changes of a model would be refused, so that no remedy proposes them.

use osim_inspect::{Changeable, CheckResult, InspectOptions, Inspection, check_model};
use osim_model::{Assignment, FaultKind, FileId, Finding, Model, Needed, Property};
use osim_patch::{Set, set};

/// Tries what can be changed in a model.
#[must_use]
pub fn changeable(options: &InspectOptions, model: &Model) -> Changeable {
    with_numbers(options, model, can_be_changed(options, model))
}

/// Tries the rest where it is known whether the numbers can be changed.
pub(crate) fn with_numbers(options: &InspectOptions, model: &Model, numbers: bool) -> Changeable {
    Changeable { numbers, radii: !numbers || radii_may_change(options, model) }
}

/// Whether radii may change: no sphere is used by a force that would not change with it. This is tried.
fn radii_may_change(options: &InspectOptions, model: &Model) -> bool {
    let mut trial = Set::new(vec![(Property::Radius, Assignment::Factor(2.0))]);
    trial.again = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    !plan.is_err_and(|fault| matches!(fault.kind, FaultKind::Needed(Needed::SharedSphere { .. })))
}

/// Whether the numbers of `model` can be changed. This is tried: a remedy that would be refused does not help.
fn can_be_changed(options: &InspectOptions, model: &Model) -> bool {
    let assignments =
        vec![(Property::Dissipation, Assignment::Value(0.0)), (Property::Stiffness, Assignment::Value(1.0))];
    let mut trial = Set::new(assignments);
    trial.again = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    plan.and_then(|plan| plan.patched(model, FileId::MAIN)).is_ok()
}

/// Checks a model that was inspected, after it was tried what can be changed; `beside` is what was found in files beside it.
#[must_use]
pub fn check_with_trials(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    beside: &[Finding],
) -> CheckResult {
    check_model(options, model, inspected, beside, changeable(options, model))
}
