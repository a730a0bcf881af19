//! Whether a coordinate is free, or what keeps it at its value.

use crate::model::{JointCoordinate, Model, ModelJoint};
use foldhash::HashSet;

use crate::feet::couplers::{dependent_coordinates, is_prescribed};

/// What keeps a coordinate at its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Held {
    /// Nothing: it is free.
    Not,
    /// It is locked.
    Locked,
    /// A function of time, or another coordinate, sets it.
    Driven,
}

/// Knows of each coordinate of a model what keeps it.
pub(crate) struct HeldCoordinates<'m> {
    model: &'m Model,
    dependent: HashSet<String>,
}

impl<'m> HeldCoordinates<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        Self { model, dependent: dependent_coordinates(model) }
    }

    /// What keeps a coordinate of `joint`.
    pub(crate) fn held(&self, joint: &ModelJoint, coordinate: &JointCoordinate) -> Held {
        let document = self.model.file(joint.file);
        if matches!(document.flag(coordinate.element, "locked"), Ok(Some(true))) {
            Held::Locked
        } else if self.dependent.contains(&coordinate.name) || is_prescribed(document, coordinate.element) {
            Held::Driven
        } else {
            Held::Not
        }
    }
}
