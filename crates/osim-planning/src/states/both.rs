//! Both states of a model, for drawing.

use osim_inspect::InspectOptions;
use osim_inspect::series::Body;
use osim_model::Model;
use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_patch::Plan;

use crate::Planner;
use crate::afterwards::options_after;
use crate::scene::{Fall, Scene};

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
            bodies.extend(body("after", &self.options_after(&before), &changed().open()?));
        }
        Ok(bodies)
    }

    /// The new model in space; `None` where nothing changes.
    ///
    /// # Errors
    /// The new model cannot be read, which would be a defect.
    pub fn scene(self) -> Result<Option<Scene>, Failure> {
        if self.plan.is_empty() {
            return Ok(None);
        }
        let before = InspectOptions::from(&self.planner.inspection());
        Ok(Some(Scene::of(&self.changed()?, &self.options_after(&before))))
    }

    /// How the body falls on the contacts as they are, and on the new ones: the same body on both, that which the new ones are for.
    ///
    /// # Errors
    /// The new model cannot be read, which would be a defect.
    pub fn falls(self) -> Result<Vec<Fall>, Failure> {
        if self.plan.is_empty() {
            return Ok(Vec::new());
        }
        let before = InspectOptions::from(&self.planner.inspection());
        let after = self.options_after(&before);
        let mut heavier = before;
        heavier.masses.model_kg = after.masses.model_kg;
        heavier.stance.gravity_m_s2 = after.stance.gravity_m_s2;
        let fault = |fault| self.opened.failure(fault);
        let old = Body::inspected("before".to_owned(), &self.opened.model, &heavier, &fault).ok();
        let new = Body::inspected("after".to_owned(), &self.changed()?, &after, &fault).ok();
        Ok(Fall::all(&old.into_iter().chain(new).collect::<Vec<Body>>()))
    }

    fn changed(self) -> Result<Model, Failure> {
        self.plan.changed(&self.opened.model).map_err(|fault| self.opened.failure(fault))
    }

    fn options_after(self, before: &InspectOptions) -> InspectOptions {
        let weighs = before.masses.of_model(&self.opened.model).ok();
        options_after(self.planner.aims(), before, self.plan, weighs.map(|mass| mass.kg))
    }
}

/// What is drawn of a state.
pub(crate) fn body(name: &str, options: &InspectOptions, opened: &OpenModel) -> Option<Body> {
    Body::inspected(name.to_owned(), &opened.model, options, &|fault| opened.failure(fault)).ok()
}
