//! A model before and after, as the page shows it: seen before anything is written, told when it is.

use std::path::PathBuf;

use osim_patch::{Model, Plan, same_mass};

use super::record::Record;
use super::task::{Order, Task};
use super::writing::Results;
use crate::args::ViewArgs;
use crate::check::{self, Report};
use crate::failure::Failure;
use crate::load::Loaded;
use crate::look::figures::Figures;
use crate::look::{Inspection, View};
use crate::page::{Changed, Entry, Files, Frame, of_change};
use crate::plotting::body::Body;

/// What is known of both states of a model.
pub(super) struct Sights {
    now: (Inspection, Report),
    /// The old contacts under the new weight, where that is another one.
    now_heavier: Option<Figures>,
    new: Option<(Inspection, Report)>,
    bodies: Vec<Body>,
    /// The contacts are scaled to this gravity, and the model's is another.
    target_gravity_m_s2: Option<f64>,
    frame: Frame,
}

/// One state of a model, and how it is looked at.
struct Sight<'s> {
    loaded: &'s Loaded,
    args: ViewArgs,
    view: View,
}

impl Sight<'_> {
    fn seen(&self, model: &Model) -> (Inspection, Report) {
        let seen = self.view.inspection(&self.loaded.shown, model, None);
        let report = check::judged(&self.view, &self.args, model, &seen, None);
        (seen, report)
    }

    fn body(&self, name: &str, model: &Model) -> Option<Body> {
        Body::seen(name.to_owned(), model, &self.view, &|fault| self.loaded.failure(fault)).ok()
    }
}

impl Sights {
    /// # Errors
    /// The new model cannot be read, which would be a defect: it is not written then.
    pub(super) fn of(
        task: &Task,
        loaded: &Loaded,
        plan: &Plan,
        model: &Model,
        results: &Results<'_>,
        frame: Frame,
    ) -> Result<Self, Failure> {
        let order = task.order.as_ref();
        let refused = |error: anyhow::Error| Failure::outside(&loaded.shown, "refused", &error);
        let args = order.view();
        let before = Sight { loaded, view: View::new(&args).map_err(refused)?, args };
        let now = before.seen(model);
        let args = view_after(order, &before.args, plan, &now.0);
        let mut view = View::new(&args).map_err(refused)?;
        view.stance.gravity_m_s2 = order.planner().target_gravity_m_s2();
        let target_gravity_m_s2 =
            view.stance.gravity_m_s2.filter(|&gravity| now.0.figures.gravity_m_s2 != Some(gravity));
        let mut sights =
            Self { now, now_heavier: None, new: None, bodies: Vec::new(), target_gravity_m_s2, frame };
        if view.masses.model_kg != before.view.masses.model_kg || target_gravity_m_s2.is_some() {
            let mut heavier = before.view.clone();
            heavier.masses.model_kg = view.masses.model_kg;
            heavier.stance.gravity_m_s2 = view.stance.gravity_m_s2;
            sights.now_heavier = Some(heavier.inspection(&loaded.shown, model, None).figures);
        }
        sights.bodies.extend(before.body("before", model).filter(|_| frame.plots));
        if !plan.is_empty() {
            let written = written(task, loaded, results);
            let after = Sight { loaded: &written, args, view };
            written.with_model(|model| {
                sights.new = Some(after.seen(model));
                sights.bodies.extend(after.body("after", model).filter(|_| frame.plots));
                Ok(())
            })?;
        }
        Ok(sights)
    }

    /// The model on the page; `result` says what became of it, and `outputs` are the files it is in now.
    pub(super) fn entry(
        self,
        plan: &Plan,
        loaded: &Loaded,
        record: &Record,
        (result, outputs): (String, &[PathBuf]),
    ) -> Entry {
        let in_file = !outputs.is_empty();
        let digests = [&record.sha256_output, &record.sha256_geometry_output];
        let outputs = outputs.iter().map(|path| path.display().to_string());
        let outputs = outputs.zip(digests.into_iter().flatten().cloned()).collect();
        let files = Files { inputs: loaded.digests(), result, outputs };
        let new = self.new.as_ref().map(|(seen, report)| (seen, report));
        let counts = self.new.as_ref().map_or(self.now.1.counts, |(_, report)| report.counts);
        let changed = Changed {
            plan,
            now: (&self.now.0, &self.now.1),
            now_heavier: self.now_heavier.as_ref(),
            new,
            bodies: self.bodies,
            in_file,
            target_gravity_m_s2: self.target_gravity_m_s2,
            files,
        };
        Entry::of_change(record, plan, counts, of_change(&changed, self.frame))
    }
}

/// How the new model is looked at: its contacts carry the body that they were scaled for.
fn view_after(order: &Order, before: &ViewArgs, plan: &Plan, now: &Inspection) -> ViewArgs {
    let mut args = before.clone();
    let to_kg = plan.masses.as_ref().map(|masses| masses.to_kg);
    // The note says it; without one somebody has to.
    args.masses.contacts_mass = to_kg.filter(|_| order.no_note);
    if let Some(kg) = to_kg.filter(|_| order.name() == "rescale")
        && now.figures.mass_kg.is_none_or(|weighs| !same_mass(weighs, kg))
    {
        args.masses.mass = Some(kg);
    }
    args
}

/// The model as it will be, with the geometry set that goes with it.
fn written(task: &Task, loaded: &Loaded, results: &Results<'_>) -> Loaded {
    let mut written = loaded.with_bytes(results.model.to_vec());
    if let Some(path) = task.output() {
        written.shown = path.display().to_string();
    }
    if let Some(geometry) = &results.geometry {
        written.replace_part(geometry.file, geometry.patch.to_vec());
    }
    written
}
