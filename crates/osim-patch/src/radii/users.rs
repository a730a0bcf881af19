//! Spheres that other forces need as they are.

use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::{Fault, ForceId, Model, Needed, RadiusFrom, SphereId};

/// Forces that use a sphere and are not changed with it.
pub(crate) struct Users<'m> {
    forces: HashMap<SphereId, Vec<&'m str>>,
    /// By sphere name: contact classes that are not Hertz's.
    others: HashMap<String, Vec<String>>,
}

impl<'m> Users<'m> {
    pub(crate) fn outside(model: &'m Model, chosen: &[ForceId]) -> Self {
        let chosen: HashSet<ForceId> = chosen.iter().copied().collect();
        let mut forces: HashMap<SphereId, Vec<&str>> = HashMap::new();
        for force in model.forces() {
            if force.applies && !chosen.contains(&force.id) {
                for sphere in force.spheres() {
                    forces.entry(sphere).or_default().push(&force.name);
                }
            }
        }
        Self { forces, others: model.users_of_other_classes() }
    }

    /// A radius may change only if every applied force that uses the sphere changes with it.
    pub(crate) fn refuse(
        &self,
        model: &Model,
        chosen: &[ForceId],
        sphere: SphereId,
        radius: RadiusFrom,
    ) -> Result<(), Fault> {
        let Some(shared) = model.sphere(sphere) else { return Ok(()) };
        let mut left: Vec<&str> = self.forces.get(&sphere).cloned().unwrap_or_default();
        let forces = left.len();
        left.extend(self.others.get(&shared.name).into_iter().flatten().map(String::as_str));
        if left.is_empty() {
            return Ok(());
        }
        let uses = |&id: &ForceId| model.force(id).is_some_and(|force| force.spheres().contains(&sphere));
        let changed: Vec<ForceId> = chosen.iter().copied().filter(uses).collect();
        let needed = Needed::SharedSphere {
            sphere: shared.path.clone(),
            changed: model.names_of(&changed),
            can_choose: left.len() == forces,
            radius,
            left: left.into_iter().map(str::to_owned).collect(),
        };
        Err(Fault::at(needed, shared.radius.offset).of(shared.path.clone()).in_file(shared.file))
    }
}
