//! Findings about the places of spheres: from the model that was scaled where it is at hand, else from this file alone.

use osim_model::{Finding, Model};

use super::remedy::Remedies;
use crate::inspection::Inspection;
use crate::placement::{Evidence, NotedSizes, Placement};

/// What is known of the places of spheres.
pub(super) enum Places<'i> {
    Compared(&'i Placement),
    Alone(Evidence),
}

/// What the note in the file says about sizes: the note has none yet.
fn noted_sizes(_model: &Model) -> Option<NotedSizes> {
    None
}

impl<'i> Places<'i> {
    pub(super) fn of(model: &Model, inspected: &'i Inspection) -> Self {
        match &inspected.placement {
            Some(placement) => Self::Compared(placement),
            None => Self::Alone(Evidence::of(model, noted_sizes(model))),
        }
    }

    /// Spheres are where they should not be.
    pub(super) fn are_wrong(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_wrong(),
            Self::Alone(evidence) => evidence.is_wrong(),
        }
    }

    /// They are certain to be where they were before their bodies were scaled.
    pub(super) fn were_left_behind(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.was_left_behind(),
            Self::Alone(evidence) => matches!(evidence, Evidence::Note(_) | Evidence::OtherSize(_)),
        }
    }

    /// They are known to be where they belong.
    pub(super) fn are_right(&self) -> bool {
        match self {
            Self::Compared(placement) => placement.is_right(),
            Self::Alone(evidence) => evidence.is_right(),
        }
    }

    pub(super) fn findings(&self, model: &Model, remedies: &Remedies<'_>) -> Vec<Finding> {
        match self {
            Self::Alone(evidence) => evidence.finding(model).into_iter().collect(),
            Self::Compared(placement) => {
                let found = placement.findings().into_iter();
                found.map(|finding| finding.with_remedy(remedies.follow(placement))).collect()
            }
        }
    }
}
