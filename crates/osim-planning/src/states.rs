//! A model before and after a change: what is known of both states before anything is written.

use osim_inspect::series::Body;
use osim_inspect::{CheckResult, Figures, InspectOptions, Inspection, ReferenceState, check_model};
use osim_model::files::{Failure, FileName, InMemory, ModelFiles, OpenModel};
use osim_model::{Model, Property};
use osim_patch::Plan;
use osim_requests::spell::Speller;

use crate::motion::MotionResult;
use crate::motion_remarks::MotionRemark;
use crate::remedies::Trials;
use crate::scene::{Fall, Scene};
use crate::{Change, ModelFeet, planner};

/// What is known of both states of a model, spelled.
#[derive(Debug)]
pub struct BeforeAfter {
    /// The model as it was.
    pub before: (Inspection, CheckResult),
    /// The old contacts under the new weight, if it differs.
    pub before_under_new_weight: Option<Figures>,
    /// The model as it is written; `None` if nothing changes.
    pub after: Option<(Inspection, CheckResult)>,
    /// Both states, to be drawn.
    pub bodies: Vec<Body>,
    /// The feet of both states without their bones, where they are to be drawn; of one where the spheres stay as they are.
    pub feet: Vec<ModelFeet>,
    /// What the contacts are taken from, where they are another body's.
    pub reference: Option<ReferenceState>,
    /// What the new contacts do along the recording that the change follows, where it follows one.
    pub recording: Option<Box<(MotionResult, Vec<MotionRemark>)>>,
    /// The contacts are scaled to this gravity, m/s², and the model's is another.
    pub target_gravity_m_s2: Option<f64>,
}

impl BeforeAfter {
    /// Both states of a model for which `change` has made `plan`. `changed` gives its files as they will be, under their
    /// names; it is asked only where something changes. The states are spelled by `dialect`, and have feet `with_feet`.
    ///
    /// # Errors
    /// The new model cannot be read, which would be a defect: it is not to be written then.
    pub fn of(
        change: &Change,
        opened: &OpenModel,
        plan: &Plan,
        changed: impl FnOnce() -> ModelFiles,
        dialect: &dyn Speller,
        with_feet: bool,
    ) -> Result<Self, Failure> {
        let before = &change.options;
        // The new model has the same elements: what can be changed in one can be changed in the other.
        let changes = shown_by(plan, before, opened) || planner::changeable(before, &opened.model).numbers;
        let now = seen(before, opened, changes);
        let after = change.options_after(plan, now.0.figures.mass_kg);
        let target = change.target_gravity_m_s2;
        let target_gravity_m_s2 = target.filter(|&gravity| now.0.figures.gravity_m_s2 != Some(gravity));
        let mut both = Self {
            before: now,
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
            both.before_under_new_weight = Some(heavier.inspect(opened.name(), &opened.model, None).figures);
        }
        let feet = |name: &str, opened: &OpenModel| {
            with_feet.then(|| ModelFeet::for_page(name, opened, &before.selection)).flatten()
        };
        both.feet.extend(feet("before", opened));
        both.bodies.extend(body("before", before, &opened.model, opened));
        if !plan.is_empty() {
            let written = changed().open()?;
            both.after = Some(seen(&after, &written, changes));
            both.bodies.extend(body("after", &after, &written.model, &written));
            let changed = |after: &ModelFeet| both.feet.iter().any(|before| !before.has_same_spheres(after));
            let after = feet("after", &written).filter(changed);
            both.feet.extend(after);
            both.recording = change.planner.recording(written).map(Box::new);
        }
        both.spell(dialect);
        Ok(both)
    }

    fn spell(&mut self, dialect: &dyn Speller) {
        for (inspection, check) in std::iter::once(&mut self.before).chain(&mut self.after) {
            inspection.spell(dialect);
            check.spell(dialect);
        }
        self.before_under_new_weight.iter_mut().for_each(|figures| figures.spell(dialect));
        let reference = self.reference.iter_mut().flat_map(|reference| &mut reference.figures);
        reference.for_each(|figures| figures.spell(dialect));
    }
}

fn seen(options: &InspectOptions, opened: &OpenModel, changes: bool) -> (Inspection, CheckResult) {
    let inspect = |name: &FileName, model: &Model| options.inspect(name.clone(), model, None);
    let inspection = inspect(opened.name(), &opened.model);
    let check = check_model(
        options,
        &opened.model,
        &inspection,
        &[],
        planner::with_numbers(options, &opened.model, changes),
    );
    // Remedies of a model by itself name no other files.
    let trials = Trials { options, files: &InMemory::default(), inspect: &inspect };
    (inspection, trials.tried(&opened.model, check))
}

/// Whether `plan` shows that the numbers of the model can be changed: it changes those that remedies change, in all of the chosen
/// forces.
fn shown_by(plan: &Plan, options: &InspectOptions, opened: &OpenModel) -> bool {
    let Ok(selected) = options.selection.apply(&opened.model) else { return false };
    let forces = selected.forces.iter().filter_map(|&id| opened.model.force(id));
    // A force without parameters of its own has none that could be changed.
    let sets: usize = forces.map(|force| force.sets.len().max(1)).sum();
    [Property::Stiffness, Property::Dissipation]
        .into_iter()
        .all(|property| plan.changes.iter().filter(|change| change.property == property).count() >= sets)
}

// Both states of a model, for drawing.

/// A model for which a change was planned.
#[derive(Clone, Copy)]
pub struct States<'s> {
    /// What planned it.
    pub change: &'s Change,
    /// The model as it is.
    pub opened: &'s OpenModel,
    pub plan: &'s Plan,
    /// The model as it will be; `None` where nothing changes.
    pub changed: Option<&'s Model>,
}

impl States<'_> {
    /// What is drawn of both states, without their figures and findings: for pictures that follow a slider.
    pub fn bodies(self) -> Vec<Body> {
        let old = body("before", &self.change.options, &self.opened.model, self.opened);
        let new = self.changed.and_then(|changed| body("after", &self.options_after(), changed, self.opened));
        old.into_iter().chain(new).collect()
    }

    /// The new model in space; `None` where nothing changes.
    pub fn scene(self) -> Option<Scene> {
        Some(Scene::of(self.changed?, &self.options_after()))
    }

    /// How the body falls on the contacts as they are, and on the new ones: the same body on both, that which the new ones are for.
    pub fn falls(self) -> Vec<Fall> {
        let Some(changed) = self.changed else { return Vec::new() };
        let after = self.options_after();
        let mut heavier = self.change.options.clone();
        heavier.masses.model_kg = after.masses.model_kg;
        heavier.stance.gravity_m_s2 = after.stance.gravity_m_s2;
        let old = body("before", &heavier, &self.opened.model, self.opened);
        let new = body("after", &after, changed, self.opened);
        Fall::all(&old.into_iter().chain(new).collect::<Vec<Body>>())
    }

    fn options_after(self) -> InspectOptions {
        let weighs = self.change.options.masses.model_mass(&self.opened.model).ok();
        self.change.options_after(self.plan, weighs.map(|mass| mass.kg))
    }
}

/// What is drawn of `model`, a state of what was `opened`.
pub(crate) fn body(name: &str, options: &InspectOptions, model: &Model, opened: &OpenModel) -> Option<Body> {
    Body::from_inspected_model(name.to_owned(), model, options, &|fault| opened.failure(fault)).ok()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use osim_model::{Fault, FileId};
    use osim_requests::Request;
    use osim_requests::spell::CommandLine;
    use serde_json::json;

    use super::*;
    use crate::planner::Planner;
    use crate::prepare;

    struct NoPlans;

    impl Planner for NoPlans {
        fn plan(&self, _: &Model) -> Result<Plan, Fault> {
            panic!("planned once more")
        }
    }

    #[test]
    fn a_plan_at_hand_is_enough() {
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
                change.planner = Box::new(NoPlans);
                let bytes = plan.patched(&opened.model, FileId::MAIN).unwrap();
                let beside = change.set_files.companion_paths();
                let changed = || ModelFiles::read(Path::new("model.osim"), bytes, beside, &files).unwrap();
                BeforeAfter::of(&change, &opened, &plan, changed, &CommandLine, false).unwrap();
                compared += 1;
            }
        }
        assert!(compared > 100, "{compared}");
    }
}
