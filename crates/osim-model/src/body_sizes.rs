//! How large the bones are: mesh scale factors of the bodies that carry contact spheres.

use std::collections::BTreeSet;

use crate::anatomy::meshes;
use crate::model::Model;
use crate::note::BodySize;

/// Sizes closer than this (relative) are one size.
const SAME_SIZE: f64 = 1e-6;

impl BodySize {
    /// Whether the body is as large as `other`.
    #[must_use]
    pub fn is_as_large_as(&self, other: &Self) -> bool {
        let close = |(a, b): (f64, f64)| (a - b).abs() <= SAME_SIZE * b.abs();
        self.factors.into_iter().zip(other.factors).all(close)
    }
}

impl Model {
    /// Mesh scale factors of the bodies that carry the spheres of contact forces, by name; bodies without meshes, or with a
    /// name that a note cannot hold, are left out. Of several meshes the first counts, in the order of their names.
    #[must_use]
    pub fn body_sizes(&self) -> Vec<BodySize> {
        let spheres = self.forces().iter().flat_map(|force| force.spheres());
        let carrying: BTreeSet<&str> = spheres
            .filter_map(|sphere| self.sphere(sphere)?.body.as_deref())
            .filter(|name| BodySize::can_name(name))
            .collect();
        let components = self.components();
        let bodies = components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body");
        let mut sizes: Vec<BodySize> = bodies
            .filter_map(|(id, _)| {
                let body = components.name(id);
                if !carrying.contains(body.as_str()) {
                    return None;
                }
                let factors = *meshes(components, id).values().next()?;
                factors.iter().all(|factor| *factor > 0.0).then_some(BodySize { body, factors })
            })
            .collect();
        sizes.sort_by(|a, b| a.body.cmp(&b.body));
        sizes.dedup_by(|a, b| a.body == b.body);
        sizes
    }
}
