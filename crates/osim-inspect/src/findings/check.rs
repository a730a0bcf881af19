//! What the limits of the paper and the traps of the format say about a model.
//!
//! Codes, severities and their explanations are those of the one register, [`FindingCode`].

use osim_model::{Assignment, FaultKind, FileId, Finding, FindingCode, Model, Needed, Property};
use osim_patch::{Set, set};

use super::answers::answer;
use super::places::Places;
use super::remedy::Remedies;
use super::result::CheckResult;
use super::{known, limits, traps};
use crate::gravity_mismatch::gravity_mismatch;
use crate::inspection::Inspection;
use crate::mass_mismatch::MassMismatch;
use crate::options::InspectOptions;

/// Everything found in a model that was inspected; `compiled` names files that other programs would read instead of it.
#[must_use]
pub fn check_model(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    compiled: Option<&Finding>,
) -> CheckResult {
    check_known(options, model, inspected, (compiled, can_be_changed(options, model)))
}

/// The same where it is known whether the numbers of the model [can be changed](can_be_changed): remedies are proposed only
/// then.
#[must_use]
pub fn check_known(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    (compiled, can_be_changed): (Option<&Finding>, bool),
) -> CheckResult {
    let is_joined = |finding: &Finding| {
        matches!(finding.code, FindingCode::MixedRadii | FindingCode::SeveralParameterSets)
    };
    let chosen = options.selection.apply(model).map(|selected| selected.forces).unwrap_or_default();
    let joined = model.remarks_on(&chosen).iter().any(is_joined);
    let mut remedies = Remedies::new(inspected, joined, can_be_changed, options)
        .changing_radii(!can_be_changed || radii_may_change(options, model));
    let places = Places::of(model, inspected);
    let placed = places.findings(model, &remedies);
    let mismatch = MassMismatch::find(model, &options.masses);
    // Spheres that are moved take the contacts of the right mass with them.
    let another_mass = (!places.are_wrong())
        .then(|| limits::another_mass(inspected, &remedies, places.are_right()))
        .flatten();
    // Contacts that are made right for the body first need other commands afterwards.
    let another_gravity = gravity_mismatch(model, options);
    if mismatch.is_some() || another_mass.is_some() || another_gravity.is_some() || places.are_wrong() {
        remedies = remedies.unsettled();
    }
    let mut findings = traps::findings(model, inspected, &remedies);
    if let Some(mismatch) = mismatch {
        let disagree = findings.iter_mut().filter(|finding| finding.code == FindingCode::MassSourcesDisagree);
        disagree.for_each(|finding| finding.message.push(&mismatch.aside()));
    }
    // What spheres do that stand where they should not is nobody's question.
    if !places.were_left_behind() {
        findings.extend(limits::findings(inspected, &remedies));
    }
    findings.extend(another_mass);
    findings.extend(another_gravity);
    findings.extend(placed);
    findings.extend(compiled.cloned());
    for remedy in findings.iter_mut().filter_map(|finding| finding.remedy.as_mut()) {
        answer(remedy, model, &options.masses);
    }
    CheckResult::new(inspected, known::as_published(inspected, findings))
}

/// `false` where a sphere is used by a force that would not change with it, which is tried, too.
fn radii_may_change(options: &InspectOptions, model: &Model) -> bool {
    let mut trial = Set::new(vec![(Property::Radius, Assignment::Factor(2.0))]);
    trial.again = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    !plan.is_err_and(|fault| matches!(fault.kind, FaultKind::Needed(Needed::SharedSphere { .. })))
}

/// `true` where the numbers of `model` can be changed, which is tried: a remedy that would be refused is no help.
#[must_use]
pub fn can_be_changed(options: &InspectOptions, model: &Model) -> bool {
    let assignments =
        vec![(Property::Dissipation, Assignment::Value(0.0)), (Property::Stiffness, Assignment::Value(1.0))];
    let mut trial = Set::new(assignments);
    trial.again = true;
    let plan = options.selection.apply(model).and_then(|selected| set(model, &selected, &trial));
    plan.and_then(|plan| plan.patched(model, FileId::MAIN)).is_ok()
}
