//! Contacts as a reference has them, on the bodies that take them here.

use std::collections::{BTreeSet, HashSet};
use std::path::Path;

use osim_model::files::{Files, OpenModel};
use osim_model::messages::{Input, Phrase, phrase};
use osim_model::{Anatomy, Fault, FaultKind, FindingCode, Model, RadiusRule, Selected};
use osim_patch::{Layout, Plan, Rebuilt, presets_with_places, reference_of_model};
use osim_requests::{AddRequest, BodyMap, NewRadius, Radius, RequestError, RequestFault, TransferRequest};

use super::fault::AddFault;
use super::made::added;
use crate::opening::{Named, open, placed_preset};
use crate::verbs::reference::Generic;
use crate::verbs::transferring::Transferring;

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
                Input::BodyMap.being(format!("{reference}={body}")),
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

/// The same as a transfer, after the contacts were made: as the reference has them, or at places of this model's own.
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
        let said = Input::BodyMap.being(format!("{}={}", map.reference, map.model));
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
        anatomy = anatomy.with_name(reference, body);
        own.for_each(|contact| contact.body.clone_from(body));
        return Ok(anatomy);
    }
    for contact in own {
        let place = anatomy.seen_from(body, reference, contact.location_m).ok_or_else(|| {
            Fault::refused(format!(
                "{reference} does not hang on {body} in the reference, or a joint between them is not understood: its spheres can be \
                 taken by a body above it only"
            ))
        })?;
        contact.location_m = place;
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
