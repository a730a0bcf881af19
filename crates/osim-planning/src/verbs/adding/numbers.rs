//! Numbers of contacts whose places are given: from a reference, or from what is wanted of them.

use contact_scaling::Ratios;
use osim_inspect::ReferenceState;
use osim_model::messages::{Input, Phrase, phrase};
use osim_model::{Fault, FaultKind, ForceKind, Model, Property, Selected};
use osim_patch::{Layout, NewContact, PLACES_STAY, Plan, Reference};
use osim_requests::options::InspectionOptions;

use super::super::design::Designing;
use super::super::transferring::Transferring;
use super::fault::AddFault;
use crate::planner::Planner as _;

/// Where the numbers come from.
pub(super) enum Numbers {
    /// The contacts of a reference, without dimensions.
    Reference(Box<OfReference>),
    /// What is wanted.
    Wanted(Box<Wanted>),
}

/// Contacts of a reference.
pub(super) struct OfReference {
    /// As they are there, in the class that is wanted.
    pub(super) layout: Layout,
    /// The same, free of names of forces.
    pub(super) reference: Reference,
    pub(super) transferring: Transferring,
}

/// What is wanted.
pub(super) struct Wanted {
    pub(super) kind: ForceKind,
    /// Friction that the caller gave.
    pub(super) friction: Vec<(Property, f64)>,
    pub(super) designing: Designing,
    /// What comes from OpenSim's defaults.
    pub(super) remarks: Vec<Phrase>,
}

impl Numbers {
    /// By how much radii that are not given are larger in `model` than in the reference: by (8).
    ///
    /// # Errors
    /// There is no reference, or a mass that is not known.
    pub(super) fn growth(&self, model: &Model) -> Result<f64, AddFault> {
        let own = self.of_reference()?;
        let mass = own.transferring.masses.of_model(model)?;
        let ratios = Ratios::isometric(mass.kg / own.reference.mass.kg).map_err(Fault::new)?;
        Ok(ratios.radius())
    }

    /// The radius of the sphere in the reference that the sphere called `name` is made from, m.
    ///
    /// # Errors
    /// There is no reference, or its radii differ and it has no sphere of that name.
    pub(super) fn radius(&self, name: Option<&str>) -> Result<f64, AddFault> {
        let own = self.of_reference()?;
        let reference = &own.reference;
        own.radius(name)?.ok_or_else(|| {
            let message = phrase![
                format!("radii differ in {}: say the radius with ", reference.name),
                Input::Radius.like("METRES"),
                ", or whose with ",
                Input::ReferenceSphere.like("NAME"),
            ];
            AddFault::Beside("which-reference", message)
        })
    }

    fn of_reference(&self) -> Result<&OfReference, Fault> {
        match self {
            Self::Reference(own) => Ok(own),
            // Asked for before any model is read.
            Self::Wanted(_) => Err(Fault::refused("nothing says how large the spheres are")),
        }
    }

    /// The force and the sphere called `name`, which has this radius: numbers that `plan` changes, and those that stay.
    pub(super) fn contact(&self, name: &str, radius_m: f64) -> Result<NewContact, Fault> {
        let force = format!("force_{name}");
        let mut contact = match self {
            Self::Reference(own) => {
                let mut like = own.like(Some(name))?.clone();
                (like.force, like.sphere) = (force, name.to_owned());
                like
            }
            Self::Wanted(wanted) => {
                let mut contact = NewContact::new(wanted.kind, force, name);
                contact.values.clone_from(&wanted.friction);
                // Any value will do: the plan gives another one, and a force must have a stiffness.
                contact.set_value(Property::Stiffness, 1.0);
                contact.radius_m = radius_m;
                return contact.with_defaults();
            }
        };
        contact.radius_m = radius_m;
        Ok(contact)
    }

    /// Gives the contacts `selected` of `built` their numbers.
    pub(super) fn plan(&self, built: &Model, selected: &Selected) -> Result<Plan, Fault> {
        let mut plan = match self {
            Self::Reference(own) => own.transferring.plan_from(built, selected, &own.reference, None)?,
            Self::Wanted(wanted) => {
                let mut plan = wanted.designing.plan_for(built, selected)?;
                plan.remarks.extend(wanted.remarks.iter().cloned());
                if selected.complete {
                    plan.note_all_values();
                }
                plan
            }
        };
        // Spheres that are new do not stay anywhere.
        plan.remarks.retain(|remark| remark.to_string() != PLACES_STAY);
        Ok(plan)
    }

    pub(super) fn inspection(&self) -> InspectionOptions {
        match self {
            Self::Reference(own) => own.transferring.inspection(),
            Self::Wanted(wanted) => wanted.designing.inspection(),
        }
    }

    pub(super) fn reference(&self) -> Option<&ReferenceState> {
        match self {
            Self::Reference(own) => own.transferring.reference(),
            Self::Wanted(_) => None,
        }
    }
}

impl OfReference {
    /// The contact that a sphere called `name` gets: that of the sphere that was chosen, else of that name, else the first. Where
    /// they differ and none has the name, the transfer asks.
    fn like(&self, name: Option<&str>) -> Result<&NewContact, Fault> {
        let contacts = &self.layout.contacts;
        let of = |wanted: &str| contacts.iter().find(|contact| contact.sphere == wanted);
        let none = || self.reference.without_contacts();
        match &self.transferring.reference_sphere {
            Some(chosen) => of(chosen).ok_or_else(|| {
                let known = contacts.iter().map(|contact| contact.sphere.clone()).collect();
                let reference = self.reference.name.clone();
                Fault::new(FaultKind::UnknownReferenceSphere { sphere: chosen.clone(), reference, known })
            }),
            None => name.and_then(of).or(contacts.first()).ok_or_else(none),
        }
    }

    /// The radius of the sphere in the reference that a sphere called `name` is made from; `None` if that is not clear.
    fn radius(&self, name: Option<&str>) -> Result<Option<f64>, Fault> {
        let like = self.like(name)?;
        let named = self.transferring.reference_sphere.is_some() || Some(like.sphere.as_str()) == name;
        let all = self.layout.contacts.iter().all(|contact| contact.radius_m == like.radius_m);
        Ok((named || all).then_some(like.radius_m))
    }
}
