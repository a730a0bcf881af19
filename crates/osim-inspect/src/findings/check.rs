//! What the limits of the paper and the traps of the format say about a model.
//!
//! Codes, severities and their explanations are those of each [`Rule`](osim_model::Rule).

use std::cell::LazyCell;

use osim_model::{Finding, FindingCode, ForceId, MassRequest, Model, NeedsAnswer, Question, Selection};
use osim_requests::options::{AnswerOptions, ForceOptions, MassOptions};
use osim_requests::{Kilograms, Request, RescaleRequest};

use crate::findings::finding::Found;
use crate::findings::remedy::Remedies;
use crate::findings::result::{CheckResult, in_order};
use crate::floors::Floors;
use crate::inspection::Inspection;
use crate::load::{InspectOptions, MassMismatch, unexplained_slip};
use crate::rules::places::Places;
use crate::rules::sides::{self, KnownSide};
use crate::rules::{Limits, contacts, floors, model_findings, of_figures, of_floors, remedy_of};
use crate::sides::BothSides;

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
        .then(|| contacts::find_contacts_of_another_mass(inspected, &remedies, places.are_right()))
        .flatten();
    // Contacts that are made right for the body first need other commands afterwards.
    let in_other_units = floors::find_too_large(model).is_some();
    let another_gravity = floors::find_sources_disagree(model, options).filter(|_| !in_other_units);
    let is_unsettled = mismatch.is_some() || another_mass.is_some() || another_gravity.is_some();
    if is_unsettled || places.are_wrong() || are_spheres_odd(model) {
        remedies = remedies.unsettled();
    }
    let mut findings = find_in_model(model, inspected, &remedies, asked);
    if let Some(mismatch) = mismatch {
        let disagree =
            findings.iter_mut().filter(|finding| finding.code() == FindingCode::MassSourcesDisagree);
        disagree.for_each(|finding| finding.finding.message.push(&mismatch.aside()));
    }
    // What spheres do that stand where they should not, or under a gravity that nobody means, is nobody's question.
    if !places.were_left_behind() && (!in_other_units || options.stance.gravity_m_s2.is_some()) {
        findings.extend(of_figures(&Limits::new(inspected, &remedies)));
    }
    if let Some(bare) = contacts::find_bare_model(options, model) {
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
    as_published(inspected, findings)
}

/// Whether the spheres themselves have to be corrected first: figures of a sphere in millimetres, or of a copy of one, say nothing.
fn are_spheres_odd(model: &Model) -> bool {
    let codes = [
        FindingCode::OddRadius,
        FindingCode::OddPlace,
        FindingCode::CrowdedSpheres,
        FindingCode::DoubledSpheres,
    ];
    model_findings(model).iter().any(|finding| codes.contains(&finding.code()))
}

// Findings from the model itself: what reading it showed, and what only matters once it is asked.

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Asked {
    All,
    /// Those that numbers of contacts decide: models that differ in nothing else have the others alike.
    OfNumbers,
}

/// Everything that the model shows apart from its figures; what floors and gravity show alone only where it is `asked` for.
fn find_in_model(model: &Model, inspected: &Inspection, remedies: &Remedies<'_>, asked: Asked) -> Vec<Found> {
    let floors = LazyCell::new(|| Floors::of(model));
    let sides = LazyCell::new(|| BothSides::of(model));
    let known = LazyCell::new(|| KnownSide::of(model, &sides, inspected));
    let with_remedy = |finding: &Finding| {
        if finding.code() == FindingCode::LeftRightDiffer {
            return sides::with_odd_side(model, &sides, known.as_ref(), finding, remedies);
        }
        Found::new(finding.clone(), remedy_of(model, finding, remedies))
    };
    let mut found: Vec<Found> = inspected.warnings.iter().map(with_remedy).collect();
    found.extend(model.remarks_on(&meeting_half_space(model)).into_iter().map(Found::from));
    if asked == Asked::All {
        found.extend(of_floors(model, &floors).into_iter().map(Found::from));
    }
    let unknown = [
        floors::find_no_gravity(model, inspected, || floors.are_any()),
        contacts::find_count_unknown(inspected),
    ];
    found.extend(unknown.into_iter().flatten().map(Found::from));
    found
}

/// Forces that a change takes by default.
fn meeting_half_space(model: &Model) -> Vec<ForceId> {
    let forces = model.forces().iter().filter(|force| model.meets_half_space(force));
    forces.map(|force| force.id).collect()
}

/// The findings as bad as they are with these contacts, and a remark that these are known.
fn as_published(inspected: &Inspection, findings: Vec<Found>) -> Vec<Found> {
    let Some(known) = inspected.known_contacts else { return findings };
    let judged = |finding: Found| match known.severity(finding.code()) {
        Some(severity) => finding.as_published(severity),
        None => finding,
    };
    let mut judged: Vec<Found> = findings.into_iter().map(judged).collect();
    judged.push(contacts::known_contacts(known).into());
    judged
}

// Questions that a remedy would be asked: what was found answers them, so that its command runs as it is printed.

/// Answers what `remedy` would be asked for `model`.
fn answer(remedy: &mut Request, model: &Model, masses: &MassRequest) {
    let asked = match remedy {
        Request::Rescale(request) => asked_of_rescale(request, model, masses),
        Request::Transfer(request) => asked_of(&said(&request.masses, masses), model, &request.choice),
        Request::Design(request) => asked_of(&said(&request.masses, masses), model, &request.choice),
        Request::Convert(request) => asked_of(&said(&MassOptions::default(), masses), model, &request.choice),
        Request::Set(request) => asked_of(&said(&request.masses, masses), model, &request.choice),
        _ => Vec::new(),
    };
    let is_asked = |question: &Question| asked.iter().any(|asks| asks.question() == *question);
    let yes = Question::ALL.into_iter().filter(is_asked).collect();
    if let Some(answers) = remedy.answers_mut() {
        *answers = AnswerOptions::new(yes);
    }
}

fn said(own: &MassOptions, masses: &MassRequest) -> MassRequest {
    MassRequest {
        contacts_mass_kg: None,
        model_kg: own.mass.map(Kilograms::get),
        target_mass_kg: None,
        ..masses.clone()
    }
}

fn asked_of(said: &MassRequest, model: &Model, choice: &ForceOptions) -> Vec<NeedsAnswer> {
    let selection: Selection = choice.selection();
    unexplained_slip(said, model, &selection).into_iter().collect()
}

fn asked_of_rescale(request: &RescaleRequest, model: &Model, masses: &MassRequest) -> Vec<NeedsAnswer> {
    let target_mass_kg = request.target_mass.map(Kilograms::get);
    let contacts_mass_kg = request.masses.contacts_mass.map(Kilograms::get);
    let said = MassRequest { contacts_mass_kg, target_mass_kg, ..said(&request.masses, masses) };
    let mut asked = asked_of(&said, model, &request.choice);
    if let (Some(contacts_mass_kg), Some(target_mass_kg)) = (contacts_mass_kg, target_mass_kg) {
        let distances = model.joint_distances();
        let ratio = (target_mass_kg / contacts_mass_kg).cbrt();
        asked.extend(model.spheres().iter().filter_map(|sphere| {
            let radius_m = sphere.radius_m().ok()?;
            distances.implausible_radius(sphere, radius_m * ratio, false)
        }));
    }
    asked
}
