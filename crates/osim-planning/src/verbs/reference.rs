//! Where the contacts of a transfer come from: a preset, or a model with its bones.

use std::collections::BTreeSet;
use std::path::Path;

use contact_scaling::Preset;
use osim_inspect::{LoadSharing, ReferenceState};
use osim_model::compare::ScaleFile;
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Input, phrase};
use osim_model::{
    Anatomy, CountedSpheres, Fault, FaultKind, Mass, MassRequest, MassSource, Model, Needed, Selection,
    implausible_mass,
};
use osim_patch::{Reference, reference_of_model};
use osim_requests::{Acceleration, Count, Kilograms, TransferRequest};

use crate::opening::{open, scale_file};
use crate::planner::file_name;
use crate::remarks::refuse_known;

/// Which mass counts for published contacts of a reference that were made for another one than its bodies weigh.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum KnownMass {
    /// Nobody but the caller knows.
    Asked,
    /// The mass of the bodies.
    AsBodies,
}

/// What spheres follow from.
#[derive(Clone)]
pub(super) struct Generic {
    pub(super) anatomy: Anatomy,
    pub(super) file: Option<ScaleFile>,
    /// Its spheres that share the weight, or what to ask about them once spheres are matched.
    pub(super) sphere_count: Result<f64, Fault>,
    /// Names of its spheres that can stand.
    standing: BTreeSet<String>,
}

impl Generic {
    /// With the spheres of `model`, where they are in `anatomy`.
    pub(super) fn with_contacts(&self, anatomy: Anatomy, model: &Model) -> Self {
        Self { anatomy, file: None, sphere_count: self.sphere_count.clone(), standing: standing(model) }
    }

    /// Whether each sphere of `model` that can stand has its own here, and the other way round.
    pub(super) fn stands_like(&self, model: &Model) -> bool {
        standing(model) == self.standing
    }
}

fn standing(model: &Model) -> BTreeSet<String> {
    let spheres = model.loaded_spheres(&model.force_ids()).into_iter();
    spheres.filter_map(|sphere| Some(model.sphere(sphere)?.name.clone())).collect()
}

/// The numbers of a preset, with the mass and the spheres that the request says.
pub(super) fn of_preset(request: &TransferRequest, preset: &Preset) -> (Reference, ReferenceState) {
    let mut reference = Reference::from(preset);
    if let Some(kg) = request.reference.reference_mass {
        reference.mass = reference_mass(kg);
    }
    let count = request.reference.reference_spheres.map(Count::get);
    reference.sphere_count = count.unwrap_or(reference.sphere_count);
    let gravity = request.reference.reference_gravity.map(Acceleration::get);
    let state = ReferenceState::from_preset(preset, reference.mass.kg, reference.sphere_count, gravity);
    (reference, state)
}

fn reference_mass(kg: Kilograms) -> Mass {
    Mass { kg: kg.get(), source: MassSource::ReferenceMass }
}

/// The contacts of the model that `from` names, and its bones where spheres follow their bodies.
///
/// # Errors
/// It cannot be read, or cannot be a reference.
pub(super) fn reference_from_file(
    request: &TransferRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<(Reference, ReferenceState, Option<Generic>), Failure> {
    // A scaled copy of the reference keeps what its contacts are to its bodies.
    let known = if request.follow.follow_bodies { KnownMass::AsBodies } else { KnownMass::Asked };
    let read = || of_opened(request, from, &open(from, files)?, known, files);
    read().map_err(|failure: Failure| match failure.code {
        // The usual way out is about the model that gets the contacts.
        "incomplete-set" => {
            let mut failure = failure;
            failure.message =
                "a set that stands alone cannot be a reference: name the model it belongs to".into();
            failure
        }
        _ => failure,
    })
}

/// The reference in a model that was opened, called `from`.
///
/// # Errors
/// It cannot be a reference, or the Scale Tool's file cannot be read.
pub(super) fn of_opened(
    request: &TransferRequest,
    from: &Path,
    open: &OpenModel,
    known: KnownMass,
    files: &dyn Files,
) -> Result<(Reference, ReferenceState, Option<Generic>), Failure> {
    let (reference, sphere_count) =
        reference_from_model(&open.model, known, request, from).map_err(|fault| open.failure(fault))?;
    let state = state(request, from, open, &reference);
    if !request.follow.follow_bodies {
        return Ok((reference, state, None));
    }
    let anatomy = Anatomy::of(&open.model).map_err(|fault| open.failure(fault))?;
    let file = request.follow.body_scale_file.as_deref().map(|path| scale_file(path, files)).transpose()?;
    let standing = standing(&open.model);
    Ok((reference, state, Some(Generic { anatomy, file, sphere_count, standing })))
}

fn state(request: &TransferRequest, from: &Path, open: &OpenModel, reference: &Reference) -> ReferenceState {
    let options = &request.reference;
    let selection = Selection { select: options.reference_select.clone(), ..Selection::default() };
    let gravity = options.reference_gravity.map(Acceleration::get).or(reference.gravity_m_s2);
    let spheres = options.reference_spheres.map(Count::get);
    ReferenceState::from_model(file_name(from), open, selection, (reference.mass.kg, spheres, gravity))
}

fn reference_from_model(
    model: &Model,
    known: KnownMass,
    request: &TransferRequest,
    from: &Path,
) -> Result<(Reference, Result<f64, Fault>), Fault> {
    let options = &request.reference;
    let selection = Selection { select: options.reference_select.clone(), ..Selection::default() };
    let selected = selection.apply(model).map_err(about_reference)?;
    let mass = match options.reference_mass {
        Some(kg) => {
            let asks =
                implausible_mass(Input::ReferenceMass, kg.get(), MassRequest::default().bodies_kg(model));
            request.answers.ask(asks).map_err(Fault::new)?;
            reference_mass(kg)
        }
        None => {
            let (mass, _) = MassRequest::default().contacts_mass(model).map_err(about_reference)?;
            if known == KnownMass::Asked {
                refuse_known(model, &selected, &mass, Input::ReferenceMass)?;
            }
            mass
        }
    };
    // How many limbs stand is about the model that gets the contacts; a reference on several limbs says its own count.
    let count = match options.reference_spheres {
        Some(count) => Ok(count.get()),
        None => LoadSharing::of(model, &selected.forces).count(None, 1.0, CountedSpheres::Reference),
    };
    // Where spheres are matched, a sphere that is missing on one side is named first, by comparing the two models; and counts
    // may cancel.
    let may_wait = request.follow.follow_bodies && request.counts.spheres.is_none();
    let (known, count) = match count {
        Err(fault) if may_wait => (f64::NAN, Err(of_reference(fault, from))),
        Err(fault) => return Err(fault),
        Ok(count) => (count, Ok(count)),
    };
    let mut reference = reference_of_model(model, &selected, mass, known)?;
    reference.name = file_name(from);
    Ok((reference, count))
}

/// A question about the spheres of the reference names it: it may be asked when the model is read.
fn of_reference(mut fault: Fault, from: &Path) -> Fault {
    if let FaultKind::Needed(Needed::SphereCount { why, .. }) = &mut fault.kind {
        *why = phrase![format!("in the reference {}, ", file_name(from)), &*why];
    }
    fault
}

/// A question about the forces of the reference, or about their mass, is answered by another field than one about the model's.
fn about_reference(mut fault: Fault) -> Fault {
    match &mut fault.kind {
        FaultKind::Needed(Needed::Selection { input, .. }) => *input = Input::ReferenceSelect,
        FaultKind::Needed(Needed::ContactsMass { input, .. }) => *input = Input::ReferenceMass,
        _ => {}
    }
    fault
}
