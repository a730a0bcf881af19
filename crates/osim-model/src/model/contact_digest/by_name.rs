//! Digests in notes of earlier versions: of numbers together with the names of what has them.

use sha2::{Digest, Sha256};

use super::first_digits;
use crate::model::contacts::Force;
use crate::model::property::Property;
use crate::model::typed_model::Model;

impl Model {
    /// Parameters of every contact force and radii of their spheres, with their paths.
    pub(super) fn contact_digest_by_name(&self) -> String {
        let mut hash = Sha256::new();
        let mut feed = |path: &str, set: usize, property: Property, number: f64| {
            hash.update(path.as_bytes());
            hash.update([0]);
            hash.update((set as u64).to_le_bytes());
            hash.update(property.name().as_bytes());
            hash.update(number.to_bits().to_le_bytes());
        };
        for force in self.forces() {
            for (index, set) in force.sets.iter().enumerate() {
                set.values.iter().for_each(|value| feed(&force.path, index, value.property, value.number));
            }
            let value = &force.transition_velocity;
            feed(&force.path, 0, value.property, value.number);
            for sphere in force.spheres().into_iter().filter_map(|sphere| self.sphere(sphere)) {
                feed(&sphere.path, 0, Property::Radius, sphere.radius.number);
            }
        }
        first_digits(hash)
    }

    /// Radii of all spheres of contact forces, with their paths.
    pub(super) fn radii_digest_by_name(&self) -> String {
        let mut hash = Sha256::new();
        for sphere in self.forces().iter().flat_map(Force::spheres).filter_map(|sphere| self.sphere(sphere)) {
            hash.update(sphere.path.as_bytes());
            hash.update([0]);
            hash.update(sphere.radius.number.to_bits().to_le_bytes());
        }
        first_digits(hash)
    }

    /// Locations of all spheres of contact forces, with their paths.
    pub(super) fn places_digest_by_name(&self) -> String {
        let mut hash = Sha256::new();
        for sphere in self.forces().iter().flat_map(Force::spheres).filter_map(|sphere| self.sphere(sphere)) {
            hash.update(sphere.path.as_bytes());
            hash.update([0]);
            for coordinate in sphere.location_m {
                // -0 and 0 are one place.
                hash.update((coordinate + 0.0).to_bits().to_le_bytes());
            }
        }
        first_digits(hash)
    }
}
