//! The contacts of the reference model that the caller names, and which side of another model still has them.

use foldhash::HashMap;
use osim_model::messages::shown;
use osim_model::{Force, Model, Side, Value};

use crate::sides::BothSides;

/// The contact parameters of a reference model. They show which side of another model still has the contacts of the reference.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceContacts {
    name: String,
    /// The values of all parameter sets of a force, by the name of the force.
    parameters: HashMap<String, Vec<f64>>,
}

impl ReferenceContacts {
    /// The contact parameters of `model`; messages call this model `name`.
    pub fn from_model(name: &str, model: &Model) -> Self {
        let parameters =
            model.forces().iter().map(|force| (force.name.clone(), values_of_all_sets(force))).collect();
        Self { name: name.to_owned(), parameters }
    }

    /// The name of the reference, as messages show it.
    pub(crate) fn title(&self) -> String {
        shown(&self.name).to_string()
    }

    /// The side whose forces have the parameters of the reference, if the forces of the other side have not.
    pub(crate) fn side_like_reference(&self, model: &Model, sides: &BothSides<'_>) -> Option<Side> {
        let is_as_reference = |side| {
            let forces = sides.forces_on(side);
            let mut all = forces.iter().filter_map(|&id| model.force(id)).peekable();
            all.peek().is_some()
                && all.all(|force| self.parameters.get(&force.name) == Some(&values_of_all_sets(force)))
        };
        match (is_as_reference(Side::Right), is_as_reference(Side::Left)) {
            (true, false) => Some(Side::Right),
            (false, true) => Some(Side::Left),
            _ => None,
        }
    }
}

/// The numbers of all parameter sets of a force, in order.
fn values_of_all_sets(force: &Force) -> Vec<f64> {
    force.sets.iter().flat_map(|set| &set.values).map(|value: &Value| value.number).collect()
}
