//! What is special about forces without being wrong. A check says it of every force, a change of those that it changes.

use super::{disabled_force, mixed_radii, several_parameter_sets};
use crate::model::contacts::ForceId;
use crate::model::finding::Finding;
use crate::model::typed_model::Model;

impl Model {
    /// What is special about `forces` without being wrong, in the order of the codes.
    #[must_use]
    pub fn remarks_on(&self, forces: &[ForceId]) -> Vec<Finding> {
        let forces = || forces.iter().filter_map(|&id| self.force(id));
        let mut found: Vec<Finding> =
            forces().filter_map(|force| mixed_radii::of_force(self, force)).collect();
        found.extend(forces().filter_map(several_parameter_sets::of_force));
        found.extend(forces().filter_map(disabled_force::of_force));
        found
    }
}
