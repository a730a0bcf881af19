//! What each changing verb plans for a model.

use std::path::Path;

use anyhow::{Result, bail};
use osim_patch::{
    Fault, FaultKind, Mass, MassRequest, MassSource, Model, Plan, RadiusRule, Reference, Rescale, Selection,
    Transfer, reference_of_model, rescale, transfer,
};

use crate::args::{PartArgs, RescaleArgs, TransferArgs};
use crate::change::Planner;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::sources::Source;

/// `--target-mass`.
pub(crate) struct RescaleVerb<'v> {
    args: &'v RescaleArgs,
    target_mass_kg: f64,
    selection: Selection,
    masses: MassRequest,
}

impl<'v> RescaleVerb<'v> {
    pub(crate) fn new(args: &'v RescaleArgs, target_mass_kg: f64) -> Result<Self> {
        let masses = MassRequest { target_kg: Some(target_mass_kg), ..args.masses.request()? };
        Ok(Self { args, target_mass_kg, selection: args.choice.selection()?, masses })
    }
}

impl Planner for RescaleVerb<'_> {
    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let mut warnings = Vec::new();
        let contacts_mass = self.masses.of_contacts(model, &mut warnings)?;
        let scaling = &self.args.scaling;
        let wanted = Rescale {
            target_mass_kg: self.target_mass_kg,
            contacts_mass,
            radius: scaling.radius.unwrap_or(RadiusRule::Isometric),
            properties: scaling.properties(),
            dissipation_by: scaling.dissipation(),
            target_gravity_m_s2: scaling.target_gravity,
        };
        let mut plan = rescale(model, &selected, &wanted)?;
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}

/// `transfer --from`.
pub(crate) struct TransferVerb<'v> {
    args: &'v TransferArgs,
    selection: Selection,
    masses: MassRequest,
    reference: Reference,
}

impl<'v> TransferVerb<'v> {
    /// Reads the reference once, for all models.
    ///
    /// # Errors
    /// The reference is no preset and no file (wrong usage), or a model that cannot be a reference.
    pub(crate) fn new(args: &'v TransferArgs) -> Result<Result<Self, Failure>> {
        if args.masses.contacts_mass.is_some() {
            bail!(
                "--contacts-mass says nothing here: the reference's mass is --reference-mass, this model's --mass"
            );
        }
        let selection = args.choice.selection()?;
        let masses = args.masses.request()?;
        let reference = match preset(args)? {
            Some(reference) => Ok(reference),
            None => reference_from_file(args),
        };
        Ok(reference.map(|mut reference| {
            let given = &args.reference;
            reference.gravity_m_s2 = given.reference_gravity.or(reference.gravity_m_s2);
            Self { args, selection, masses, reference }
        }))
    }
}

fn preset(args: &TransferArgs) -> Result<Option<Reference>> {
    let name = args.from.to_string_lossy();
    if let Some(preset) = contact_scaling::preset(&name) {
        let mut reference = Reference::from(&preset);
        if let Some(kg) = args.reference.reference_mass {
            reference.mass = reference_mass(kg);
        }
        reference.sphere_count = args.reference.reference_spheres.unwrap_or(reference.sphere_count);
        return Ok(Some(reference));
    }
    if !args.from.exists() {
        let names: Vec<_> = contact_scaling::preset_names().collect();
        bail!(
            "--from '{name}': there is no such file and no such preset, expected a model or one of: {}",
            names.join(", ")
        );
    }
    Ok(None)
}

fn reference_mass(kg: f64) -> Mass {
    Mass { kg, source: MassSource::Reference, told_by: "--reference-mass".to_owned() }
}

fn reference_from_file(args: &TransferArgs) -> Result<Reference, Failure> {
    let source = Source { path: args.from.clone(), folder: None };
    let loaded = Loaded::read(&source, &PartArgs { geometry: None, model: None })?;
    loaded.with_model(|model| reference_from_model(model, args).map_err(|fault| loaded.failure(fault)))
}

fn reference_from_model(model: &Model<'_, '_>, args: &TransferArgs) -> Result<Reference, Fault> {
    let selected = Selection::default().apply(model)?;
    let mass = match args.reference.reference_mass {
        Some(kg) => reference_mass(kg),
        None => MassRequest::default().of_contacts(model, &mut Vec::new())?,
    };
    // --stance-limbs is about this model; a reference that stands on several limbs says --reference-spheres.
    let count = match args.reference.reference_spheres {
        Some(count) => count,
        None => sphere_count(model, &selected.forces, 1.0, "--reference-spheres")?,
    };
    let mut reference = reference_of_model(model, &selected, mass, count)?;
    reference.name =
        args.from.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    Ok(reference)
}

/// n as found per limb times the stance limbs, or a question.
fn sphere_count(
    model: &Model<'_, '_>,
    forces: &[usize],
    stance_limbs: f64,
    option: &str,
) -> Result<f64, Fault> {
    let limbs = model.limbs(forces);
    match limbs.spheres_per_limb() {
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        Ok(count) => Ok(count as f64 * stance_limbs),
        Err(why) => Err(Fault::new(FaultKind::NeedsAnswer {
            code: "sphere-count",
            question: format!("how many spheres share the body weight is not known: {why}"),
            way_out: format!("say it with {option} N"),
        })),
    }
}

impl Planner for TransferVerb<'_> {
    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let sphere_count = match self.args.counts.spheres {
            Some(count) => count,
            None => sphere_count(model, &selected.forces, self.args.counts.stance_limbs, "--spheres")?,
        };
        let scaling = &self.args.scaling;
        transfer(
            model,
            &selected,
            &Transfer {
                reference: self.reference.clone(),
                reference_sphere: self.args.reference.reference_sphere.clone(),
                mass: self.masses.of_model(model)?,
                sphere_count,
                radius: scaling.radius.unwrap_or(RadiusRule::Keep),
                properties: scaling.properties(),
                dissipation_by: scaling.dissipation(),
                target_gravity_m_s2: scaling.target_gravity,
            },
        )
    }
}

/// `true` for a path that a model may have.
pub(crate) fn looks_like_verb(path: &Path) -> bool {
    let text = path.to_string_lossy();
    !path.exists() && !text.contains(['.', '/', '\\']) && text != "-"
}
