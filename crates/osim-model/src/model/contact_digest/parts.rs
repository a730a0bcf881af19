//! What contacts are called, and a digest of each of their properties: the record by which a note shows what changed.

use std::collections::BTreeMap;

use foldhash::HashSet;
use sha2::{Digest, Sha256};

use super::{ValueKey, digits, first_digits};
use crate::model::contacts::{Force, SphereId};
use crate::model::note::{NotedNames, NotedParts};
use crate::model::property::Property;
use crate::model::typed_model::Model;

/// Bytes of the digest of one property: it only names what the digest of all numbers found to be different.
const BYTES_OF_PROPERTY: usize = 4;

impl Model {
    /// What a note records of the contacts beside the digests of all numbers. `changed` gives the new value of those that a plan
    /// changes.
    #[must_use]
    pub fn noted_parts(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> NotedParts {
        let mut seen: HashSet<SphereId> = HashSet::default();
        let spheres = self.forces().iter().flat_map(Force::spheres).filter(|&sphere| seen.insert(sphere));
        let spheres = spheres.filter_map(|sphere| self.sphere(sphere)).map(|sphere| sphere.name.as_str());
        let forces = self.forces().iter().map(|force| force.name.as_str());
        NotedParts {
            spheres: names(spheres.collect()),
            forces: names(forces.collect()),
            properties: self.property_digests(changed),
        }
    }

    /// A digest of the values of each property, in whatever order they are in the file.
    fn property_digests(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> BTreeMap<Property, String> {
        let mut values: BTreeMap<Property, Vec<u64>> = BTreeMap::new();
        for force in self.forces() {
            let own = (force.element, &force.transition_velocity);
            let of_sets =
                force.sets.iter().flat_map(|set| set.values.iter().map(|value| (set.element, value)));
            for (element, value) in of_sets.chain([own]) {
                let key = ValueKey::new(force.file, element, value.property);
                let number = changed(key).unwrap_or(value.number);
                values.entry(value.property).or_default().push(number.to_bits());
            }
        }
        let digest = |mut bits: Vec<u64>| {
            bits.sort_unstable();
            let mut hash = Sha256::new();
            bits.into_iter().for_each(|bits| hash.update(bits.to_le_bytes()));
            digits(hash, BYTES_OF_PROPERTY)
        };
        values.into_iter().map(|(property, bits)| (property, digest(bits))).collect()
    }
}

fn names(mut names: Vec<&str>) -> NotedNames {
    names.sort_unstable();
    let mut hash = Sha256::new();
    for name in &names {
        hash.update(name.as_bytes());
        hash.update([0]);
    }
    NotedNames { count: names.len(), digest: first_digits(hash) }
}
