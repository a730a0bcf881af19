//! `--target-mass`: a model's own contacts at another mass.

use anyhow::Result;
use osim_patch::{Fault, MassRequest, Model, Plan, RadiusRule, Rescale, Selection, rescale};

use super::{operation, refuse_again};
use crate::args::RescaleArgs;
use crate::change::Planner;

/// `--target-mass`.
pub(crate) struct RescaleVerb<'v> {
    args: &'v RescaleArgs,
    target_mass_kg: f64,
    selection: Selection,
    masses: MassRequest,
}

impl<'v> RescaleVerb<'v> {
    pub(crate) fn new(args: &'v RescaleArgs, target_mass_kg: f64) -> Result<Self> {
        args.scaling.check()?;
        let masses = MassRequest { target_kg: Some(target_mass_kg), ..args.masses.request()? };
        Ok(Self { args, target_mass_kg, selection: args.choice.selection()?, masses })
    }
}

impl Planner for RescaleVerb<'_> {
    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let mut warnings = Vec::new();
        let scaling = &self.args.scaling;
        let operation = operation("rescale", scaling.radius);
        if matches!(scaling.radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, &self.args.output)?;
        }
        let contacts_mass = self.masses.of_contacts(model, &mut warnings)?;
        let wanted = Rescale {
            target_mass_kg: self.target_mass_kg,
            contacts_mass,
            radius: scaling.radius.unwrap_or(RadiusRule::Isometric),
            properties: scaling.properties(),
            dissipation_by: scaling.dissipation(),
            target_gravity_m_s2: scaling.target_gravity,
            contacts_gravity_m_s2: scaling.contacts_gravity,
            level: scaling.level_axis(model.gravity_m_s2),
        };
        let mut plan = rescale(model, &selected, &wanted)?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}
