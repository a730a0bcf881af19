//! A model's own contacts at another mass.

use osim_model::wording::{Input, phrase};
use osim_model::{Fault, MassRequest, Model, Selection};
use osim_patch::{Plan, RadiusRule, Rescale, rescale};
use serde_json::json;

use super::asking::Asking;
use super::operation::{operation, refuse_again};
use crate::fault::RequestFault;
use crate::options::{InspectionOptions, ScalingOptions, StanceOptions};
use crate::planner::{Change, Planner};
use crate::request::RescaleRequest;
use crate::value::{Acceleration, Radius};

struct Rescaling {
    target_mass_kg: f64,
    masses: MassRequest,
    selection: Selection,
    scaling: ScalingOptions,
    may_repeat: bool,
    inspection: InspectionOptions,
    settings: String,
}

impl RescaleRequest {
    /// Checks the request, for all of its models.
    ///
    /// # Errors
    /// The target is missing, or the options leave nothing to do.
    pub fn prepare(self) -> Result<Change, RequestFault> {
        let Self { models, target_mass, masses, scaling, choice, output, run: _, answers, set_files } = self;
        let Some(target) = target_mass else {
            return Err(RequestFault::refused(
                Input::TargetMass,
                phrase![
                    "the target is missing: say which mass the contacts should be made for with ",
                    Input::TargetMass.like("KG"),
                ],
            ));
        };
        scaling.check()?;
        let settings = json!(["rescale", target, masses, scaling, choice]).to_string();
        let planner = Rescaling {
            target_mass_kg: target.get(),
            masses: MassRequest { target_mass_kg: Some(target.get()), ..masses.request() },
            selection: choice.selection(),
            scaling,
            may_repeat: output.may_repeat(),
            inspection: InspectionOptions::new(StanceOptions::default(), masses, choice, set_files.clone()),
            settings,
        };
        let asking = Asking { masses: planner.masses.clone(), answers, planner };
        Ok(Change::new(models, output, set_files, asking))
    }
}

impl Planner for Rescaling {
    fn name(&self) -> &'static str {
        "rescale"
    }

    fn inspection(&self) -> InspectionOptions {
        self.inspection.clone()
    }

    fn target_gravity_m_s2(&self) -> Option<f64> {
        self.scaling.target_gravity.map(Acceleration::get)
    }

    fn settings(&self) -> String {
        self.settings.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let scaling = &self.scaling;
        let radius = scaling.radius.map(Radius::rule);
        let operation = operation("rescale", radius);
        if matches!(radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, self.may_repeat)?;
        }
        let (contacts_mass, mut warnings) = self.masses.of_contacts(model)?;
        let mut wanted = Rescale::new(self.target_mass_kg, contacts_mass);
        wanted.radius = radius.unwrap_or(RadiusRule::Isometric);
        wanted.properties = scaling.properties();
        wanted.dissipation_by = scaling.dissipation();
        wanted.target_gravity_m_s2 = scaling.target_gravity.map(Acceleration::get);
        wanted.contacts_gravity_m_s2 = scaling.contacts_gravity.map(Acceleration::get);
        wanted.level = scaling.level_axis(model.gravity_m_s2);
        let mut plan = rescale(model, &selected, &wanted)?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}
