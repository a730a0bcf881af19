//! The reference of a transfer, from which contacts are taken: a preset, or a model with its skeleton.

use std::collections::BTreeSet;
use std::path::Path;

use contact_scaling::Preset;
use osim_inspect::{
    ContactsOrigin, KnownContacts, LoadSharing, ReferenceState, SignsOfScaling, Stance,
    find_misplaced_spheres,
};
use osim_model::compare::ScaleFile;
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Input, phrase};
use osim_model::{
    Anatomy, BoneLengths, CountedSpheres, Fault, FaultKind, Mass, MassRequest, MassSource, MissingFact,
    Model, Selected, Selection, Severity, Suspicion, YesQuestion, implausible_mass,
};
use osim_patch::{Reference, preset_model, reference_of_model};
use osim_requests::{Acceleration, Count, Kilograms, TransferRequest};

use crate::opening::{open, read_scale_file};
use crate::prepared_change::file_name;

/// The mass of the reference that counts, if its contacts are published ones for another mass than the mass of its bodies.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum MassOfPublished {
    /// The program asks the caller which mass the contacts were made for.
    AskCaller,
    /// The contacts count as made for the mass of the model's bodies.
    OfBodies,
}

/// The generic model, which OpenSim scaled to the model. The places of scaled spheres follow from its spheres.
#[derive(Clone)]
pub(super) struct GenericModel {
    pub(super) anatomy: Anatomy,
    pub(super) file: Option<ScaleFile>,
    /// The number of the generic model's spheres that share the weight; or the question about this number, which is asked only after the
    /// spheres of the two models were matched.
    pub(super) sphere_count: Result<f64, Fault>,
    /// Names of the generic model's spheres that can carry weight.
    standing: BTreeSet<String>,
    /// The lengths of its bones.
    pub(super) bones: BoneLengths,
    /// What it shows about whether it was scaled itself.
    pub(super) signs: SignsOfScaling,
}

impl GenericModel {
    /// The generic model with the skeleton `anatomy` and the spheres of `model`.
    pub(super) fn with_contacts(&self, anatomy: Anatomy, model: &Model) -> Self {
        Self {
            anatomy,
            file: None,
            sphere_count: self.sphere_count.clone(),
            standing: names_of_standing_spheres(model),
            bones: self.bones.clone(),
            signs: SignsOfScaling::default(),
        }
    }

    /// Whether the spheres that can carry weight have the same names in `model` as in the generic model.
    pub(super) fn has_same_standing_spheres(&self, model: &Model) -> bool {
        names_of_standing_spheres(model) == self.standing
    }
}

/// Names of the spheres of a model that can carry weight.
fn names_of_standing_spheres(model: &Model) -> BTreeSet<String> {
    let spheres = model.loaded_spheres(&model.force_ids()).into_iter();
    spheres.filter_map(|sphere| Some(model.sphere(sphere)?.name.clone())).collect()
}

/// A preset as a reference, with the mass and the number of spheres from the request.
pub(super) fn reference_of_preset(request: &TransferRequest, preset: &Preset) -> (Reference, ReferenceState) {
    let mut reference = Reference::from(preset);
    if let Some(kg) = request.reference.reference_mass {
        reference.mass = given_reference_mass(kg);
    }
    let count = request.reference.reference_spheres.map(Count::get);
    reference.sphere_count = count.unwrap_or(reference.sphere_count);
    let gravity = request.reference.reference_gravity.map(Acceleration::get);
    let state = ReferenceState::from_preset(preset, reference.mass.kg, reference.sphere_count, gravity);
    (reference, state)
}

fn given_reference_mass(kg: Kilograms) -> Mass {
    Mass { kg: kg.get(), source: MassSource::ReferenceMass }
}

/// Reads the model at `from` as a reference, with its skeleton.
///
/// # Errors
/// It cannot be read, or cannot be a reference.
pub(super) fn reference_from_file(
    request: &TransferRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<(Reference, ReferenceState, Option<GenericModel>), Failure> {
    // In a scaled copy of the reference, contacts are scaled as the bodies are, whatever mass they were made for.
    let mass_of_published =
        if request.follow.follow_bodies { MassOfPublished::OfBodies } else { MassOfPublished::AskCaller };
    let read = || reference_of_opened(request, from, &open(from, files)?, mass_of_published, files);
    read().map_err(|mut failure: Failure| {
        // The usual advice is for the model that gets the contacts.
        if failure.code == MissingFact::ForceSet.code() {
            let why = "a set without its model cannot be a reference: name the model it belongs to";
            failure.message = why.into();
        }
        failure
    })
}

/// Uses the opened model `from` as a reference.
///
/// # Errors
/// It cannot be a reference, or the Scale Tool's file cannot be read.
pub(super) fn reference_of_opened(
    request: &TransferRequest,
    from: &Path,
    open: &OpenModel,
    mass_of_published: MassOfPublished,
    files: &dyn Files,
) -> Result<(Reference, ReferenceState, Option<GenericModel>), Failure> {
    let (reference, sphere_count) = reference_from_model(&open.model, mass_of_published, request, from)
        .map_err(|fault| open.failure(fault))?;
    let state = reference_state(request, from, open, &reference);
    let anatomy = match Anatomy::of(&open.model) {
        Ok(anatomy) => anatomy,
        Err(_) if !request.follow.follow_bodies => return Ok((reference, state, None)),
        Err(fault) => return Err(open.failure(fault)),
    };
    let file =
        request.follow.body_scale_file.as_deref().map(|path| read_scale_file(path, files)).transpose()?;
    let standing = names_of_standing_spheres(&open.model);
    let bones = open.model.joint_distances().clone();
    let signs = SignsOfScaling::of(&open.model, &MassRequest::default());
    let generic = GenericModel { anatomy, file, sphere_count, standing, bones, signs };
    Ok((reference, state, Some(generic)))
}

/// The reference under the weight that its contacts are made for, for comparisons.
fn reference_state(
    request: &TransferRequest,
    from: &Path,
    open: &OpenModel,
    reference: &Reference,
) -> ReferenceState {
    let options = &request.reference;
    let selection = Selection { select: options.reference_select.clone(), ..Selection::default() };
    let gravity = options.reference_gravity.map(Acceleration::get).or(reference.gravity_m_s2);
    let spheres = options.reference_spheres.map(Count::get);
    let on = (reference.mass.kg, spheres, gravity);
    let mut state = ReferenceState::from_model(file_name(from), open, selection, on);
    if from.to_str().and_then(preset_model).is_some() {
        // It has only the bodies with spheres: warnings are about bones that it lacks.
        state.findings.retain(|one| one.severity < Severity::Warning);
    }
    state
}

/// Reads the contacts of a model as a reference, with their gravity or why it is not known.
fn reference_from_model(
    model: &Model,
    mass_of_published: MassOfPublished,
    request: &TransferRequest,
    from: &Path,
) -> Result<(Reference, Result<f64, Fault>), Fault> {
    let options = &request.reference;
    let selection = Selection { select: options.reference_select.clone(), ..Selection::default() };
    let selected = selection.apply(model).map_err(ask_for_reference_option)?;
    if request.follow.follow_bodies {
        request.answers.require_yes(misplaced_reference_spheres(model)).map_err(Fault::new)?;
    }
    let mass = match options.reference_mass {
        Some(kg) => {
            let doubt =
                implausible_mass(Input::ReferenceMass, kg.get(), MassRequest::default().bodies_kg(model));
            request.answers.require_yes(doubt).map_err(Fault::new)?;
            given_reference_mass(kg)
        }
        None => mass_of_contacts(model, &selected, mass_of_published)?,
    };
    // The option for limbs is about the model that gets the contacts; a reference on several limbs has an option of its own.
    let count = match options.reference_spheres {
        Some(count) => Ok(count.get()),
        None => LoadSharing::of(model, &selected.forces).count(None, 1.0, CountedSpheres::Reference),
    };
    // If spheres are matched, the comparison of the two models names a sphere that is missing on one side before this question is
    // asked; and the counts may cancel.
    let may_be_asked_later = request.follow.follow_bodies && request.counts.spheres.is_none();
    let (known_count, count) = match count {
        Err(fault) if may_be_asked_later => (f64::NAN, Err(name_reference_in_question(fault, from))),
        Err(fault) => return Err(fault),
        Ok(count) => (count, Ok(count)),
    };
    let mut reference = reference_of_model(model, &selected, mass, known_count)?;
    reference.name = file_name(from);
    Ok((reference, count))
}

/// The mass for which the contacts of a reference were made.
///
/// # Errors
/// It is not known.
pub(crate) fn mass_of_contacts(
    model: &Model,
    selected: &Selected,
    mass_of_published: MassOfPublished,
) -> Result<Mass, Fault> {
    let masses = MassRequest::default();
    let origin = ContactsOrigin::find(model, &selected.forces, &masses, &Stance::default())
        .map_err(ask_for_reference_option)?;
    let is_copied_body = mass_of_published == MassOfPublished::OfBodies
        && origin.known.as_ref().is_some_and(KnownContacts::is_published_under_other_body);
    if is_copied_body {
        return masses.model_mass(model);
    }
    origin.refuse_other_body(model, &masses, Input::ReferenceMass)?;
    Ok(origin.mass)
}

/// The question whether the caller accepts places of spheres that do not fit the bones of the reference. The places in the model follow
/// from them.
fn misplaced_reference_spheres(model: &Model) -> Option<Suspicion> {
    let finding = find_misplaced_spheres(model)?;
    let text = phrase![
        "the spheres of the reference do not fit its own bones, so those of the model would not fit, either: {}; \
        take the model that was scaled as {}";
        &finding.message, Input::From
    ];
    Some(Suspicion::Other { question: YesQuestion::WrongAfterwards, text })
}

/// Adds the name of the reference to a question about its spheres, because the question may be asked while another model is read.
fn name_reference_in_question(mut fault: Fault, from: &Path) -> Fault {
    if let FaultKind::MissingFact(MissingFact::SphereCount { why, .. }) = &mut fault.kind {
        *why = phrase![format!("in the reference {}, ", file_name(from)), &*why];
    }
    fault
}

/// Changes the option in a question about the choice of forces, or about their mass: the option is for the reference and not for the model.
fn ask_for_reference_option(mut fault: Fault) -> Fault {
    match &mut fault.kind {
        FaultKind::MissingFact(MissingFact::Selection { input, .. }) => *input = Input::ReferenceSelect,
        FaultKind::MissingFact(MissingFact::ContactsMass { input, .. }) => *input = Input::ReferenceMass,
        _ => {}
    }
    fault
}
