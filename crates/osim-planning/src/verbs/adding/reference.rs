//! Contacts as a reference has them, on the bodies that take them here; and numbers of contacts whose places are given.

use std::collections::{BTreeSet, HashSet};
use std::path::Path;

use contact_scaling::Ratios;
use osim_model::files::{Files, OpenModel};
use osim_model::messages::{Input, Phrase, phrase};
use osim_model::{
    Anatomy, Fault, FaultKind, FindingCode, Force, ForceKind, Model, Property, RadiusRule, Selected,
};
use osim_patch::{
    Layout, NewContact, PLACES_STAY, Plan, Rebuilt, Reference, add_contacts, presets_with_places,
    reference_of_model,
};
use osim_requests::{AddRequest, BodyMap, NewRadius, Radius, RequestError, RequestFault, TransferRequest};

use super::bodies::AddFault;
use crate::opening::{Named, open, placed_preset};
use crate::verbs::design::Designing;
use crate::verbs::reference::Generic;
use crate::verbs::transfer::Transferring;

/// Where the numbers come from.
pub(super) enum Numbers {
    /// The contacts of a reference, without dimensions.
    Reference(Box<OfReference>),
    Wanted(Box<Wanted>),
}

/// Contacts of a reference.
pub(super) struct OfReference {
    /// As they are there, in the class that is wanted.
    pub(super) layout: Layout,
    /// The layout as a reference, free of names of forces.
    pub(super) reference: Reference,
    pub(super) transferring: Transferring,
}

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
        let mass = own.transferring.masses.model_mass(model)?;
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
                Input::Radius.with_placeholder("METRES"),
                ", or whose with ",
                Input::ReferenceSphere.with_placeholder("NAME"),
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

// Contacts as a reference has them, on the bodies that take them here.

/// Places, radii and numbers of a reference.
pub(super) struct FromReference {
    /// What is made, with the places and values of the reference.
    pub(super) layout: Layout,
    /// The reference's bones, by the names that bodies have in the models.
    pub(super) anatomy: Anatomy,
    /// Gives the contacts the size of each model.
    pub(super) transferring: Transferring,
    pub(super) generic: Generic,
    /// Bodies that are to take spheres, as the caller gave them.
    pub(super) maps: Vec<BodyMap>,
}

impl FromReference {
    /// The contacts as they are in the reference, and the plan that gives them the size of `base`.
    pub(super) fn plan(&self, base: &Model) -> Result<(Plan, Rebuilt), AddFault> {
        let mut layout = self.layout.clone();
        self.refuse_missing(base)?;
        let (rebuilt, selected) = added(base, &mut layout)?;
        let built = rebuilt.model();
        let known = &self.transferring.reference;
        let mut reference = reference_of_model(built, &selected, known.mass.clone(), known.sphere_count)?;
        reference.name.clone_from(&known.name);
        reference.gravity_m_s2 = known.gravity_m_s2;
        let mut anatomy = layout.anatomy(self.anatomy.clone());
        // Two models without a common joint are explained by any factors.
        anatomy.is_fragment |= !built.joints().iter().any(|joint| anatomy.joint(&joint.name).is_some());
        let generic = self.generic.with_contacts(anatomy, built);
        let mut plan = self.transferring.plan_from(built, &selected, &reference, Some(&generic))?;
        // That the two are different models is why contacts are added at all.
        plan.warnings.retain(|warning| warning.code() != FindingCode::NotAScaledCopy);
        Ok((plan, rebuilt))
    }

    /// A body that is to take spheres and is not in the model.
    fn refuse_missing(&self, model: &Model) -> Result<(), AddFault> {
        let own: HashSet<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
        let all = self.layout.contacts.iter().map(|contact| contact.body.as_str());
        let missing: BTreeSet<&str> = all.filter(|body| !own.contains(body)).collect();
        let said = self.maps.iter().find(|map| missing.contains(map.model.as_str()));
        if let Some(BodyMap { reference, model: body, .. }) = said {
            let bodies: Vec<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
            let message = phrase![
                Input::BodyMap.with_value(format!("{reference}={body}")),
                format!(": the model has no body {body}, it has {}", bodies.join(", ")),
            ];
            return Err(AddFault::Beside("no-such-body", message));
        }
        match missing.is_empty() {
            true => Ok(()),
            false => {
                let bodies = missing.into_iter().map(str::to_owned).collect();
                Err(Fault::new(FaultKind::MissingCarriers { bodies }).into())
            }
        }
    }
}

/// The transfer that follows once the contacts were made: as the reference has them, or at places of this model's own.
pub(super) fn transfer(request: &AddRequest, from: &Path) -> TransferRequest {
    let mut transfer = TransferRequest {
        from: Some(from.to_owned()),
        counts: request.counts.clone(),
        reference: request.reference.clone(),
        masses: request.masses.clone(),
        output: request.output.clone(),
        answers: request.answers.clone(),
        ..TransferRequest::default()
    };
    transfer.scaling.friction = request.friction;
    if request.has_places() {
        return transfer;
    }
    transfer.follow.follow_bodies = true;
    transfer.follow.body_scale.clone_from(&request.body_scale);
    transfer.scaling.radius = match request.radius {
        NewRadius::Metres(metres) => Some(Radius::from(RadiusRule::Metres(metres))),
        NewRadius::Follow => None,
        _ => Some(Radius::from(RadiusRule::Isometric)),
    };
    transfer
}

/// The reference's contacts, with the class and the friction that are wanted.
pub(super) fn contacts_of(request: &AddRequest, model: &Model, selected: &Selected) -> Result<Layout, Fault> {
    let mut layout = Layout::of(model, selected)?;
    if let Some(class) = request.class {
        layout = layout.into_class(class.kind())?;
    }
    for (property, value) in request.numbers.friction() {
        if let Some(value) = value {
            layout.contacts.iter_mut().for_each(|contact| contact.set_value(property, value));
        }
    }
    layout.check()?;
    Ok(layout)
}

/// Refuses to map a body that is not in the reference, or to map one twice.
pub(super) fn check_maps(
    request: &AddRequest,
    model: &Model,
    selected: &Selected,
) -> Result<(), RequestFault> {
    let bodies: HashSet<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
    let carriers: BTreeSet<&str> = model
        .loaded_spheres(&selected.forces)
        .into_iter()
        .filter_map(|sphere| model.sphere(sphere)?.body.as_deref())
        .collect();
    for (index, map) in request.body_map.iter().enumerate() {
        let said = Input::BodyMap.with_value(format!("{}={}", map.reference, map.model));
        let why = if !bodies.contains(map.reference.as_str()) {
            let carriers: Vec<&str> = carriers.iter().copied().collect();
            format!(
                ": the reference has no body {}, its spheres are on {}",
                map.reference,
                carriers.join(", ")
            )
        } else if request.body_map.iter().take(index).any(|other| other.reference == map.reference) {
            format!(": {} was put on another body before", map.reference)
        } else {
            continue;
        };
        return Err(RequestFault::refused(Input::BodyMap, phrase![said, why]));
    }
    Ok(())
}

/// What is made of the reference's contacts, on the bodies that take them, and its bones.
pub(super) fn layout(
    request: &AddRequest,
    model: &Model,
    selected: &Selected,
) -> Result<(Layout, Anatomy, Vec<Phrase>), Fault> {
    let mut layout = contacts_of(request, model, selected)?;
    let mut anatomy = Anatomy::of(model)?;
    let mut remarks = Vec::new();
    for map in &request.body_map {
        anatomy = mapped(&mut layout, anatomy, map, &mut remarks)?;
    }
    if request.mirror.is_some() {
        layout = layout.mirrored()?;
        anatomy = layout.mirrored_anatomy(anatomy);
    }
    let anatomy = layout.anatomy(anatomy);
    Ok((layout, anatomy, remarks))
}

/// Puts the contacts of one body of the reference on another.
fn mapped(
    layout: &mut Layout,
    mut anatomy: Anatomy,
    BodyMap { reference, model: body, .. }: &BodyMap,
    remarks: &mut Vec<Phrase>,
) -> Result<Anatomy, Fault> {
    let own = layout.contacts.iter_mut().filter(|contact| contact.body == *reference);
    if !anatomy.has_body(body) {
        anatomy = anatomy.with_renamed_body(reference, body);
        own.for_each(|contact| contact.body.clone_from(body));
        return Ok(anatomy);
    }
    for contact in own {
        let place = anatomy.point_seen_from(body, reference, contact.location_m).ok_or_else(|| {
            Fault::refused(format!(
                "{reference} does not hang on {body} in the reference, or a joint between them is not understood: its spheres can be \
                 taken by a body above it only"
            ))
        })?;
        contact.location_m = place.into();
        contact.body.clone_from(body);
    }
    let text = format!(
        "spheres of {reference} are placed on {body}, where they are at the reference's default pose"
    );
    remarks.push(text.into());
    Ok(anatomy)
}

/// The reference: a preset with places, also where a file is called so, else a file.
pub(super) fn reference(from: &Path, files: &dyn Files) -> Result<(OpenModel, bool), RequestError> {
    if let Some(own) = placed_preset(from)? {
        return Ok((own, false));
    }
    let Named::Preset(preset) = Named::find(from, Some(Input::From), None, files)? else {
        return Ok((open(from, files)?, true));
    };
    let known: Vec<&str> = presets_with_places().collect();
    let message = phrase![
        Input::From,
        format!(
            " {}: nobody published where its spheres are; expected a model, or one of: {}",
            preset.name,
            known.join(", ")
        ),
    ];
    Err(RequestFault::refused(Input::From, message).into())
}

/// `base` with the contacts of `layout`, and their forces.
///
/// # Errors
/// Contacts of `base` that stay are on bodies that get new ones: both would carry the weight.
pub(super) fn added(base: &Model, layout: &mut Layout) -> Result<(Rebuilt, Selected), Fault> {
    let bodies: HashSet<&str> = layout.contacts.iter().map(|contact| contact.body.as_str()).collect();
    let is_there = |force: &Force| {
        let mut spheres = force.spheres().into_iter().filter_map(|id| base.sphere(id)?.body.as_deref());
        base.meets_half_space(force) && spheres.any(|body| bodies.contains(body))
    };
    let doubled = Selected::matching(base, is_there);
    if !doubled.forces.is_empty() {
        return Err(Fault::new(FaultKind::ContactsExist { forces: base.short_force_names(&doubled.forces) }));
    }
    let rebuilt = add_contacts(base, layout)?;
    let own: HashSet<&str> = layout.contacts.iter().map(|contact| contact.force.as_str()).collect();
    let selected = Selected::matching(rebuilt.model(), |force| own.contains(force.name.as_str()));
    Ok((rebuilt, selected))
}
