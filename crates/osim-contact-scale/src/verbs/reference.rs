//! Where the contacts of a transfer come from: a preset, or a model with its bones.

use std::path::Path;

use anyhow::{Result, bail};
use osim_patch::{
    Anatomy, Document, Fault, FaultKind, Mass, MassRequest, MassSource, Model, Reference, ScaleFile,
    Selection, reference_of_model,
};

use super::sphere_count;
use crate::args::{PartArgs, TransferArgs, set_of};
use crate::failure::Failure;
use crate::load::{Loaded, read};
use crate::presets;
use crate::sources::Source;

/// What spheres follow from.
pub(super) struct Generic {
    pub(super) anatomy: Anatomy,
    pub(super) file: Option<ScaleFile>,
    /// What to ask about the reference's sphere count, once its spheres are matched.
    pub(super) count_unknown: Option<Fault>,
}

pub(super) fn preset(args: &TransferArgs) -> Result<Option<Reference>> {
    if let Some(preset) = presets::find(&args.from, args.presets.as_deref())? {
        let mut reference = Reference::from(&preset);
        if let Some(kg) = args.reference.reference_mass {
            reference.mass = reference_mass(kg);
        }
        reference.sphere_count = args.reference.reference_spheres.unwrap_or(reference.sphere_count);
        return Ok(Some(reference));
    }
    if !args.from.exists() {
        bail!(
            "--from '{}': there is no such file and no such preset, expected a model or one of: {}",
            args.from.display(),
            presets::names(args.presets.as_deref())
        );
    }
    Ok(None)
}

fn reference_mass(kg: f64) -> Mass {
    Mass { kg, source: MassSource::Reference, told_by: "--reference-mass".to_owned() }
}

pub(super) fn reference_from_file(args: &TransferArgs) -> Result<(Reference, Option<Generic>), Failure> {
    let source = Source { path: args.from.clone(), folder: None };
    let loaded = Loaded::read(&source, &PartArgs { geometry: None, model: None })?;
    let reference = loaded.with_model(|model| {
        let (reference, count_unknown) =
            reference_from_model(model, args).map_err(|fault| loaded.failure(fault))?;
        if !args.follow.follow_bodies {
            return Ok((reference, None));
        }
        let anatomy = Anatomy::of(model).map_err(|fault| loaded.failure(fault))?;
        let file = args.follow.body_scale_file.as_deref().map(scale_file).transpose()?;
        Ok((reference, Some(Generic { anatomy, file, count_unknown })))
    });
    reference.map_err(|failure| match failure.code {
        // The usual way out, --geometry, is about the model that gets the contacts.
        "incomplete-set" => Failure {
            message: "a set that stands alone cannot be a reference: name the model it belongs to".to_owned(),
            ..failure
        },
        _ => failure,
    })
}

/// Reads the Scale Tool's applied factors.
pub(crate) fn scale_file(path: &Path) -> Result<ScaleFile, Failure> {
    let shown = path.display().to_string();
    let bytes = read(path).map_err(|error| Failure::outside(&shown, "unreadable", &error))?;
    let document = Document::parse(&bytes).map_err(|fault| Failure::of_fault(&shown, fault, &bytes))?;
    ScaleFile::read(&document).map_err(|fault| Failure::of_fault(&shown, fault, &bytes))
}

fn reference_from_model(
    model: &Model,
    args: &TransferArgs,
) -> Result<(Reference, Option<Fault>), Fault> {
    let select = set_of(&args.reference.reference_select).unwrap_or_default();
    let selection = Selection { select, ..Selection::default() };
    let selected = selection.apply(model).map_err(about_reference)?;
    let mass = match args.reference.reference_mass {
        Some(kg) => reference_mass(kg),
        None => MassRequest::default().of_contacts(model, &mut Vec::new())?,
    };
    // --stance-limbs is about this model; a reference that stands on several limbs says --reference-spheres.
    let (count, unknown) = match args.reference.reference_spheres {
        Some(count) => (count, None),
        None => match sphere_count(model, 1.0, "--reference-spheres") {
            Ok(count) => (count, None),
            // A sphere that is missing on one side is named first, by comparing the two models.
            Err(fault) if args.follow.follow_bodies => (f64::NAN, Some(fault)),
            Err(fault) => return Err(fault),
        },
    };
    let mut reference = reference_of_model(model, &selected, mass, count)?;
    reference.name =
        args.from.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    Ok((reference, unknown))
}

/// Ways out that are about the reference, not about the model that gets its contacts.
fn about_reference(mut fault: Fault) -> Fault {
    if let FaultKind::NeedsAnswer { way_out, .. } = &mut fault.kind {
        *way_out = way_out.replace("--select", "--reference-select");
    }
    fault
}
