//! Where the contacts of a transfer come from: a preset, or a model with its bones.

use std::path::Path;

use osim_inspect::LoadSharing;
use osim_model::files::{Failure, Files};
use osim_model::wording::{Input, phrase};
use osim_model::{
    Anatomy, CountOf, Fault, FaultKind, Mass, MassRequest, MassSource, Model, Needed, Selection,
};
use osim_patch::{Reference, ScaleFile, reference_of_model};

use crate::fault::RequestFault;
use crate::opening::{open, scale_file};
use crate::planner::file_name;
use crate::presets::{find_preset, preset_names};
use crate::request::TransferRequest;
use crate::value::{Count, Kilograms};

/// What spheres follow from.
pub(super) struct Generic {
    pub(super) anatomy: Anatomy,
    pub(super) file: Option<ScaleFile>,
    /// What to ask about the reference's sphere count, once its spheres are matched.
    pub(super) count_unknown: Option<Fault>,
}

/// The preset that `from` names, if it names one.
///
/// # Errors
/// It names neither a preset nor a file.
pub(super) fn preset(
    request: &TransferRequest,
    from: &Path,
    files: &dyn Files,
) -> Result<Option<Reference>, RequestFault> {
    let own = request.presets.as_deref();
    if let Some(preset) = find_preset(from, own, files)? {
        let mut reference = Reference::from(&preset);
        if let Some(kg) = request.reference.reference_mass {
            reference.mass = reference_mass(kg);
        }
        let count = request.reference.reference_spheres.map(Count::get);
        reference.sphere_count = count.unwrap_or(reference.sphere_count);
        return Ok(Some(reference));
    }
    if files.exists(from) {
        return Ok(None);
    }
    let message = phrase![
        Input::From,
        format!(
            " '{}': there is no such file and no such preset, expected a model or one of: {}",
            from.display(),
            preset_names(own, files)
        ),
    ];
    Err(RequestFault::refused(Input::From, message))
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
) -> Result<(Reference, Option<Generic>), Failure> {
    let read = || {
        let open = open(from, files)?;
        let (reference, count_unknown) =
            reference_from_model(&open.model, request, from).map_err(|fault| open.failure(fault))?;
        if !request.follow.follow_bodies {
            return Ok((reference, None));
        }
        let anatomy = Anatomy::of(&open.model).map_err(|fault| open.failure(fault))?;
        let file =
            request.follow.body_scale_file.as_deref().map(|path| scale_file(path, files)).transpose()?;
        Ok((reference, Some(Generic { anatomy, file, count_unknown })))
    };
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

fn reference_from_model(
    model: &Model,
    request: &TransferRequest,
    from: &Path,
) -> Result<(Reference, Option<Fault>), Fault> {
    let options = &request.reference;
    let selection = Selection { select: options.reference_select.clone(), ..Selection::default() };
    let selected = selection.apply(model).map_err(about_reference)?;
    let mass = match options.reference_mass {
        Some(kg) => reference_mass(kg),
        None => MassRequest::default().of_contacts(model)?.0,
    };
    // How many limbs stand is about the model that gets the contacts; a reference on several limbs says its own count.
    let (count, unknown) = match options.reference_spheres {
        Some(count) => (count.get(), None),
        None => match LoadSharing::of(model, &selected.forces).count(None, 1.0, CountOf::Reference) {
            Ok(count) => (count, None),
            // A sphere that is missing on one side is named first, by comparing the two models.
            Err(fault) if request.follow.follow_bodies => (f64::NAN, Some(fault)),
            Err(fault) => return Err(fault),
        },
    };
    let mut reference = reference_of_model(model, &selected, mass, count)?;
    reference.name = file_name(from);
    Ok((reference, unknown))
}

/// A question about the forces of the reference is answered by another field than one about the model's.
fn about_reference(mut fault: Fault) -> Fault {
    if let FaultKind::Needed(Needed::Selection { input, .. }) = &mut fault.kind {
        *input = Input::ReferenceSelect;
    }
    fault
}
