//! The remedies of a rule about places: spheres follow their bodies.

use osim_model::Model;
use osim_model::compare::{Placement, is_stretched};
use osim_model::messages::Verb;
use osim_requests::options::{FollowOptions, MovedChoice, ScalingOptions};
use osim_requests::{Kilograms, Request, RescaleRequest, TransferRequest};

use crate::findings::{Remedies, rounded};

/// The model's own contacts at the mass of its body, on spheres that follow it by the sizes in the note.
pub(crate) fn by_note(remedies: &Remedies<'_>, model: &Model) -> Option<Request> {
    let since = model.scaled_since_note().filter(|_| model.doubt_about_note().is_none())?;
    if !since.has_all_carriers(model) {
        return None;
    }
    // What the model weighs otherwise is for the user to say.
    let target_mass_kg = rounded(remedies.body_kg.filter(|_| remedies.load.masses.mass.is_none())?);
    // A rescaling since then may have changed radii, and bottoms with them.
    let untouched = model.note.as_ref().is_some_and(|note| note.operation() == Verb::Note.name());
    let level = untouched && !since.factors.values().any(|factors| is_stretched(*factors));
    Some(
        RescaleRequest {
            models: remedies.models(true)?,
            target_mass: Some(Kilograms::new(target_mass_kg).ok()?),
            follow_bodies: true,
            scaling: ScalingOptions { level, ..ScalingOptions::default() },
            masses: remedies.load.masses.clone(),
            choice: remedies.choice(),
            set_files: remedies.set_files(),
            ..RescaleRequest::default()
        }
        .into(),
    )
}

/// Contacts of the model that OpenSim scaled, on spheres that follow their bodies.
pub(crate) fn by_original(remedies: &Remedies<'_>, placement: &Placement) -> Option<Request> {
    if !placement.can_follow() {
        return None;
    }
    let follow = FollowOptions {
        follow_bodies: true,
        body_scale_file: placement.body_scale_file.clone(),
        moved_spheres: placement.has_resized().then_some(MovedChoice::Replace),
        ..FollowOptions::default()
    };
    let scaling = ScalingOptions { level: placement.suits_level, ..ScalingOptions::default() };
    Some(TransferRequest { follow, scaling, ..remedies.transfer(placement.from.clone())? }.into())
}
