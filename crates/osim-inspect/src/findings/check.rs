//! What the limits of the paper and the traps of the format say about a model.
//!
//! Codes, severities and their explanations are those of each [`Rule`](osim_model::Rule).

use osim_model::{Finding, FindingCode, Model};

use super::answers::answer;
use super::found::Found;
use super::places::Places;
use super::remedy::Remedies;
use super::result::{CheckResult, in_order};
use super::traps::Asked;
use super::{known, traps};
use crate::inspection::Inspection;
use crate::mass_mismatch::MassMismatch;
use crate::options::InspectOptions;
use crate::rules::{
    Limits, bare_model, contacts_of_another_mass, gravity_sources_disagree, gravity_too_large, of_figures,
};

/// What trial plans show of a model: remedies are proposed only where they would not be refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Changeable {
    /// The numbers of its contacts can be changed.
    pub numbers: bool,
    /// Radii can be changed: no sphere has another user that would not change with it.
    pub radii: bool,
}

impl Changeable {
    /// Everything can be changed, which nobody has tried.
    pub const UNTRIED: Self = Self { numbers: true, radii: true };
}

/// Everything found in a model that was inspected; `beside` is what was found in files beside it.
#[must_use]
pub fn check_model(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    beside: &[Finding],
    changeable: Changeable,
) -> CheckResult {
    let found = findings(options, model, inspected, beside, changeable, Asked::All);
    CheckResult::new(model, inspected, found)
}

/// Findings that a change of numbers of contacts can raise or correct, in the order of [`CheckResult::findings`], without remedies: what
/// floors and gravity show stays as it was.
#[must_use]
pub fn check_numbers(options: &InspectOptions, model: &Model, inspected: &Inspection) -> Vec<Found> {
    let untried = Changeable { numbers: false, radii: false };
    in_order(findings(options, model, inspected, &[], untried, Asked::OfNumbers))
}

fn findings(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    beside: &[Finding],
    changeable: Changeable,
    asked: Asked,
) -> Vec<Found> {
    let is_joined = |finding: &Finding| {
        matches!(finding.code(), FindingCode::MixedRadii | FindingCode::SeveralParameterSets)
    };
    let chosen = options.selection.apply(model).map(|selected| selected.forces).unwrap_or_default();
    let joined = model.remarks_on(&chosen).iter().any(is_joined);
    let mut remedies = Remedies::new(inspected, joined, changeable.numbers, options)
        .changing_radii(!changeable.numbers || changeable.radii);
    let places = Places::of(model, inspected);
    let placed = places.findings(model, &remedies);
    let mismatch = MassMismatch::find(model, &options.masses);
    // Spheres that are moved take the contacts of the right mass with them.
    let another_mass = (!places.are_wrong())
        .then(|| contacts_of_another_mass::find(inspected, &remedies, places.are_right()))
        .flatten();
    // Contacts that are made right for the body first need other commands afterwards.
    let in_other_units = gravity_too_large::find(model).is_some();
    let another_gravity = gravity_sources_disagree::find(model, options).filter(|_| !in_other_units);
    let is_unsettled = mismatch.is_some() || another_mass.is_some() || another_gravity.is_some();
    if is_unsettled || places.are_wrong() || are_spheres_odd(model) {
        remedies = remedies.unsettled();
    }
    let mut findings = traps::findings(model, inspected, &remedies, asked);
    if let Some(mismatch) = mismatch {
        let disagree =
            findings.iter_mut().filter(|finding| finding.code() == FindingCode::MassSourcesDisagree);
        disagree.for_each(|finding| finding.finding.message.push(&mismatch.aside()));
    }
    // What spheres do that stand where they should not, or under a gravity that nobody means, is nobody's question.
    if !places.were_left_behind() && (!in_other_units || options.stance.gravity_m_s2.is_some()) {
        findings.extend(of_figures(&Limits::new(inspected, &remedies)));
    }
    if let Some(bare) = bare_model::find(options, model) {
        // How many spheres there are is no question then.
        findings.retain(|finding| finding.code() != FindingCode::CountUnknown);
        findings.push(bare.into());
    }
    findings.extend(another_mass);
    findings.extend(another_gravity.map(Found::from));
    findings.extend(placed);
    findings.extend(beside.iter().cloned().map(Found::from));
    for remedy in findings.iter_mut().filter_map(|found| found.remedy.as_mut()) {
        answer(remedy, model, &options.masses);
    }
    known::as_published(inspected, findings)
}

/// Whether the spheres themselves have to be corrected first: figures of a sphere in millimetres, or of a copy of one, say nothing.
fn are_spheres_odd(model: &Model) -> bool {
    let codes = [
        FindingCode::OddRadius,
        FindingCode::OddPlace,
        FindingCode::CrowdedSpheres,
        FindingCode::DoubledSpheres,
    ];
    model.warnings.iter().any(|finding| codes.contains(&finding.code()))
}
