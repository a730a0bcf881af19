//! Contacts for models that have none.

mod bodies;
mod places;
pub(in crate::verbs) mod prepare;
mod reference;

use std::collections::HashSet;
use std::path::Path;

use osim_model::files::{Failure, Files, InMemory, OpenModel};
use osim_model::messages::Phrase;
use osim_model::{Fault, FaultKind, FindingCode, ForceId, Model, Question, Selected, Selection};
use osim_patch::{Deed, Layout, Plan, Rebuilt, remove};
use osim_requests::BodyScale;
use osim_requests::options::AnswerOptions;

use super::set;
use crate::planner::Planner;
use crate::remarks::{friction_stays, leaning, planes_left, scale_slip, standing, too_new};
use bodies::AddFault;
use places::Places;
use reference::{FromReference, Numbers, added};

/// Plans contacts for models that have none.
struct Adding {
    source: Source,
    /// Whether feet are made level.
    level: bool,
    replace: bool,
    /// Which of the model's own forces are replaced.
    own: Selection,
    /// Factors that the caller gave.
    body_scale: Vec<BodyScale>,
    answers: AnswerOptions,
    /// Whether speeds of friction are scaled.
    friction: bool,
    remarks: Vec<Phrase>,
}

/// Where contacts come from.
enum Source {
    /// Places and numbers of a reference.
    Reference(Box<FromReference>),
    /// Places of the model's own, and numbers for them.
    Placed(Places, Numbers),
}

impl Planner for Adding {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        self.plan_at(model, Path::new(""), &InMemory::default()).map_err(AddFault::fault)
    }

    fn plan_beside(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let path = opened.name().to_path();
        self.plan_at(&opened.model, &path, files).map_err(|fault| fault.failure(opened))
    }
}

impl Adding {
    fn plan_at(&self, model: &Model, path: &Path, files: &dyn Files) -> Result<Plan, AddFault> {
        self.answers.ask(scale_slip(&self.body_scale)).map_err(Fault::new)?;
        let (bare, removed) = self.bare(model)?.unzip();
        let base = bare.as_ref().map_or(model, Rebuilt::model);
        let (mut plan, rebuilt, remarks) = match &self.source {
            Source::Reference(own) => {
                let (plan, rebuilt) = own.plan(base)?;
                (plan, rebuilt, self.remarks.clone())
            }
            Source::Placed(places, numbers) => {
                let (mut layout, remarks) = places.layout(base, path, numbers, &self.answers, files)?;
                let (rebuilt, selected) = added(base, &mut layout)?;
                self.ask_about_radii(rebuilt.model(), &layout)?;
                let plan = numbers.plan(rebuilt.model(), &selected)?;
                (plan, rebuilt, remarks)
            }
        };
        plan.name_operation("add");
        if base.forces().is_empty() {
            plan.begin_story();
        }
        plan.warnings.retain(|warning| warning.code() != FindingCode::NothingToChange);
        plan.remarks.splice(0..0, remarks);
        let has_reference = !matches!(self.source, Source::Placed(_, Numbers::Wanted(_)));
        if !self.friction && has_reference {
            plan.remarks.extend(friction_stays(&plan, rebuilt.model()));
        }
        plan.remarks.extend(too_new(&rebuilt));
        plan.remarks.extend(leaning(base, &rebuilt));
        plan.remarks.extend(removed.and_then(|forces| planes_left(model, &forces, &rebuilt)));
        let mut plan = plan.on(match &bare {
            Some(bare) => rebuilt.clone().after(bare),
            None => rebuilt.clone(),
        });
        if self.level {
            let changed = plan.changed(model)?;
            plan.level(model, &set::level_places(&changed, &new_forces(&plan, &changed))?)?;
        }
        let stands = plan.changed(model).ok().and_then(|changed| standing(&plan, &changed));
        plan.remarks.extend(stands);
        Ok(plan)
    }

    /// The model without the contacts that it has, and their forces; `None` where it has none.
    fn bare(&self, model: &Model) -> Result<Option<(Rebuilt, Vec<ForceId>)>, Fault> {
        let feet = Selected::matching(model, |force| model.meets_half_space(force));
        if feet.forces.is_empty() {
            return Ok(None);
        }
        // A ball that meets the floor is not a foot: the choice of forces is asked for as `remove` asks for it.
        let own = match self.own.apply(model) {
            Ok(own) => own,
            Err(fault)
                if self.own.select.is_empty() && matches!(fault.kind, FaultKind::NothingSelected { .. }) =>
            {
                return Ok(None);
            }
            Err(fault) if self.replace || !self.own.select.is_empty() => return Err(fault),
            Err(_) => feet,
        };
        if self.replace {
            return Ok(Some((remove(model, &own)?, own.forces)));
        }
        Err(Fault::new(FaultKind::ContactsExist { forces: model.short_force_names(&own.forces) }))
    }

    /// Radii that are given may be in another unit: a plan asks about those that change only.
    fn ask_about_radii(&self, built: &Model, layout: &Layout) -> Result<(), Fault> {
        if self.answers.has(Question::ImplausibleRadius) {
            return Ok(());
        }
        let own: HashSet<&str> = layout.contacts.iter().map(|contact| contact.sphere.as_str()).collect();
        let distances = built.joint_distances();
        let spheres = built.spheres().iter().filter(|sphere| own.contains(sphere.name.as_str()));
        let mut slips =
            spheres.filter_map(|sphere| distances.implausible_radius(sphere, sphere.radius.number, true));
        slips.next().map_or(Ok(()), |asks| Err(Fault::new(asks)))
    }
}

/// The forces in `built`, the model that `plan` makes, that it adds.
fn new_forces(plan: &Plan, built: &Model) -> Vec<ForceId> {
    let added = plan.objects().iter().filter(|object| object.deed == Deed::Added);
    let paths: HashSet<&str> = added.map(|object| object.path.as_str()).collect();
    Selected::matching(built, |force| paths.contains(force.path.as_str())).forces
}
