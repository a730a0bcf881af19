//! Inspects and checks a model before and after a planned change: figures, findings and feet, before anything is written.

use osim_inspect::series::ContactBody;
use osim_inspect::{CheckResult, Figures, InspectOptions, Inspection, ReferenceState};
use osim_model::Model;
use osim_model::files::{Failure, ModelFiles, OpenModel};
use osim_patch::Plan;
use osim_requests::spell::FrontEnd;

use crate::scene::{BodyFall, Scene};
use crate::{ModelFeet, MotionRemark, MotionResult, PreparedChange, check_with_remedies};

/// Inspections and checks of a model before and after a planned change, with texts in the words of a front end.
pub struct BeforeAfter {
    /// Inspection and check of the old model.
    pub before: (Inspection, CheckResult),
    /// Figures of the old contacts under the new weight, if the weight changes.
    pub before_under_new_weight: Option<Figures>,
    /// Inspection and check of the new model; `None` if nothing changes.
    pub after: Option<(Inspection, CheckResult)>,
    /// The model before and after the change, for figures of curves.
    pub bodies: Vec<ContactBody>,
    /// The feet before and after the change, without their bones, if the caller asked for feet. If the spheres stay at their places, only
    /// the feet before the change.
    pub feet: Vec<ModelFeet>,
    /// The model or preset that the contacts come from, if they come from another body.
    pub reference: Option<ReferenceState>,
    /// The new contacts along the recording that they were fitted to, if there is one.
    pub recording: Option<Box<(MotionResult, Vec<MotionRemark>)>>,
    /// The gravity that the contacts are scaled to, m/s², if it differs from the gravity of the model.
    pub target_gravity_m_s2: Option<f64>,
}

impl BeforeAfter {
    /// A model before and after the change `plan`, which `change` has made. `changed` returns the new files; it is called only if something
    /// changes. `dialect` spells the messages, and `with_feet` says whether feet are included.
    ///
    /// # Errors
    /// The new model cannot be read. That is a defect of this program, and the model must not be written.
    pub fn of_plan(
        change: &PreparedChange,
        opened: &OpenModel,
        plan: &Plan,
        changed: impl FnOnce() -> ModelFiles,
        dialect: &dyn FrontEnd,
        with_feet: bool,
    ) -> Result<Self, Failure> {
        let before = &change.options;
        let inspected_before = inspected_and_checked(before, opened);
        let after = change.options_after(plan, inspected_before.0.figures.mass_kg);
        let target = change.target_gravity_m_s2;
        let target_gravity_m_s2 =
            target.filter(|&gravity| inspected_before.0.figures.gravity_m_s2 != Some(gravity));
        let mut states = Self {
            before: inspected_before,
            before_under_new_weight: None,
            after: None,
            bodies: Vec::new(),
            feet: Vec::new(),
            reference: change.reference.clone(),
            recording: None,
            target_gravity_m_s2,
        };
        if after.masses.model_kg != before.masses.model_kg || target_gravity_m_s2.is_some() {
            let mut heavier = before.clone();
            heavier.masses.model_kg = after.masses.model_kg;
            heavier.stance.gravity_m_s2 = after.stance.gravity_m_s2;
            states.before_under_new_weight =
                Some(heavier.inspect(opened.name(), &opened.model, None).figures);
        }
        let feet = |name: &str, opened: &OpenModel| {
            with_feet.then(|| ModelFeet::for_page(name, opened, &before.selection)).flatten()
        };
        states.feet.extend(feet("before", opened));
        states.bodies.extend(drawn_body("before", before, &opened.model, opened));
        if !plan.is_empty() {
            let written = changed().open()?;
            states.after = Some(inspected_and_checked(&after, &written));
            states.bodies.extend(drawn_body("after", &after, &written.model, &written));
            let changed =
                |after: &ModelFeet| states.feet.iter().any(|before| !before.has_same_spheres(after));
            let after = feet("after", &written).filter(changed);
            states.feet.extend(after);
            states.recording = change.planner.recording(written).map(Box::new);
        }
        states.spell(dialect);
        Ok(states)
    }

    fn spell(&mut self, dialect: &dyn FrontEnd) {
        for (inspection, check) in std::iter::once(&mut self.before).chain(&mut self.after) {
            inspection.spell(dialect);
            check.spell(dialect);
        }
        self.before_under_new_weight.iter_mut().for_each(|figures| figures.spell(dialect));
        let reference = self.reference.iter_mut().flat_map(|reference| &mut reference.figures);
        reference.for_each(|figures| figures.spell(dialect));
    }
}

/// Inspects and checks a model, with remedies that name no other files.
fn inspected_and_checked(options: &InspectOptions, opened: &OpenModel) -> (Inspection, CheckResult) {
    let inspection = options.inspect(opened.name(), &opened.model, None);
    let check = check_with_remedies(options, &opened.model, &inspection, &[]);
    (inspection, check)
}

/// A model and the plan of its change, for pictures of both states.
#[derive(Clone, Copy)]
pub struct BeforeAndAfterPlan<'s> {
    pub change: &'s PreparedChange,
    /// The model as it was before the change.
    pub opened: &'s OpenModel,
    pub plan: &'s Plan,
    /// The new model; `None` if nothing changes.
    pub changed: Option<&'s Model>,
}

impl BeforeAndAfterPlan<'_> {
    /// The model before and after the change for figures of curves, without inspections and checks. This is fast enough to follow a slider.
    pub fn bodies(self) -> Vec<ContactBody> {
        let old = drawn_body("before", &self.change.options, &self.opened.model, self.opened);
        let new =
            self.changed.and_then(|changed| drawn_body("after", &self.options_after(), changed, self.opened));
        old.into_iter().chain(new).collect()
    }

    /// The scene of the new model; `None` if nothing changes.
    pub fn scene(self) -> Option<Scene> {
        Some(Scene::of(self.changed?, &self.options_after()))
    }

    /// How the body for which the new contacts are made falls: on the old contacts, and on the new contacts.
    pub fn falls(self) -> Vec<BodyFall> {
        let Some(changed) = self.changed else { return Vec::new() };
        let after = self.options_after();
        let mut heavier = self.change.options.clone();
        heavier.masses.model_kg = after.masses.model_kg;
        heavier.stance.gravity_m_s2 = after.stance.gravity_m_s2;
        let old = drawn_body("before", &heavier, &self.opened.model, self.opened);
        let new = drawn_body("after", &after, changed, self.opened);
        BodyFall::all(&old.into_iter().chain(new).collect::<Vec<ContactBody>>())
    }

    /// The options with which the changed model is drawn.
    fn options_after(self) -> InspectOptions {
        let weighs = self.change.options.masses.model_mass(&self.opened.model).ok();
        self.change.options_after(self.plan, weighs.map(|mass| mass.kg))
    }
}

/// A model in one state, before or after the change, for figures of curves. `open` is the model before it.
fn drawn_body(name: &str, options: &InspectOptions, model: &Model, open: &OpenModel) -> Option<ContactBody> {
    ContactBody::from_inspected_model(name.to_owned(), model, options, &|fault| open.failure(fault)).ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use osim_model::files::InMemory;
    use osim_model::{Fault, FileId};
    use osim_requests::Request;
    use osim_requests::spell::CommandLine;
    use serde_json::json;

    use super::*;
    use crate::prepare;
    use crate::prepared_change::Planner;

    struct PanickingPlanner;

    impl Planner for PanickingPlanner {
        fn plan(&self, _: &Model) -> Result<Plan, Fault> {
            panic!("planned once more")
        }
    }

    #[test]
    fn both_states_follow_from_one_plan() {
        let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
        let folders = ["table1", "check", "format", "quirks"].map(|folder| fixtures.join(folder));
        let files = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
        let mut compared = 0;
        for path in files.map(|file| file.unwrap().path()) {
            if path.extension().is_none_or(|ending| ending != "osim") {
                continue;
            }
            let files = InMemory::from_iter([("model.osim", std::fs::read(&path).unwrap())]);
            for request in [
                json!({"verb": "rescale", "models": "model.osim", "target_mass": 500}),
                json!({"verb": "rescale", "models": "model.osim", "target_mass": 5, "only": "radius"}),
                json!({"verb": "set", "models": "model.osim", "set": {"stiffness": "x2"}}),
                json!({"verb": "design", "models": "model.osim", "restitution": 0.9, "impact_speed": 0.1}),
            ] {
                let request = Request::from_json(request.to_string().as_bytes()).unwrap();
                let mut change = prepare(request, &files).unwrap();
                let Ok(opened) = change.open(Path::new("model.osim"), &files) else { continue };
                let Ok(plan) = change.plan(&opened, &files) else { continue };
                change.planner = Box::new(PanickingPlanner);
                let bytes = plan.patched(&opened.model, FileId::MAIN).unwrap();
                let beside = change.set_files.companion_paths();
                let changed = || ModelFiles::read(Path::new("model.osim"), bytes, beside, &files).unwrap();
                BeforeAfter::of_plan(&change, &opened, &plan, changed, &CommandLine, false).unwrap();
                compared += 1;
            }
        }
        assert!(compared > 100, "{compared}");
    }
}
