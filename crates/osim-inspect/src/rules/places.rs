//! Findings about the places of spheres: from the model that was scaled if it was given, else from this file alone.

use osim_model::compare::{Evidence, Placement, is_stretched};
use osim_model::messages::Verb;
use osim_model::{Finding, FindingCode, Model, Note, ScaledSinceNote};
use osim_requests::options::{FollowOptions, MovedChoice, ScalingOptions};
use osim_requests::{Kilograms, Request, RescaleRequest, TransferRequest};

use crate::findings::{Found, Remedies, rounded};
use crate::inspection::Inspection;

/// What is known of the places of spheres.
pub(crate) enum Places<'i> {
    Compared(&'i Placement),
    Alone(Evidence),
    /// They cannot be compared: what this file alone shows.
    NotCompared(&'i Placement, Evidence),
}

/// What the note in the file says about sizes, where that settles it: bodies were scaled since, or the spheres were placed with
/// their bodies when it was written.
fn noted_sizes(model: &Model) -> Option<ScaledSinceNote> {
    let since = model.scaled_since_note()?;
    let placed = model.note.as_ref().is_some_and(Note::placed);
    (since.is_scaled() || placed).then_some(since)
}

/// What one file alone shows of spheres that are where they should not be: for changes that leave them there.
pub fn misplaced_spheres(model: &Model) -> Option<Finding> {
    let evidence = Evidence::of(model, noted_sizes(model));
    evidence.is_wrong().then(|| evidence.finding(model)).flatten()
}

impl<'i> Places<'i> {
    pub(crate) fn of(model: &Model, inspected: &'i Inspection) -> Self {
        match &inspected.placement {
            Some(placement) if placement.unknown.is_none() => Self::Compared(placement),
            Some(placement) => Self::NotCompared(placement, Evidence::of(model, noted_sizes(model))),
            None => Self::Alone(Evidence::of(model, noted_sizes(model))),
        }
    }

    /// Spheres are where they should not be.
    pub(crate) fn are_wrong(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_wrong(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => evidence.is_wrong(),
        }
    }

    /// They are certain to be where they were before their bodies were scaled.
    pub(crate) fn were_left_behind(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.was_left_behind(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => {
                matches!(evidence, Evidence::Note(_) | Evidence::OtherSize(_))
            }
        }
    }

    /// They are known to be where they belong.
    pub(crate) fn are_right(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_right(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => evidence.is_right(),
        }
    }

    pub(crate) fn findings(&self, model: &Model, remedies: &Remedies<'_>) -> Vec<Found> {
        match self {
            Self::Alone(evidence) => {
                let is_noted = matches!(evidence, Evidence::Note(_));
                let remedy = || is_noted.then(|| follow_by_note(remedies, model)).flatten();
                evidence.finding(model).into_iter().map(|finding| Found::new(finding, remedy())).collect()
            }
            Self::NotCompared(placement, evidence) => {
                let alone = Self::Alone(evidence.clone()).findings(model, remedies);
                // If the file shows nothing, one finding says that it cannot be compared.
                let shown = alone.into_iter().filter(|one| one.code() != FindingCode::SpheresNotCompared);
                placement.findings().into_iter().map(Found::from).chain(shown).collect()
            }
            Self::Compared(placement) => {
                let found = placement.findings().into_iter();
                found.map(|finding| Found::new(finding, follow_by_original(remedies, placement))).collect()
            }
        }
    }
}

/// The model's own contacts at the mass of its body, on spheres that follow it by the sizes in the note.
fn follow_by_note(remedies: &Remedies<'_>, model: &Model) -> Option<Request> {
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
fn follow_by_original(remedies: &Remedies<'_>, placement: &Placement) -> Option<Request> {
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
