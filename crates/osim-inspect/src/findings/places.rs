//! Findings about the places of spheres: from the model that was scaled if it was given, else from this file alone.

use osim_model::compare::{Evidence, Placement};
use osim_model::{Finding, FindingCode, Model, Note, ScaledSinceNote};

use super::found::Found;
use super::remedy::Remedies;
use crate::inspection::Inspection;
use crate::rules::spheres_left_behind;

/// What is known of the places of spheres.
pub(super) enum Places<'i> {
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
#[must_use]
pub fn misplaced_spheres(model: &Model) -> Option<Finding> {
    let evidence = Evidence::of(model, noted_sizes(model));
    evidence.is_wrong().then(|| evidence.finding(model)).flatten()
}

impl<'i> Places<'i> {
    pub(super) fn of(model: &Model, inspected: &'i Inspection) -> Self {
        match &inspected.placement {
            Some(placement) if placement.unknown.is_none() => Self::Compared(placement),
            Some(placement) => Self::NotCompared(placement, Evidence::of(model, noted_sizes(model))),
            None => Self::Alone(Evidence::of(model, noted_sizes(model))),
        }
    }

    /// Spheres are where they should not be.
    pub(super) fn are_wrong(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_wrong(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => evidence.is_wrong(),
        }
    }

    /// They are certain to be where they were before their bodies were scaled.
    pub(super) fn were_left_behind(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.was_left_behind(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => {
                matches!(evidence, Evidence::Note(_) | Evidence::OtherSize(_))
            }
        }
    }

    /// They are known to be where they belong.
    pub(super) fn are_right(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_right(),
            Self::Alone(evidence) | Self::NotCompared(_, evidence) => evidence.is_right(),
        }
    }

    pub(super) fn findings(&self, model: &Model, remedies: &Remedies<'_>) -> Vec<Found> {
        match self {
            Self::Alone(evidence) => {
                let is_noted = matches!(evidence, Evidence::Note(_));
                let remedy = || is_noted.then(|| spheres_left_behind::by_note(remedies, model)).flatten();
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
                found
                    .map(|finding| Found::new(finding, spheres_left_behind::by_original(remedies, placement)))
                    .collect()
            }
        }
    }
}
