//! Both states of a model, for drawing.

use osim_inspect::InspectOptions;
use osim_inspect::series::Body;
use osim_model::Model;
use osim_model::files::OpenModel;
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
    /// The model as it will be; `None` where nothing changes.
    pub changed: Option<&'s Model>,
}

impl States<'_> {
    /// What is drawn of both states, without their figures and findings: for pictures that follow a slider.
    #[must_use]
    pub fn bodies(self) -> Vec<Body> {
        let before = InspectOptions::from(&self.planner.inspection());
        let old = body("before", &before, &self.opened.model, self.opened);
        let new = self
            .changed
            .and_then(|changed| body("after", &self.options_after(&before), changed, self.opened));
        old.into_iter().chain(new).collect()
    }

    /// The new model in space; `None` where nothing changes.
    #[must_use]
    pub fn scene(self) -> Option<Scene> {
        let before = InspectOptions::from(&self.planner.inspection());
        Some(Scene::of(self.changed?, &self.options_after(&before)))
    }

    /// How the body falls on the contacts as they are, and on the new ones: the same body on both, that which the new ones are for.
    #[must_use]
    pub fn falls(self) -> Vec<Fall> {
        let Some(changed) = self.changed else { return Vec::new() };
        let before = InspectOptions::from(&self.planner.inspection());
        let after = self.options_after(&before);
        let mut heavier = before;
        heavier.masses.model_kg = after.masses.model_kg;
        heavier.stance.gravity_m_s2 = after.stance.gravity_m_s2;
        let old = body("before", &heavier, &self.opened.model, self.opened);
        let new = body("after", &after, changed, self.opened);
        Fall::all(&old.into_iter().chain(new).collect::<Vec<Body>>())
    }

    fn options_after(self, before: &InspectOptions) -> InspectOptions {
        let weighs = before.masses.of_model(&self.opened.model).ok();
        options_after(self.planner.aims(), before, self.plan, weighs.map(|mass| mass.kg))
    }
}

/// What is drawn of `model`, a state of what was `opened`.
pub(crate) fn body(name: &str, options: &InspectOptions, model: &Model, opened: &OpenModel) -> Option<Body> {
    Body::inspected(name.to_owned(), model, options, &|fault| opened.failure(fault)).ok()
}
