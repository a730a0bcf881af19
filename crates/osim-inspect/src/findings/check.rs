//! Applies all rules to one model and adds remedies to the findings.
//!
//! Each [`Rule`](osim_model::Rule) has the code, the severity and the explanation of its findings.

use std::cell::LazyCell;

use osim_model::{
    FaultKind, Finding, FindingCode, ForceId, MassRequest, MassSource, Model, Property, Severity, Suspicion,
    YesQuestion, are_equal_masses,
};
use osim_requests::options::{AnswerOptions, ForceOptions, MassOptions};
use osim_requests::{Kilograms, Request, RescaleRequest};

use crate::findings::check_result::{CheckResult, sort_findings};
use crate::findings::effects::without_effects;
use crate::findings::remedy::{ChangeableValues, Remedies};
use crate::plane_judgement::Floors;
use crate::published_layouts::volume_of_published_bones;
use crate::rules::places::SpherePlaces;
use crate::rules::sides::{self, KnownSide};
use crate::rules::{
    FigureCheck, apply_figure_rules, apply_floor_rules, contacts, depth, find_remedy, floors,
};
use crate::{
    BothSides, FindingWithRemedy, InspectOptions, Inspection, KnownContacts, MassMismatch, unexplained_mass,
};

/// Checks a model that was inspected. `other_findings` are findings about other files, such as a recording.
pub fn check_model(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    other_findings: &[Finding],
    changeable: ChangeableValues,
) -> CheckResult {
    let findings = collect_findings(options, model, inspected, other_findings, changeable);
    CheckResult::new(model, inspected, findings)
}

/// All findings about a model that was inspected, without remedies, in the order of [`CheckResult::findings`].
pub fn check_without_remedies(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
) -> Vec<FindingWithRemedy> {
    sort_findings(without_effects(model, all_findings(options, model, inspected)).0)
}

/// All findings about a model that was inspected, without remedies, with those that only follow from others.
pub fn all_findings(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
) -> Vec<FindingWithRemedy> {
    let without_remedies = ChangeableValues { numbers: false, radii: false };
    collect_findings(options, model, inspected, &[], without_remedies)
}

/// All findings about a model, with their remedies, and with those that only follow from others.
fn collect_findings(
    options: &InspectOptions,
    model: &Model,
    inspected: &Inspection,
    other_findings: &[Finding],
    changeable: ChangeableValues,
) -> Vec<FindingWithRemedy> {
    use FindingCode::*;
    let shares_a_modulus = |finding: &Finding| matches!(finding.code(), MixedRadii | SeveralParameterSets);
    let selected = options.selection.apply(model);
    let chosen = selected.as_ref().map_or(&[][..], |selected| &selected.forces);
    let one_modulus = model.remarks_on(chosen).iter().any(shares_a_modulus);
    let mut remedies = Remedies::new(inspected, one_modulus, changeable, options);
    // A command that makes contacts right for what is wrong elsewhere would hide the fault.
    let has_finding = |code| inspected.findings.iter().any(|finding| finding.code() == code);
    let has_loose_body = has_finding(BodyWithoutJoint);
    let causes = [MasslessBody, HeavyFoot, OutOfDomain, MisplacedObject, FootSphereOnGround];
    let floors_of_model = Floors::of(model);
    let about_floors = apply_floor_rules(model, inspected, &floors_of_model);
    let severe_about_floors = about_floors.iter().filter(|finding| finding.severity > Severity::Remark);
    let severe_codes: Vec<FindingCode> = severe_about_floors.map(Finding::code).collect();
    let is_gravity_odd = severe_codes.contains(&OddGravity);
    let of_gravity = [GravityNotDown, GravityTooLarge, NoGravity, OddGravity];
    let is_gravity_wrong = of_gravity.iter().any(|code| severe_codes.contains(code));
    if has_loose_body || causes.into_iter().any(has_finding) || are_numbers_exchanged(model) {
        remedies = remedies.none_yet();
    }
    let places = SpherePlaces::of(model, inspected);
    let place_findings = places.findings(model, &remedies);
    let mismatch = MassMismatch::of_note(model, &options.masses);
    // The command that moves misplaced spheres also scales their contacts to the mass.
    let (are_right, volume) = (places.are_right(), volume_of_published_bones(model));
    let another_mass = contacts::find_contacts_of_another_mass(inspected, &remedies, are_right, volume);
    // A body without a joint may be a copy, whose mass counts twice.
    let another_mass = another_mass.filter(|_| !has_loose_body);
    // Until mass, gravity and places are right, commands about single numbers would be wrong afterwards.
    let in_other_units = floors::are_figures_in_other_units(inspected, about_floors.iter());
    let another_gravity = floors::find_gravity_sources_disagree(model, options).filter(|_| !in_other_units);
    let is_unsettled = mismatch.is_some() || another_mass.is_some() || another_gravity.is_some();
    // Figures of a sphere in millimetres, or of a copied sphere, have no meaning.
    let of_odd_spheres = [OddRadius, OddPlace, CrowdedSpheres, DoubledSpheres];
    if is_unsettled || places.are_wrong() || of_odd_spheres.into_iter().any(has_finding) {
        remedies = remedies.none_yet();
    }
    let mut findings = findings_about_model(model, inspected, about_floors, &remedies);
    if are_bodies_of_another_mass(model, inspected, options) {
        findings.retain(|finding| finding.code() != OddRadius);
    }
    if let Some(mismatch) = mismatch {
        let disagree = findings.iter_mut().filter(|finding| finding.code() == MassSourcesDisagree);
        disagree.for_each(|finding| finding.finding.message.push(&mismatch.clause_about_masses()));
    }
    let are_lost = [LeftRightMissing, NoSurfacesMeet, ShapePressesNothing];
    let mut doubtful = [SphereInTwoForces, LeftRightSwapped].into_iter().chain(are_lost);
    let too_stiff = depth::find_too_stiff_contacts(&FigureCheck::new(inspected, &remedies));
    let is_too_stiff = too_stiff.is_some_and(|finding| finding.severity > Severity::Remark);
    if doubtful.any(has_finding) || is_too_stiff {
        // Numbers that suit forces which are doubled, lost, on the other foot or in another unit are wrong without the fault.
        remedies = remedies.none_yet();
    }
    // Figures under a gravity in another unit, or of a property whose name is misspelt, are not judged.
    if !in_other_units && !has_finding(UnknownName) {
        findings.extend(apply_figure_rules(&FigureCheck::new(inspected, &remedies)));
    }
    let makes_level = |remedy: &mut Request| matches!(remedy, Request::Set(set) if set.level);
    if [LeftRightDiffer, LeftRightPlaces, SpheresMisplaced].into_iter().any(has_finding) {
        // To make feet level would hide the wrong place or radius.
        findings.iter_mut().for_each(|one| drop(one.remedy.take_if(makes_level)));
    }
    if findings.iter().any(|one| one.code() == LeftRightDiffer && one.remedy.is_none()) {
        // While the wrong side is not known, it is not known either how deep its spheres sink.
        let needs_depth = |code| matches!(code, SunkIn | BeyondHertz | Floats | ForceBeforeContact);
        findings.iter_mut().filter(|one| needs_depth(one.code())).for_each(|one| one.remedy = None);
    }
    if selected.as_ref().is_err_and(|fault| matches!(fault.kind, FaultKind::NoContacts { .. })) {
        // A model without contacts needs neither a number of spheres nor a mass.
        findings.retain(|one| !matches!(one.code(), CountUnknown | MassUnknown));
    }
    if let Some(bare) = selected.as_ref().err().and_then(|fault| contacts::find_bare_model(fault, model)) {
        let causes = [IgnoredContacts, FootSphereOnGround];
        findings.extend((!causes.into_iter().any(has_finding)).then(|| bare.into()));
    }
    if findings.iter().any(|one| one.code() == LeftRightDiffer && one.remedy.is_some()) {
        // The other side has the stiffness that was forgotten.
        findings.iter_mut().filter(|one| one.code() == DefaultStiffness).for_each(|one| one.remedy = None);
    }
    findings.extend(another_mass);
    findings.extend(another_gravity.map(FindingWithRemedy::from));
    // Two rules about places accuse one sphere once.
    let place_findings = place_findings.into_iter().filter(|one| !is_accused(one, &findings));
    findings.extend(place_findings.collect::<Vec<_>>());
    findings.extend(other_findings.iter().cloned().map(FindingWithRemedy::from));
    if has_finding(UnknownName) {
        findings.retain(|finding| !is_effect_of_misspelling(finding.code()));
    }
    // Spheres that move along a wrong gravity would be at wrong places afterwards.
    let scales = |remedy: &mut Request| matches!(remedy, Request::Rescale(_) | Request::Transfer(_));
    let needs_gravity = |remedy: &mut Request| is_gravity_odd || makes_level(remedy) || scales(remedy);
    for one in findings.iter_mut().filter(|_| is_gravity_wrong) {
        if one.remedy.take_if(needs_gravity).is_some() {
            one.finding.message.push("; gravity has to be corrected first");
        }
    }
    for remedy in findings.iter_mut().filter_map(|finding| finding.remedy.as_mut()) {
        confirm_suspicions(remedy, model, &options.masses);
    }
    with_published_severities(model, chosen, inspected, findings)
}

/// Whether `findings` have the code of `one` for all its spheres, as severely.
fn is_accused(one: &FindingWithRemedy, findings: &[FindingWithRemedy]) -> bool {
    let alike = findings.iter().filter(|other| other.code() == one.code() && other.severity >= one.severity);
    let spheres: Vec<&String> = alike.flat_map(|other| &other.spheres).collect();
    !one.spheres.is_empty() && one.spheres.iter().all(|sphere| spheres.contains(&sphere))
}

/// Whether findings of this code only show the defaults that OpenSim takes where the name of a property is misspelt. Other causes of them
/// are found once the name is right.
fn is_effect_of_misspelling(code: FindingCode) -> bool {
    use FindingCode::*;
    matches!(
        code,
        ConnecteeByName
            | SocketNowhere
            | OutOfDomain
            | NotFinite
            | MassUnknown
            | FloorUpright
            | FloorUpsideDown
            | FloorSlopes
            | DefaultStiffness
            | NoSurfacesMeet
            | DynamicAboveStatic
            | LeftRightDiffer
            | LeftRightClose
            | LeftRightPlaces
            | LeftRightMissing
            | OneSideOnly
            | DoubledSpheres
            | CrowdedSpheres
    )
}

/// Whether the contacts are made for another mass than the mass of the bodies. The bones then show nothing about the right radii.
fn are_bodies_of_another_mass(model: &Model, inspected: &Inspection, options: &InspectOptions) -> bool {
    let Some(made_for) = &inspected.contacts_mass_kg else { return false };
    let is_meant =
        [MassSource::Note, MassSource::ContactsMass].iter().any(|one| one.as_str() == made_for.source);
    let bodies_kg = options.masses.bodies_kg(model).filter(|_| is_meant);
    bodies_kg.is_some_and(|bodies_kg| !are_equal_masses(made_for.value, bodies_kg))
}

/// Whether a contact has more dissipation, s/m, or friction than stiffness, N/m²: one was written in the place of the other. A stiffness
/// that OpenSim takes by default is left out.
fn are_numbers_exchanged(model: &Model) -> bool {
    const LEAST_EXCHANGED: f64 = 1e3;
    use Property::{Dissipation, DynamicFriction, StaticFriction, ViscousFriction};
    let mut sets = model.forces().iter().flat_map(|force| &force.sets);
    sets.any(|set| {
        let number = |property| set.value(property).map(|value| value.number);
        let others = [Dissipation, DynamicFriction, StaticFriction, ViscousFriction].into_iter();
        let most = others.filter_map(number).fold(LEAST_EXCHANGED, f64::max);
        number(Property::Stiffness).is_some_and(|stiffness| most > stiffness.max(LEAST_EXCHANGED))
    })
}

/// All findings about the model, except those about the figures of its spheres.
fn findings_about_model(
    model: &Model,
    inspected: &Inspection,
    about_floors: Vec<Finding>,
    remedies: &Remedies<'_>,
) -> Vec<FindingWithRemedy> {
    let sides = LazyCell::new(|| BothSides::of(model));
    let known_side = LazyCell::new(|| KnownSide::of(model, &sides, inspected));
    let with_remedy = |finding: &Finding| {
        if finding.code() == FindingCode::LeftRightDiffer {
            return sides::with_odd_side(model, &sides, known_side.as_ref(), finding, remedies);
        }
        FindingWithRemedy::new(finding.clone(), find_remedy(model, finding, remedies))
    };
    let mut findings: Vec<FindingWithRemedy> = inspected.findings.iter().map(with_remedy).collect();
    // The forces that a change applies to if the caller chooses no forces.
    let on_half_spaces = model.forces().iter().filter(|force| model.meets_half_space(force));
    let remarks = model.remarks_on(&on_half_spaces.map(|force| force.id).collect::<Vec<_>>());
    findings.extend(remarks.into_iter().map(FindingWithRemedy::from));
    let others = about_floors.into_iter().chain(contacts::find_count_unknown(inspected));
    findings.extend(others.map(FindingWithRemedy::from));
    findings
}

/// Gives a finding the severity that the table of known contacts has for it, if the numbers on which the finding depends are the published
/// ones. Adds a remark if all numbers are the published ones.
fn with_published_severities(
    model: &Model,
    chosen: &[ForceId],
    inspected: &Inspection,
    findings: Vec<FindingWithRemedy>,
) -> Vec<FindingWithRemedy> {
    let count = inspected.spheres_per_limb.map(|count| count as f64);
    let severity = |finding: &FindingWithRemedy| match inspected.known_contacts {
        Some(known) => known.severity(finding.code(), inspected.mass_kg),
        None if finding.severity == Severity::Remark => None,
        None => KnownContacts::severity_of_similar(model, chosen, count, inspected.mass_kg, finding),
    };
    let with_severity = |finding: FindingWithRemedy| match severity(&finding) {
        Some(severity) => finding.with_published_severity(severity),
        None => finding,
    };
    let mut findings: Vec<FindingWithRemedy> = findings.into_iter().map(with_severity).collect();
    findings.extend(inspected.known_contacts.map(|known| contacts::known_contacts(known).into()));
    findings
}

// Questions that the program would ask about a remedy. Their answers are part of the remedy, so that its command runs as it is printed.

/// Adds to `remedy` the answer yes to each question that the program would ask about it for `model`.
fn confirm_suspicions(remedy: &mut Request, model: &Model, masses: &MassRequest) {
    let asked = |own: &MassOptions, choice: &ForceOptions| {
        unexplained_mass(&masses_of_remedy(own, masses), model, &choice.selection()).into_iter().collect()
    };
    let questions = match remedy {
        Request::Rescale(request) => suspicions_about_rescaling(request, model, masses),
        Request::Transfer(request) => asked(&request.masses, &request.choice),
        Request::Design(request) => asked(&request.masses, &request.choice),
        Request::Convert(request) => asked(&MassOptions::default(), &request.choice),
        Request::Set(request) => asked(&request.masses, &request.choice),
        _ => Vec::new(),
    };
    let is_asked = |question: &YesQuestion| questions.iter().any(|needs| needs.question() == *question);
    let yes = YesQuestion::ALL.iter().copied().filter(is_asked).collect();
    if let Some(answers) = remedy.answers_mut() {
        *answers = AnswerOptions::new(yes);
    }
}

/// The masses with which a remedy is planned: the masses of the caller, with the mass of the model from the options of the remedy.
fn masses_of_remedy(options: &MassOptions, masses: &MassRequest) -> MassRequest {
    MassRequest {
        contacts_mass_kg: None,
        model_kg: options.mass.map(Kilograms::get),
        target_mass_kg: None,
        ..masses.clone()
    }
}

/// The doubts about masses that the program would have about this rescaling.
fn suspicions_about_rescaling(
    request: &RescaleRequest,
    model: &Model,
    masses: &MassRequest,
) -> Vec<Suspicion> {
    let target_mass_kg = request.target_mass.map(Kilograms::get);
    let contacts_mass_kg = request.masses.contacts_mass.map(Kilograms::get);
    let masses =
        MassRequest { contacts_mass_kg, target_mass_kg, ..masses_of_remedy(&request.masses, masses) };
    let unexplained = unexplained_mass(&masses, model, &request.choice.selection());
    let mut questions: Vec<Suspicion> = unexplained.into_iter().collect();
    if let (Some(contacts_mass_kg), Some(target_mass_kg)) = (contacts_mass_kg, target_mass_kg) {
        let distances = model.joint_distances();
        let ratio = (target_mass_kg / contacts_mass_kg).cbrt();
        questions.extend(model.spheres().iter().filter_map(|sphere| {
            let radius_m = sphere.radius_m().ok()?;
            distances.implausible_radius(sphere, radius_m * ratio, false)
        }));
    }
    questions
}
