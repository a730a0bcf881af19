//! Both states of a model, for drawing.

use osim_inspect::InspectOptions;
use osim_inspect::series::Body;
use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_model::same_mass;
use osim_patch::Plan;

use crate::Planner;

/// A model for which a change was planned.
#[derive(Clone, Copy)]
pub struct States<'s> {
    /// What planned it.
    pub planner: &'s dyn Planner,
    /// The model as it is.
    pub opened: &'s OpenModel,
    /// What changes.
    pub plan: &'s Plan,
}

impl States<'_> {
    /// What is drawn of both states, without their figures and findings: for pictures that follow a slider. `changed` gives the
    /// files of the model as they will be; it is asked only where something changes.
    ///
    /// # Errors
    /// The new model cannot be read, which would be a defect.
    pub fn bodies(self, changed: impl FnOnce() -> ModelFiles) -> Result<Vec<Body>, Failure> {
        let before = InspectOptions::from(&self.planner.inspection());
        let mut bodies: Vec<Body> = body("before", &before, self.opened).into_iter().collect();
        if !self.plan.is_empty() {
            let weighs_kg = bodies.first().and_then(|body| body.weight().ok()).map(|weight| weight.mass_kg);
            let after = options_after(self.planner, &before, self.plan, weighs_kg);
            bodies.extend(body("after", &after, &changed().open()?));
        }
        Ok(bodies)
    }
}

/// What is drawn of a state.
pub(crate) fn body(name: &str, options: &InspectOptions, opened: &OpenModel) -> Option<Body> {
    Body::inspected(name.to_owned(), &opened.model, options, &|fault| opened.failure(fault)).ok()
}

/// How the new model is inspected: its contacts carry the body that they were scaled for.
pub(crate) fn options_after(
    planner: &dyn Planner,
    before: &InspectOptions,
    plan: &Plan,
    weighs_kg: Option<f64>,
) -> InspectOptions {
    let mut options = before.clone();
    let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
    // The note has it; without one the caller has to give it.
    options.masses.contacts_mass_kg = target_mass_kg.filter(|_| plan.note().is_none());
    if let Some(target_mass_kg) = target_mass_kg.filter(|_| planner.name() == "rescale")
        && weighs_kg.is_none_or(|weighs| !same_mass(weighs, target_mass_kg))
    {
        options.masses.model_kg = Some(target_mass_kg);
    }
    // A gravity that figures are asked for (as in a design) is that of both states.
    options.stance.gravity_m_s2 = planner.target_gravity_m_s2().or(options.stance.gravity_m_s2);
    options
}
