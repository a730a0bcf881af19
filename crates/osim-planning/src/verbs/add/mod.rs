//! The verb `add`: adds contacts to models without contacts.

mod bodies;
mod places;
pub(in crate::verbs) mod prepare;
mod reference;

use std::collections::HashSet;
use std::path::Path;

use osim_model::files::{Failure, Files, InMemory, OpenModel};
use osim_model::messages::Phrase;
use osim_model::{
    ComponentId, Fault, FaultKind, FindingCode, ForceId, Model, Selected, Selection, YesQuestion,
};
use osim_patch::{ContactLayout, ObjectAction, Plan, RebuiltModel, remove};
use osim_requests::BodyScale;
use osim_requests::options::AnswerOptions;

use super::set;
use crate::prepared_change::Planner;
use crate::remarks::{
    question_about_scale, remark_on_kept_friction, remark_on_leaning_planes, remark_on_old_document,
    remark_on_other_planes, remark_on_standing,
};
use bodies::AddFault;
use places::NewSpherePlaces;
use reference::{ContactNumbers, FromReference, with_contacts};

/// Plans new contacts for models that have none, or in place of the contacts that they have.
struct AddPlanner {
    source: ContactSource,
    /// Whether new spheres are moved so that the bottoms of each foot are level.
    level: bool,
    replace: bool,
    /// The forces of the model whose contacts are replaced.
    replaced_forces: Selection,
    /// Scale factors of bodies that the caller gave.
    body_scale: Vec<BodyScale>,
    answers: AnswerOptions,
    /// Whether the transition velocities of friction are scaled, too.
    friction: bool,
    remarks: Vec<Phrase>,
}

/// The source of the places and of the numbers of new contacts.
enum ContactSource {
    /// A reference gives the places and the numbers.
    Reference(Box<FromReference>),
    /// The request gives the places. The numbers come from a reference or a design.
    OwnPlaces(NewSpherePlaces, ContactNumbers),
}

impl Planner for AddPlanner {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        self.plan_for_file(model, Path::new(""), &InMemory::default()).map_err(AddFault::into_fault)
    }

    fn plan_with_companions(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let path = opened.name().to_path();
        self.plan_for_file(&opened.model, &path, files).map_err(|fault| fault.into_failure(opened))
    }
}

impl AddPlanner {
    /// Plans new contacts for the model in the file at `path`.
    fn plan_for_file(&self, model: &Model, path: &Path, files: &dyn Files) -> Result<Plan, AddFault> {
        self.answers.require_yes(question_about_scale(&self.body_scale)).map_err(Fault::new)?;
        let (bare, removed) = self.without_contacts(model)?.unzip();
        let base = bare.as_ref().map_or(model, RebuiltModel::model);
        let (mut plan, rebuilt, remarks) = match &self.source {
            ContactSource::Reference(from_reference) => {
                let (plan, rebuilt) = from_reference.plan(base)?;
                (plan, rebuilt, self.remarks.clone())
            }
            ContactSource::OwnPlaces(places, numbers) => {
                let (mut layout, remarks) = places.layout(base, path, numbers, &self.answers, files)?;
                let (rebuilt, selected) = with_contacts(base, &mut layout)?;
                self.ask_about_radii(rebuilt.model(), &layout)?;
                let plan = numbers.plan(rebuilt.model(), &selected)?;
                (plan, rebuilt, remarks)
            }
        };
        plan.name_operation("add");
        if base.forces().is_empty() {
            plan.forget_earlier_steps();
        }
        plan.findings.retain(|finding| finding.code() != FindingCode::NothingToChange);
        plan.remarks.splice(0..0, remarks);
        let has_reference = !matches!(self.source, ContactSource::OwnPlaces(_, ContactNumbers::Designed(_)));
        if !self.friction && has_reference {
            plan.remarks.extend(remark_on_kept_friction(&plan, rebuilt.model()));
        }
        plan.remarks.extend(remark_on_old_document(&rebuilt));
        plan.remarks.extend(remark_on_leaning_planes(base, &rebuilt));
        plan.remarks.extend(removed.and_then(|forces| remark_on_other_planes(model, &forces, &rebuilt)));
        let mut plan = plan.attach_to(match &bare {
            Some(bare) => rebuilt.clone().with_earlier_step(bare),
            None => rebuilt.clone(),
        });
        if self.level {
            let changed = plan.changed_model(model)?;
            plan.level(model, &set::level_places(&changed, &new_forces(&plan, &changed))?)?;
        }
        let stands = plan.changed_model(model).ok().and_then(|changed| remark_on_standing(&plan, &changed));
        plan.remarks.extend(stands);
        Ok(plan)
    }

    /// The model without the contacts that are replaced, and the forces of these contacts; `None` if the model has no contacts.
    fn without_contacts(&self, model: &Model) -> Result<Option<(RebuiltModel, Vec<ForceId>)>, Fault> {
        let forces_on_floors = Selected::matching(model, |force| model.meets_half_space(force));
        let is_replaced = |&id: &ComponentId| self.replaced_forces.matches_name(&model.components().name(id));
        let mut others = model.carriers_of_other_classes();
        others.retain(is_replaced);
        if forces_on_floors.forces.is_empty() && others.is_empty() {
            return Ok(None);
        }
        // Other forces, such as a ball that meets the floor, stay: the program asks for the choice of forces as `remove` does.
        let replaced = match self.replaced_forces.apply(model) {
            Ok(replaced) => replaced,
            Err(fault)
                if !others.is_empty()
                    && (forces_on_floors.forces.is_empty()
                        || matches!(fault.kind, FaultKind::NothingSelected { .. })) =>
            {
                Selected::default()
            }
            Err(fault)
                if self.replaced_forces.select.is_empty()
                    && matches!(fault.kind, FaultKind::NothingSelected { .. }) =>
            {
                return Ok(None);
            }
            Err(fault) if self.replace || !self.replaced_forces.select.is_empty() => return Err(fault),
            Err(_) => forces_on_floors,
        };
        if self.replace {
            return Ok(Some((remove(model, &replaced, &others)?, replaced.forces)));
        }
        let can_scale = !replaced.forces.is_empty();
        let forces = match can_scale {
            true => model.short_force_names(&replaced.forces),
            false => model.short_component_names(&others),
        };
        Err(Fault::new(FaultKind::ContactsExist { forces, can_scale }))
    }

    /// Asks about radii that look like another unit. The question for other changes does not include the radii of new spheres.
    fn ask_about_radii(&self, built: &Model, layout: &ContactLayout) -> Result<(), Fault> {
        if self.answers.confirms(YesQuestion::ImplausibleRadius) {
            return Ok(());
        }
        let new_spheres: HashSet<&str> =
            layout.contacts.iter().map(|contact| contact.sphere.as_str()).collect();
        let distances = built.joint_distances();
        let spheres = built.spheres().iter().filter(|sphere| new_spheres.contains(sphere.name.as_str()));
        let mut suspicions =
            spheres.filter_map(|sphere| distances.implausible_radius(sphere, sphere.radius.number, true));
        suspicions.next().map_or(Ok(()), |doubt| Err(Fault::new(doubt)))
    }
}

/// The forces that `plan` adds, in the model `built` after the change.
fn new_forces(plan: &Plan, built: &Model) -> Vec<ForceId> {
    let added = plan.objects().iter().filter(|object| object.action == ObjectAction::Added);
    let paths: HashSet<&str> = added.map(|object| object.path.as_str()).collect();
    Selected::matching(built, |force| paths.contains(force.path.as_str())).forces
}
