//! The contacts of the model that another one was made from: they show which side of it was changed.

use foldhash::HashMap;
use osim_model::messages::shown;
use osim_model::{BothSides, Force, Model, Side, Value};

/// The numbers of a reference's contact forces.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceContacts {
    name: String,
    /// Values of the parameter sets, by the name of the force.
    numbers: HashMap<String, Vec<f64>>,
}

impl ReferenceContacts {
    /// Those of `model`; `name` is what messages call it.
    #[must_use]
    pub fn of(name: &str, model: &Model) -> Self {
        let numbers = model.forces().iter().map(|force| (force.name.clone(), numbers(force))).collect();
        Self { name: name.to_owned(), numbers }
    }

    /// What messages call the reference.
    pub(crate) fn title(&self) -> String {
        shown(&self.name).to_string()
    }

    /// The side whose forces have the numbers of the reference, where those of the other side have others.
    pub(crate) fn side(&self, model: &Model, sides: &BothSides<'_>) -> Option<Side> {
        let is_as_here = |side| {
            let forces = sides.forces_on(side);
            let mut all = forces.iter().filter_map(|&id| model.force(id)).peekable();
            all.peek().is_some() && all.all(|force| self.numbers.get(&force.name) == Some(&numbers(force)))
        };
        match (is_as_here(Side::Right), is_as_here(Side::Left)) {
            (true, false) => Some(Side::Right),
            (false, true) => Some(Side::Left),
            _ => None,
        }
    }
}

fn numbers(force: &Force) -> Vec<f64> {
    force.sets.iter().flat_map(|set| &set.values).map(|value: &Value| value.number).collect()
}
