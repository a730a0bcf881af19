//! `--target-mass`: a model's own contacts at another mass.

use anyhow::{Result, bail};
use osim_patch::{Fault, MassRequest, Model, Plan, RadiusRule, Rescale, Selection, rescale};

use super::{operation, refuse_again};
use crate::args::{RescaleArgs, ScalingArgs, ViewArgs};
use crate::run::{Planner, Verb};

/// `--target-mass`.
struct Rescaling {
    scaling: ScalingArgs,
    again: bool,
    view: ViewArgs,
    options: String,
    target_mass_kg: f64,
    selection: Selection,
    masses: MassRequest,
}

/// # Errors
/// Options that leave nothing to do.
pub(crate) fn verb(args: RescaleArgs) -> Result<Verb> {
    let RescaleArgs { models, target_mass, masses, scaling, choice, output, run: _, parts } = args;
    let Some(target_mass_kg) = target_mass else {
        bail!(
            "the target is missing: say what the contacts shall stand for with --target-mass KG (see --help)"
        );
    };
    scaling.check()?;
    let options = format!("rescale {target_mass_kg:?} {masses:?} {scaling:?} {choice:?}");
    let planner = Rescaling {
        target_mass_kg,
        selection: choice.selection()?,
        masses: MassRequest { target_kg: Some(target_mass_kg), ..masses.request()? },
        scaling,
        view: ViewArgs { masses, choice, ..ViewArgs::default() },
        again: output.force || !output.in_place,
        options,
    };
    Ok(Verb { models, output, parts, planner: Box::new(planner) })
}

impl Planner for Rescaling {
    fn name(&self) -> &'static str {
        "rescale"
    }

    fn view(&self) -> ViewArgs {
        self.view.clone()
    }

    fn target_gravity_m_s2(&self) -> Option<f64> {
        self.scaling.target_gravity
    }

    fn options(&self) -> String {
        self.options.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let mut warnings = Vec::new();
        let scaling = &self.scaling;
        let operation = operation("rescale", scaling.radius);
        if matches!(scaling.radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, self.again)?;
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
