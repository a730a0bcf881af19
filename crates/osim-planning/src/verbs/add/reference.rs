//! Puts the contacts of a reference on the bodies of the model. Gives numbers to contacts whose places are known.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::path::Path;

use contact_scaling::Ratios;
use osim_model::files::{Files, OpenModel};
use osim_model::messages::{Input, Phrase, phrase};
use osim_model::{
    Anatomy, Fault, FaultKind, FindingCode, Force, ForceKind, Model, Pattern, Property, RadiusRule, Selected,
};
use osim_patch::{
    ContactLayout, NewContact, Plan, REMARK_PLACES_STAY, RebuiltModel, Reference, add_contacts,
    presets_with_places, reference_of_model,
};
use osim_requests::{AddRequest, BodyMap, NewRadius, Radius, RequestFault, Result, TransferRequest};

use super::bodies::AddFault;
use crate::opening::{NamedSource, open, placed_preset};
use crate::verbs::design::DesignPlanner;
use crate::verbs::reference::GenericModel;
use crate::verbs::transfer::TransferPlanner;

/// The source of the numbers of contacts whose places are given.
pub(super) enum ContactNumbers {
    /// The contacts of a reference, scaled to the model.
    Reference(Box<ReferenceNumbers>),
    /// The numbers that `design` computes from the wanted properties.
    Designed(Box<DesignedNumbers>),
}

/// The contacts of a reference that only give numbers, and no places.
pub(super) struct ReferenceNumbers {
    /// The contacts of the reference, converted to the wanted class of force.
    layout: ContactLayout,
    /// The places in the layout of the contacts of spheres, of one name the first.
    by_sphere: HashMap<String, usize>,
    has_one_radius: bool,
    /// The same contacts in the form from which numbers are scaled. It does not depend on names of forces.
    reference: Reference,
    planner: TransferPlanner,
}

/// Numbers of new contacts that are computed from what is wanted, without a reference.
pub(super) struct DesignedNumbers {
    pub(super) kind: ForceKind,
    /// Properties of friction with the values that the caller gave.
    pub(super) friction: Vec<(Property, f64)>,
    pub(super) design_planner: DesignPlanner,
    /// Remarks on numbers that are OpenSim's defaults.
    pub(super) remarks: Vec<Phrase>,
}

impl ContactNumbers {
    /// The ratio of radii in `model` to radii in the reference, by (8).
    ///
    /// # Errors
    /// There is no reference, or a mass is not known.
    pub(super) fn radius_ratio(&self, model: &Model) -> Result<f64, AddFault> {
        let reference = self.reference_numbers()?;
        let mass = reference.planner.masses.model_mass(model)?;
        let ratios = Ratios::isometric(mass.kg / reference.reference.mass.kg).map_err(Fault::new)?;
        Ok(ratios.radius())
    }

    /// The radius of the reference's sphere from which the new sphere `name` is made, m.
    ///
    /// # Errors
    /// There is no reference, or its radii differ and it has no sphere of that name.
    pub(super) fn radius(&self, name: Option<&str>) -> Result<f64, AddFault> {
        let numbers = self.reference_numbers()?;
        let reference = &numbers.reference;
        numbers.radius(name)?.ok_or_else(|| {
            let message = phrase![
                "the spheres of {} have different radii: give the radius with {}, or whose with {}";
                reference.name.to_string(), Input::Radius.with_placeholder("METRES"),
                Input::ReferenceSphere.with_placeholder("NAME")
            ];
            AddFault::OutsideModel("which-reference", message)
        })
    }

    /// The numbers of the reference; an error without a reference.
    fn reference_numbers(&self) -> Result<&ReferenceNumbers, Fault> {
        match self {
            Self::Reference(reference) => Ok(reference),
            // Without a reference, radii have to be given: this was checked before.
            Self::Designed(_) => Err(Fault::refused("the radius of the spheres is not known")),
        }
    }

    /// A new contact for the sphere `name`, with preliminary numbers, which [`plan`](Self::plan) changes later.
    pub(super) fn contact(&self, name: &str, radius_m: f64) -> Result<NewContact, Fault> {
        let force = format!("force_{name}");
        let mut contact = match self {
            Self::Reference(reference) => {
                let mut like = reference.contact_like(Some(name))?.clone();
                (like.force, like.sphere) = (force, name.to_owned());
                like
            }
            Self::Designed(wanted) => {
                let mut contact = NewContact::new(wanted.kind, force, name);
                contact.values.clone_from(&wanted.friction);
                // A force must have a stiffness; the plan gives it another value.
                contact.set_value(Property::Stiffness, 1.0);
                contact.radius_m = radius_m;
                return contact.with_defaults();
            }
        };
        contact.radius_m = radius_m;
        Ok(contact)
    }

    /// Plans the numbers of the new contacts, which are the forces `selected` of the model `built`.
    pub(super) fn plan(&self, built: &Model, selected: &Selected) -> Result<Plan, Fault> {
        let mut plan = match self {
            Self::Reference(reference) => {
                reference.planner.plan_with_reference(built, selected, &reference.reference, None)?
            }
            Self::Designed(wanted) => {
                let mut plan = wanted.design_planner.plan_for(built, selected)?;
                plan.remarks.extend(wanted.remarks.iter().cloned());
                if selected.complete {
                    plan.note_all_values();
                }
                plan
            }
        };
        // The remark that places stay makes no sense for new spheres.
        plan.remarks.retain(|remark| remark.to_string() != REMARK_PLACES_STAY);
        Ok(plan)
    }
}

impl ReferenceNumbers {
    /// The numbers of the contacts in `layout`; `reference` has the same contacts, as `planner` takes them.
    pub(super) fn new(layout: ContactLayout, reference: Reference, planner: TransferPlanner) -> Self {
        let contacts = &layout.contacts;
        let by_sphere = contacts.iter().enumerate().rev().map(|(at, one)| (one.sphere.clone(), at)).collect();
        let has_one_radius =
            contacts.windows(2).all(|two| matches!(two, [one, next] if one.radius_m == next.radius_m));
        Self { layout, by_sphere, has_one_radius, reference, planner }
    }

    /// The reference's contact from which the new sphere `name` is made: the contact of the sphere that the caller chose; else that of the
    /// sphere with the same name; else the first. If the contacts differ and no sphere has the name, the planner of the transfer asks.
    fn contact_like(&self, name: Option<&str>) -> Result<&NewContact, Fault> {
        let contacts = &self.layout.contacts;
        let named = |wanted: &str| contacts.get(*self.by_sphere.get(wanted)?);
        let none = || self.reference.without_contacts();
        match &self.planner.reference_sphere {
            Some(chosen) => named(chosen).ok_or_else(|| self.reference.without_sphere(chosen)),
            None => name.and_then(named).or(contacts.first()).ok_or_else(none),
        }
    }

    /// The radius of the reference's sphere from which the new sphere `name` is made, m; `None` if the radii differ and no sphere has the
    /// name.
    fn radius(&self, name: Option<&str>) -> Result<Option<f64>, Fault> {
        let like = self.contact_like(name)?;
        let named = self.planner.reference_sphere.is_some() || Some(like.sphere.as_str()) == name;
        Ok((named || self.has_one_radius).then_some(like.radius_m))
    }
}

/// The places, radii and numbers of the contacts of a reference.
pub(super) struct FromReference {
    /// The new contacts, with places and values as in the reference.
    pub(super) layout: ContactLayout,
    /// The skeleton of the reference, in which bodies have the names of the models' bodies.
    pub(super) anatomy: Anatomy,
    /// The planner that scales the contacts to each model.
    pub(super) planner: TransferPlanner,
    pub(super) generic: GenericModel,
    /// The caller's map from bodies of the reference to bodies of the models.
    pub(super) maps: Vec<BodyMap>,
    /// The names of all forces of the reference, each with the names of its moving spheres; none if spheres are mirrored. The force of a new
    /// contact may have another name.
    pub(super) forces: Vec<(String, Vec<String>)>,
}

impl FromReference {
    /// The plan that scales the contacts to `base`, and `base` with the contacts as they are in the reference.
    pub(super) fn plan(&self, base: &Model) -> Result<(Plan, RebuiltModel), AddFault> {
        let mut layout = self.layout.clone();
        self.refuse_missing_bodies(base)?;
        let (rebuilt, selected) = with_contacts(base, &mut layout)?;
        let built = rebuilt.model();
        let known = &self.planner.reference;
        let mut reference = reference_of_model(built, &selected, known.mass.clone(), known.sphere_count)?;
        reference.name.clone_from(&known.name);
        reference.gravity_m_s2 = known.gravity_m_s2;
        let mut anatomy = layout.anatomy(self.anatomy.clone());
        // If two models have no common joint, their joints do not determine factors of bodies.
        anatomy.is_fragment |= !built.joints().iter().any(|joint| anatomy.joint(&joint.name).is_some());
        let generic = self.generic.with_contacts(anatomy, built);
        let mut plan = self.planner.plan_with_reference(built, &selected, &reference, Some(&generic))?;
        // A reference for `add` usually is another model.
        plan.findings.retain(|finding| finding.code() != FindingCode::NotAScaledCopy);
        Ok((plan, rebuilt))
    }

    /// A pattern that chooses the forces of spheres on bodies which the model has, and no other force of the reference: one for a side, or
    /// their names. `None` if no choice of forces leaves out the spheres on the bodies `missing` and no others.
    fn pattern_of_others(&self, missing: &BTreeSet<&str>) -> Option<String> {
        const SIDES: [&str; 10] =
            ["*_r", "*_l", "*[Rr]ight*", "*[Ll]eft*", "*_r*", "*_l*", "r_*", "l_*", "R*", "L*"];
        let kept = self.layout.contacts.iter().filter(|contact| !missing.contains(contact.body.as_str()));
        let kept: HashSet<&str> = kept.map(|contact| contact.sphere.as_str()).collect();
        let are_kept = |spheres: &[String]| spheres.iter().all(|sphere| kept.contains(sphere.as_str()));
        let (chosen, left): (Vec<_>, Vec<_>) = self.forces.iter().partition(|(_, spheres)| are_kept(spheres));
        // One force may press spheres of both sides.
        let is_choice = self.layout.contacts.iter().all(|contact| {
            let forces = if kept.contains(contact.sphere.as_str()) { &chosen } else { &left };
            forces.iter().any(|(_, spheres)| spheres.contains(&contact.sphere))
        });
        let names: Vec<&str> = chosen.iter().map(|(name, _)| name.as_str()).collect();
        if names.is_empty() || !is_choice {
            return None;
        }
        let chooses = |text: &String| {
            let Ok(pattern) = text.parse::<Pattern>() else { return false };
            names.iter().all(|name| pattern.matches(name))
                && !left.iter().any(|(name, _)| pattern.matches(name))
        };
        let all_names = format!("{{{}}}", names.join(","));
        SIDES.into_iter().map(str::to_owned).chain([all_names]).find(chooses)
    }

    /// Refuses a model without one of the bodies that get spheres.
    fn refuse_missing_bodies(&self, model: &Model) -> Result<(), AddFault> {
        let bodies_of_model: HashSet<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
        let all = self.layout.contacts.iter().map(|contact| contact.body.as_str());
        let missing: BTreeSet<&str> = all.filter(|body| !bodies_of_model.contains(body)).collect();
        let map_to_missing = self.maps.iter().find(|map| missing.contains(map.model.as_str()));
        if let Some(BodyMap { reference, model: body, .. }) = map_to_missing {
            let bodies: Vec<&str> = model.bodies().iter().map(|body| body.name.as_str()).collect();
            let message = phrase![
                Input::BodyMap.with_value(format!("{reference}={body}")),
                format!(": the model has no body {body}, it has {}", bodies.join(", ")),
            ];
            return Err(AddFault::OutsideModel("no-such-body", message));
        }
        if missing.is_empty() {
            return Ok(());
        }
        let others = self.pattern_of_others(&missing);
        let bodies = missing.into_iter().map(str::to_owned).collect();
        Err(Fault::new(FaultKind::MissingCarriers { bodies, others }).into())
    }
}

/// The request that scales the new contacts from the reference to the model.
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
        NewRadius::Follow => Some(Radius::FOLLOW),
        NewRadius::Isometric => Some(Radius::from(RadiusRule::Isometric)),
    };
    transfer
}

/// The contacts of the reference, with the class of force and the friction that the request wants.
pub(super) fn wanted_contacts(
    request: &AddRequest,
    model: &Model,
    selected: &Selected,
) -> Result<ContactLayout, Fault> {
    let mut layout = ContactLayout::of(model, selected)?;
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

/// Refuses a map of a body that the reference does not have, or two maps of one body.
pub(super) fn refuse_bad_maps(
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
        let written_map = Input::BodyMap.with_value(format!("{}={}", map.reference, map.model));
        let why = if !bodies.contains(map.reference.as_str()) {
            let carriers: Vec<&str> = carriers.iter().copied().collect();
            format!(
                ": the reference has no body {}, its spheres are on {}",
                map.reference,
                carriers.join(", ")
            )
        } else if request.body_map.iter().take(index).any(|other| other.reference == map.reference) {
            format!(": {} is already assigned to another body", map.reference)
        } else {
            continue;
        };
        return Err(RequestFault::refused(Input::BodyMap, phrase![written_map, why]));
    }
    Ok(())
}

/// The contacts of the reference on the bodies of the model; the skeleton of the reference with the names of the model's bodies; and
/// remarks.
pub(super) fn layout(
    request: &AddRequest,
    model: &Model,
    selected: &Selected,
) -> Result<(ContactLayout, Anatomy, Vec<Phrase>), Fault> {
    let mut layout = wanted_contacts(request, model, selected)?;
    let mut anatomy = Anatomy::of(model)?;
    let mut remarks = Vec::new();
    for map in &request.body_map {
        anatomy = with_mapped_body(&mut layout, anatomy, map, &mut remarks)?;
    }
    if request.mirror.is_some() {
        layout = layout.mirrored()?;
        anatomy = layout.mirrored_anatomy(anatomy);
    }
    let anatomy = layout.anatomy(anatomy);
    Ok((layout, anatomy, remarks))
}

/// Moves the contacts on one body of the reference to another body.
fn with_mapped_body(
    layout: &mut ContactLayout,
    mut anatomy: Anatomy,
    BodyMap { reference, model: body, .. }: &BodyMap,
    remarks: &mut Vec<Phrase>,
) -> Result<Anatomy, Fault> {
    let contacts_of_body = layout.contacts.iter_mut().filter(|contact| contact.body == *reference);
    if !anatomy.has_body(body) {
        anatomy = anatomy.with_renamed_body(reference, body);
        contacts_of_body.for_each(|contact| contact.body.clone_from(body));
        return Ok(anatomy);
    }
    for contact in contacts_of_body {
        let place = anatomy.point_seen_from(body, reference, contact.location_m).ok_or_else(|| {
            Fault::refused(format!(
                "no joints lead from {body} down to {reference} in the reference, or a joint between them is not understood: only a body above {reference} can take its spheres"
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

/// Opens the reference: a preset with places of spheres and this name, else a file. The flag says whether the reference is a file.
pub(super) fn open_reference(from: &Path, files: &dyn Files) -> Result<(OpenModel, bool)> {
    if let Some(preset) = placed_preset(from)? {
        return Ok((preset, false));
    }
    let NamedSource::Preset(preset) = NamedSource::find(from, Some(Input::From), None, files)? else {
        return Ok((open(from, files)?, true));
    };
    let known: Vec<&str> = presets_with_places().collect();
    let message = phrase![
        "{} {}: nobody published where its spheres are; expected a model, or one of: {}";
        Input::From, preset.name.to_string(), known.join(", ")
    ];
    Err(RequestFault::refused(Input::From, message).into())
}

/// The model `base` with the contacts of `layout`, and the forces of these contacts.
///
/// # Errors
/// Contacts of `base` that stay are on bodies that get new ones: both would carry the weight.
pub(super) fn with_contacts(
    base: &Model,
    layout: &mut ContactLayout,
) -> Result<(RebuiltModel, Selected), Fault> {
    let bodies: HashSet<&str> = layout.contacts.iter().map(|contact| contact.body.as_str()).collect();
    let is_there = |force: &Force| {
        let mut spheres = force.spheres().iter().filter_map(|&id| base.sphere(id)?.body.as_deref());
        base.meets_half_space(force) && spheres.any(|body| bodies.contains(body))
    };
    let doubled = Selected::matching(base, is_there);
    if !doubled.forces.is_empty() {
        let forces = base.short_force_names(&doubled.forces);
        return Err(Fault::new(FaultKind::ContactsExist { forces, can_scale: true }));
    }
    let rebuilt = add_contacts(base, layout)?;
    let new_forces: HashSet<&str> = layout.contacts.iter().map(|contact| contact.force.as_str()).collect();
    let selected = Selected::matching(rebuilt.model(), |force| new_forces.contains(force.name.as_str()));
    Ok((rebuilt, selected))
}
