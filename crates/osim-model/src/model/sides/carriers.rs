//! Spheres on limbs: those of forces that meet a floor, by body and side.

use std::collections::BTreeMap;

use foldhash::{HashSet, HashSetExt};

use crate::model::contacts::{Force, ParameterSet, Sphere, SphereId};
use crate::model::side::Side;
use crate::model::typed_model::Model;

/// Places that are this close on one body are one place, m.
pub(crate) const SAME_PLACE_M: f64 = 1e-6;

/// A sphere that meets a floor, and where it is on its body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<'m> {
    pub sphere: &'m Sphere,
    pub body: &'m str,
    pub side: Side,
    pub place_m: [f64; 3],
}

/// The parameter sets by which each sphere meets a floor, in file order.
#[derive(Debug)]
pub(crate) struct Users<'m>(BTreeMap<SphereId, Vec<(&'m Force, &'m ParameterSet)>>);

impl<'m> Users<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        let mut users: BTreeMap<SphereId, Vec<_>> = BTreeMap::new();
        for force in model.forces().iter().filter(|force| model.meets_half_space(force)) {
            for set in &force.sets {
                set.spheres.iter().for_each(|&sphere| users.entry(sphere).or_default().push((force, set)));
            }
        }
        Self(users)
    }

    pub(crate) fn of_sphere(&self, sphere: SphereId) -> &[(&'m Force, &'m ParameterSet)] {
        self.0.get(&sphere).map(Vec::as_slice).unwrap_or_default()
    }

    /// Whether some force of `sphere` is switched on.
    pub(crate) fn applies(&self, sphere: SphereId) -> bool {
        self.of_sphere(sphere).iter().any(|(force, _)| force.applies)
    }

    /// The moving spheres, in file order, with their places on their bodies.
    pub(crate) fn spheres(&self, model: &'m Model) -> impl Iterator<Item = (&'m Sphere, &'m str, [f64; 3])> {
        let spheres = self.0.keys().filter_map(|&id| model.sphere(id)).filter(|sphere| !sphere.fixed);
        spheres.filter_map(|sphere| Some((sphere, sphere.body.as_deref()?, model.centre_m(sphere.id)?)))
    }

    /// Those on bodies whose name has a side. Of several at one place the first counts.
    pub(crate) fn on_sides(&self, model: &'m Model) -> Vec<Placed<'m>> {
        let mut seen = HashSet::new();
        let on_side = |(sphere, body, place_m)| {
            let side = Side::of_name(body)?;
            seen.insert((body, place_key(place_m))).then_some(Placed { sphere, body, side, place_m })
        };
        self.spheres(model).filter_map(on_side).collect()
    }
}

/// Equal for places that are one.
#[expect(clippy::cast_possible_truncation, reason = "a cast of a float ends at the largest number")]
pub(crate) fn place_key(place_m: [f64; 3]) -> [i64; 3] {
    place_m.map(|value| (value / SAME_PLACE_M).round() as i64)
}
