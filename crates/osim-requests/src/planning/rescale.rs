//! A model's own contacts at another mass.

use std::path::PathBuf;

use osim_model::files::Files;
use osim_model::wording::{Input, phrase};
use osim_model::{Fault, MassRequest, Model, Selection};
use osim_patch::{FOLLOWING, Plan, RadiusRule, Rescale, ScaleFile, rescale};
use serde_json::json;

use super::operation::{operation, refuse_again};
use crate::fault::{RequestError, RequestFault};
use crate::opening::scale_file;
use crate::options::{InspectionOptions, ScalingOptions, StanceOptions};
use crate::planner::{Change, Planner};
use crate::request::RescaleRequest;
use crate::value::{Acceleration, Radius};

struct Rescaling {
    target_mass_kg: f64,
    masses: MassRequest,
    selection: Selection,
    scaling: ScalingOptions,
    /// By how much bodies were scaled, where spheres follow them.
    bodies: Option<ScaleFile>,
    reads: Vec<PathBuf>,
    may_repeat: bool,
    inspection: InspectionOptions,
    settings: String,
}

impl RescaleRequest {
    /// Checks the request and reads the ScaleSet where one is named, for all of its models.
    ///
    /// # Errors
    /// The target is missing, the options leave nothing to do, or the ScaleSet cannot be read.
    pub fn prepare(self, files: &dyn Files) -> Result<Change, RequestError> {
        let bodies = self.body_scale_file.as_deref().map(|path| scale_file(path, files)).transpose()?;
        Ok(self.with_bodies(bodies)?)
    }

    /// The same with what the ScaleSet says.
    ///
    /// # Errors
    /// The target is missing, or the options leave nothing to do.
    pub(crate) fn with_bodies(self, bodies: Option<ScaleFile>) -> Result<Change, RequestFault> {
        let Self { models, target_mass, masses, scaling, body_scale_file, choice, output, run: _, set_files } =
            self;
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
        // Without a ScaleSet as it always was, so that earlier runs can be resumed.
        let mut settings = json!(["rescale", target, masses, scaling, choice]).to_string();
        settings.extend(body_scale_file.iter().map(|path| path.to_string_lossy()));
        if bodies.is_some() && masses.contacts_mass.is_none() {
            // What the bodies weigh now, the contacts were not made for.
            let message = phrase![
                Input::BodyScaleFile,
                " is for a model that OpenSim has scaled: say what its contacts were made for with ",
                Input::ContactsMass.like("KG"),
            ];
            return Err(RequestFault::refused(Input::ContactsMass, message));
        }
        let planner = Rescaling {
            target_mass_kg: target.get(),
            masses: MassRequest { target_mass_kg: Some(target.get()), ..masses.request() },
            selection: choice.selection(),
            scaling,
            bodies,
            reads: body_scale_file.into_iter().collect(),
            may_repeat: output.may_repeat(),
            inspection: InspectionOptions::new(StanceOptions::default(), masses, choice, set_files.clone()),
            settings,
        };
        Ok(Change::new(models, output, set_files, planner))
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

    fn reads(&self) -> Vec<PathBuf> {
        self.reads.clone()
    }

    fn settings(&self) -> String {
        self.settings.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let scaling = &self.scaling;
        let radius = scaling.radius.map(Radius::rule);
        let verb = if self.bodies.is_some() { FOLLOWING } else { "rescale" };
        let operation = operation(verb, radius);
        if matches!(radius, Some(RadiusRule::Factor(_))) || self.bodies.is_some() {
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
        wanted.bodies.clone_from(&self.bodies);
        let mut plan = rescale(model, &selected, &wanted)?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}
