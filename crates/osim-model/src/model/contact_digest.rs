//! Digests of all contact values and of the places of spheres. A note uses them to recognise whether its contacts were changed.

use std::collections::BTreeMap;

use foldhash::HashSet;
use sha2::{Digest, Sha256};

use crate::model::{
    FileId, Force, Model, Note, NoteDoubt, NotedNames, NotedParts, Property, Scope, Slot, Sphere, SphereId,
};
use crate::xml::ElementId;

/// Bytes of the digest of all numbers in a note, and of the digest of a reference file.
const DIGEST_BYTES: usize = 8;
/// Bytes of the digests of radii, places and names.
const PART_DIGEST_BYTES: usize = 4;

/// The key of a number in a model: its file, its object and its property.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ValueKey {
    file: FileId,
    object: ElementId,
    property: Property,
}

impl ValueKey {
    /// The key of `property` of an object in a file.
    pub(crate) const fn new(file: FileId, object: ElementId, property: Property) -> Self {
        Self { file, object, property }
    }
}

impl From<(&Slot, Property)> for ValueKey {
    fn from((slot, property): (&Slot, Property)) -> Self {
        Self::new(slot.file, slot.object, property)
    }
}

impl Model {
    /// A digest of all contact values, in file order: the parameters of every contact force and the radii of its spheres.
    ///
    /// `changed` gives the new value of numbers that a plan changes. Equal numbers have equal digests, whatever their spelling, their place
    /// in the file, and the names of spheres and forces.
    pub fn contact_digest(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> String {
        let mut hash = Sha256::new();
        let mut feed = |set: usize, property: Property, number: f64| {
            hash.update((set as u64).to_le_bytes());
            hash.update(property.as_str().as_bytes());
            hash.update(number.to_bits().to_le_bytes());
        };
        for force in self.forces() {
            for (index, set) in force.sets.iter().enumerate() {
                for value in &set.values {
                    let key = ValueKey::new(force.file, set.element, value.property);
                    feed(index, value.property, changed(key).unwrap_or(value.number));
                }
            }
            let value = &force.transition_velocity;
            let key = ValueKey::new(force.file, force.element, value.property);
            feed(0, value.property, changed(key).unwrap_or(value.number));
            for sphere in force.spheres().iter().filter_map(|&sphere| self.sphere(sphere)) {
                let key = ValueKey::new(sphere.file, sphere.element, Property::Radius);
                feed(0, Property::Radius, changed(key).unwrap_or(sphere.radius.number));
            }
        }
        digest_digits(hash, DIGEST_BYTES)
    }

    /// Digest of the radii of all spheres of contact forces, in any order. `changed` gives the new value of radii that a plan changes.
    pub fn radii_digest(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> String {
        let radius = |sphere: &Sphere| {
            let key = ValueKey::new(sphere.file, sphere.element, Property::Radius);
            changed(key).unwrap_or(sphere.radius.number).to_bits()
        };
        digest_of_bits(self.spheres_of_forces().map(radius).collect(), PART_DIGEST_BYTES)
    }

    /// Digest of the locations of all spheres of contact forces, in their frames, with the bodies that carry them, in any order. `moved`
    /// gives the new location of spheres that a plan moves, m.
    pub fn places_digest(&self, moved: impl Fn(&Sphere) -> Option<[f64; 3]>) -> String {
        let mut places: Vec<(&str, [u64; 3])> = Vec::new();
        for sphere in self.spheres_of_forces() {
            let location = moved(sphere).unwrap_or(sphere.location_m);
            // -0 and 0 are one place.
            let bits = location.map(|coordinate| (coordinate + 0.0).to_bits());
            places.push((sphere.body.as_deref().unwrap_or_default(), bits));
        }
        places.sort_unstable();
        let mut hash = Sha256::new();
        for (body, location) in places {
            hash.update(body.as_bytes());
            hash.update([0]);
            location.into_iter().for_each(|coordinate| hash.update(coordinate.to_le_bytes()));
        }
        digest_digits(hash, PART_DIGEST_BYTES)
    }

    fn spheres_of_forces(&self) -> impl Iterator<Item = &Sphere> {
        self.forces().iter().flat_map(Force::spheres).filter_map(|&sphere| self.sphere(sphere))
    }

    /// Whether all contact values are equal to those that `note` records.
    pub(crate) fn has_values_of(&self, note: &Note) -> bool {
        note.digest == self.contact_digest(|_| None)
    }

    /// Whether all radii are equal to those that `note` records.
    pub(crate) fn has_radii_of(&self, note: &Note) -> bool {
        note.radii == self.radii_digest(|_| None)
    }

    /// Whether all spheres are at the places that `note` records; `None` if the note has no places.
    pub fn has_places_of(&self, note: &Note) -> Option<bool> {
        note.places.as_ref().map(|places| *places == self.places_digest(|_| None))
    }

    /// The reason not to trust the note about the contacts; `None` if it can be trusted, or if there is no note.
    ///
    /// A note of [`Scope::All`] without a mass can be trusted: nobody gave a mass, and the contacts count as made for the mass of the
    /// bodies, as without a note. After OpenSim has scaled the bodies, their mass is another one, and the note is in doubt.
    pub fn doubt_about_note(&self) -> Option<NoteDoubt> {
        *self.doubt_about_note.get_or_init(|| {
            if self.note_fault.is_some() {
                return self.note_fault;
            }
            let note = self.note.as_ref()?;
            if !self.has_values_of(note) {
                return Some(NoteDoubt::ValuesChanged);
            }
            match (note.contacts_mass_kg, note.scope) {
                (Some(_), Scope::Partial) => Some(NoteDoubt::Partial),
                (None, Scope::Partial) => Some(NoteDoubt::MassUnknown),
                (Some(_), Scope::All) => None,
                (None, Scope::All) => self.bodies_have_other_sizes(note).then_some(NoteDoubt::BodiesScaled),
            }
        })
    }
}

/// The first 16 digits of the SHA-256 of `bytes`, by which a note recognises a reference file.
pub fn short_digest(bytes: &[u8]) -> String {
    digest_digits(Sha256::new_with_prefix(bytes), DIGEST_BYTES)
}

/// The digest of numbers, whatever their order.
fn digest_of_bits(mut numbers: Vec<u64>, bytes: usize) -> String {
    numbers.sort_unstable();
    let mut hash = Sha256::new();
    numbers.into_iter().for_each(|number| hash.update(number.to_le_bytes()));
    digest_digits(hash, bytes)
}

fn digest_digits(hash: Sha256, bytes: usize) -> String {
    let digits = hash.finalize().into_iter().take(bytes).flat_map(|byte| [byte >> 4, byte & 0xf]);
    digits.filter_map(|digit| char::from_digit(digit.into(), 16)).collect()
}

// Names of the contacts and a digest of each of their properties: by these a note shows what changed.

/// Bytes of the digest of one property. It is short because it only names the changed property, after the digest of all numbers has found a
/// change.
const PROPERTY_DIGEST_BYTES: usize = 2;

impl Model {
    /// The digests of single properties and of names for a note. `changed` gives the new value of numbers that a plan changes.
    pub fn noted_parts(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> NotedParts {
        let mut seen: HashSet<SphereId> = HashSet::default();
        let spheres = self.forces().iter().flat_map(Force::spheres).filter(|&&sphere| seen.insert(sphere));
        let spheres = spheres.filter_map(|&sphere| self.sphere(sphere)).map(|sphere| sphere.name.as_str());
        let forces = self.forces().iter().map(|force| force.name.as_str());
        NotedParts {
            spheres: noted_names(spheres.collect()),
            forces: noted_names(forces.collect()),
            properties: self.property_digests(changed),
        }
    }

    /// A digest of the values of each property, in any order.
    fn property_digests(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> BTreeMap<Property, String> {
        let mut values: BTreeMap<Property, Vec<u64>> = BTreeMap::new();
        for force in self.forces() {
            let of_force = (force.element, &force.transition_velocity);
            let of_sets =
                force.sets.iter().flat_map(|set| set.values.iter().map(|value| (set.element, value)));
            for (element, value) in of_sets.chain([of_force]) {
                let key = ValueKey::new(force.file, element, value.property);
                let number = changed(key).unwrap_or(value.number);
                values.entry(value.property).or_default().push(number.to_bits());
            }
        }
        let digests = values
            .into_iter()
            .map(|(property, bits)| (property, digest_of_bits(bits, PROPERTY_DIGEST_BYTES)));
        digests.collect()
    }
}

fn noted_names(mut names: Vec<&str>) -> NotedNames {
    names.sort_unstable();
    let mut hash = Sha256::new();
    for name in &names {
        hash.update(name.as_bytes());
        hash.update([0]);
    }
    NotedNames { count: names.len(), digest: digest_digits(hash, PART_DIGEST_BYTES) }
}

// The record of a note after a change that removes contacts or converts them, and keeps the mass that they are made for.

impl Note {
    /// The note with the digests of the changed contacts in `after`. If `before` already differed from the note, the difference is kept, so
    /// that it is found later.
    pub fn with_updated_record(&self, before: &Model, after: &Model) -> Self {
        let mut note = self.clone();
        let parts = after.noted_parts(|_| None);
        if before.has_values_of(self) {
            note.digest = after.contact_digest(|_| None);
            note.parts = parts;
        } else {
            note.parts = self.parts.updated(&before.noted_parts(|_| None), parts);
        }
        if before.has_radii_of(self) {
            note.radii = after.radii_digest(|_| None);
        }
        if before.has_places_of(self) == Some(true) {
            note.places = Some(after.places_digest(|_| None));
        }
        note
    }
}

impl NotedParts {
    /// The digests of `after`. Where this note already differs from `before`, its old digest is kept.
    fn updated(&self, before: &Self, mut after: Self) -> Self {
        for (property, noted) in &self.properties {
            if before.properties.get(property) != Some(noted) {
                after.properties.insert(*property, noted.clone());
            }
        }
        let unless_different = |noted: &NotedNames, before: &NotedNames, after: NotedNames| {
            if noted == before { after } else { noted.clone() }
        };
        Self {
            spheres: unless_different(&self.spheres, &before.spheres, after.spheres),
            forces: unless_different(&self.forces, &before.forces, after.forces),
            properties: after.properties,
        }
    }
}
