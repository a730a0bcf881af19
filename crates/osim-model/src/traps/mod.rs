//! Known traps of OpenSim and its users, looked for in every model that is read.

mod remarks;
mod sides;
mod structure;
mod values;

pub use sides::BothSides;

use crate::finding::Finding;
use crate::model::Model;

/// Everything that reading `model` showed, in the order in which reports list it.
pub(crate) fn find(model: &Model) -> Vec<Finding> {
    let all = [
        values::numbers,
        values::triples,
        structure::included_contacts,
        values::dead_elements,
        structure::several_spheres,
        structure::spheres_in_two_forces,
        values::default_stiffness,
        values::zero_constant_contact_force,
        sides::left_and_right,
        values::contact_defaults,
        structure::special_components,
        structure::loops_of_joints,
    ];
    all.into_iter().flat_map(|find| find(model)).collect()
}
