//! Both states of a model, for drawing.

use osim_inspect::InspectOptions;
use osim_inspect::series::Body;
use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_patch::Plan;

use crate::Planner;
use crate::afterwards::options_after;

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
            let after = options_after(self.planner.aims(), &before, self.plan, weighs_kg);
            bodies.extend(body("after", &after, &changed().open()?));
        }
        Ok(bodies)
    }
}

/// What is drawn of a state.
pub(crate) fn body(name: &str, options: &InspectOptions, opened: &OpenModel) -> Option<Body> {
    Body::inspected(name.to_owned(), &opened.model, options, &|fault| opened.failure(fault)).ok()
}
