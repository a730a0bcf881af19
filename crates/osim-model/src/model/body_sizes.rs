//! How large the bones are: mesh scale factors of the bodies that carry contact spheres.

use std::collections::{BTreeMap, BTreeSet};

use crate::model::contacts::{Sphere, moving_spheres};
use crate::model::note::{BodySize, Note};
use crate::model::typed_model::Model;

/// Places closer than this are one, m.
const SAME_PLACE_M: f64 = 1e-9;
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

/// How the bodies changed since the note was written, where the spheres are still where they were then: from
/// [`Model::scaled_since_note`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ScaledSinceNote {
    /// Mesh factors now over those in the note, along x, y and z, by body. Exactly 1 where they are equal.
    pub factors: BTreeMap<String, [f64; 3]>,
    left_behind: bool,
}

impl ScaledSinceNote {
    /// Whether some body has another size now, and a sphere of it belongs elsewhere.
    #[must_use]
    pub const fn is_scaled(&self) -> bool {
        self.left_behind
    }

    /// Whether every body that carries spheres of `model` has factors.
    #[must_use]
    pub fn has_all_carriers(&self, model: &Model) -> bool {
        let carriers = model.loaded_spheres(&model.force_ids());
        let mut bodies = carriers.iter().filter_map(|&id| model.sphere(id)?.body.as_ref());
        bodies.all(|body| self.factors.contains_key(body))
    }
}

impl Model {
    /// What OpenSim's scaling did to the bodies that carry spheres, from the note alone. `None` if there is no note with sizes,
    /// or spheres were moved since it was written.
    #[must_use]
    pub fn scaled_since_note(&self) -> Option<ScaledSinceNote> {
        let note = self.note.as_ref().filter(|note| !note.sizes.is_empty())?;
        if self.has_places_of(note) != Some(true) {
            return None;
        }
        let now = self.body_sizes();
        let now: BTreeMap<&str, &BodySize> = now.iter().map(|size| (size.body.as_str(), size)).collect();
        let ratios = note.sizes.iter().filter_map(|then| {
            let now = now.get(then.body.as_str())?;
            let ratio = std::array::from_fn(|axis| now.factors[axis] / then.factors[axis]);
            let factors = if now.is_as_large_as(then) { [1.0; 3] } else { ratio };
            Some((now.body.clone(), factors))
        });
        let factors: BTreeMap<String, [f64; 3]> = ratios.collect();
        let left_behind = moving_spheres(self, &self.force_ids()).into_iter().any(|id| {
            let Some(sphere) = self.sphere(id) else { return false };
            let factors = sphere.body.as_ref().and_then(|body| factors.get(body));
            factors.is_some_and(|factors| self.belongs_elsewhere(sphere, *factors))
        });
        Some(ScaledSinceNote { factors, left_behind })
    }

    /// Whether a body that carries spheres has other mesh factors than when `note` was written.
    pub(crate) fn bodies_have_other_sizes(&self, note: &Note) -> bool {
        let now = self.body_sizes();
        let same_body = |then: &BodySize| now.iter().find(|size| size.body == then.body);
        note.sizes.iter().any(|then| same_body(then).is_some_and(|now| !now.is_as_large_as(then)))
    }

    /// Whether a sphere is somewhere else once its place is multiplied by the factors of its body.
    fn belongs_elsewhere(&self, sphere: &Sphere, factors: [f64; 3]) -> bool {
        let Ok(rotation) = self.rotation_of(sphere) else { return false };
        let there = rotation.scaled_in_frame(factors, sphere.location_m);
        there.into_iter().zip(sphere.location_m).any(|(there, here)| (there - here).abs() > SAME_PLACE_M)
    }

    /// Mesh scale factors of the bodies that carry moving spheres of contact forces, by name; bodies without meshes, or with a
    /// name that a note cannot hold, are left out. Of several meshes the first counts, in the order of their names.
    #[must_use]
    pub fn body_sizes(&self) -> Vec<BodySize> {
        let spheres = moving_spheres(self, &self.force_ids()).into_iter();
        let carrying: BTreeSet<&str> = spheres
            .filter_map(|sphere| self.sphere(sphere)?.body.as_deref())
            .filter(|name| BodySize::can_name(name))
            .collect();
        let meshes = self.body_facts.mesh_factors(self.components());
        let size = |body: &str| {
            let factors = *meshes.get(body)?.values().next()?;
            factors
                .iter()
                .all(|factor| factor.is_finite() && *factor > 0.0)
                .then(|| BodySize { body: body.to_owned(), factors })
        };
        carrying.into_iter().filter_map(size).collect()
    }
}
