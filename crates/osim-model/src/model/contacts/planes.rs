//! The half-spaces of a model, and those on which a force presses its spheres.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::force::{Force, ParameterSet};
use super::half_space::HalfSpace;
use super::read::FIRST_CONSTANT;
use crate::model::components::{ComponentId, Components};
use crate::model::typed_model::Model;

/// How a half-space inside a force is turned that says nothing of it: a floor, rad. The first version of the class, which had another
/// name for `constant_contact_force`, did not turn it.
const FLOOR: [f64; 3] = [0.0, 0.0, -std::f64::consts::FRAC_PI_2];

impl Model {
    /// All half-spaces whose frame can be found, in file order.
    #[must_use]
    pub fn half_spaces(&self) -> Vec<HalfSpace> {
        self.planes().values().map(|plane| HalfSpace::clone(plane)).collect()
    }

    /// The same by component, read when somebody first asks: many forces press on one floor.
    fn planes(&self) -> &BTreeMap<ComponentId, Arc<HalfSpace>> {
        self.half_spaces.get_or_init(|| {
            let components = self.components();
            let planes = components.tree.iter().filter(|(id, _)| components.tag(*id) == "ContactHalfSpace");
            planes.filter_map(|(id, _)| Some((id, Arc::new(read(components, id)?)))).collect()
        })
    }

    /// The half-spaces on which `force` presses its spheres, each once: those among its surfaces, and the one that a force of Moco
    /// 0.1 to 0.3 keeps inside itself.
    #[must_use]
    pub fn planes_of(&self, force: &Force) -> Vec<Arc<HalfSpace>> {
        let mut planes: Vec<Arc<HalfSpace>> = Vec::new();
        for set in &force.sets {
            for plane in self.shared_planes_of_set(set) {
                if !planes.contains(&plane) {
                    planes.push(plane);
                }
            }
        }
        planes
    }

    /// The half-spaces among the surfaces of a parameter set, in its order, and the one that its force keeps inside itself.
    #[must_use]
    pub fn planes_of_set(&self, set: &ParameterSet) -> Vec<HalfSpace> {
        self.shared_planes_of_set(set).map(|plane| HalfSpace::clone(&plane)).collect()
    }

    fn shared_planes_of_set(&self, set: &ParameterSet) -> impl Iterator<Item = Arc<HalfSpace>> {
        let own = set.half_space_components.iter().filter_map(|id| self.planes().get(id).cloned());
        let inside = set.half_space_inside.and_then(|id| inside(self.components(), id));
        own.chain(inside.map(Arc::new))
    }

    /// The half-spaces that forces of Moco 0.1 to 0.3 keep inside themselves, in file order.
    pub(crate) fn half_spaces_inside(&self) -> impl Iterator<Item = HalfSpace> + '_ {
        let sets = self.forces().iter().flat_map(|force| &force.sets);
        sets.filter_map(|set| inside(self.components(), set.half_space_inside?))
    }

    /// The half-spaces among the surfaces of a parameter set, in its order; not one that its force keeps inside itself.
    #[must_use]
    pub fn half_spaces_of(&self, set: &ParameterSet) -> Vec<HalfSpace> {
        let planes = set.half_space_components.iter().filter_map(|id| self.planes().get(id));
        planes.map(|plane| HalfSpace::clone(plane)).collect()
    }
}

fn read(components: &Components, id: ComponentId) -> Option<HalfSpace> {
    HalfSpace::read(components, id, ("frame", &["body_name"]), ("location", "orientation", [0.0; 3]))
}

/// The half-space that a force of Moco 0.1 to 0.3 keeps inside itself.
fn inside(components: &Components, force: ComponentId) -> Option<HalfSpace> {
    let tree = components.doc(force).tree();
    let is_first = tree.child(components.element(force), FIRST_CONSTANT).is_some();
    let turned = if is_first { [0.0; 3] } else { FLOOR };
    let place = ("contact_half_space_location", "contact_half_space_orientation", turned);
    HalfSpace::read(components, force, ("half_space_frame", &[]), place)
}
