//! Digests of all contact values and of the spheres' places, by which a note recognises its contacts.

mod again;
mod by_name;
mod parts;

use sha2::{Digest, Sha256};

use crate::model::contacts::{Force, Slot, Sphere};
use crate::model::fault::{FileId, NoteDoubt};
use crate::model::note::{Note, Scope};
use crate::model::property::Property;
use crate::model::typed_model::Model;
use crate::xml::ElementId;

/// Bytes of a digest in a note.
const BYTES: usize = 8;

/// The key of a number of a model: its file, its object and its property.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ValueKey {
    file: FileId,
    object: ElementId,
    property: Property,
}

impl ValueKey {
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
    /// Digest of all contact values: parameters of every contact force and radii of their spheres, in their order.
    ///
    /// `changed` gives the new value of those that a plan changes. The same numbers have the same digest whatever their
    /// spelling, wherever they are in the file, and whatever the spheres and forces are called.
    #[must_use]
    pub fn contact_digest(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> String {
        let mut hash = Sha256::new();
        let mut feed = |set: usize, property: Property, number: f64| {
            hash.update((set as u64).to_le_bytes());
            hash.update(property.name().as_bytes());
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
            for sphere in force.spheres().into_iter().filter_map(|sphere| self.sphere(sphere)) {
                let key = ValueKey::new(sphere.file, sphere.element, Property::Radius);
                feed(0, Property::Radius, changed(key).unwrap_or(sphere.radius.number));
            }
        }
        first_digits(hash)
    }

    /// Digest of the radii of all spheres of contact forces, in whatever order. `changed` gives the new value of those that a plan
    /// changes.
    #[must_use]
    pub fn radii_digest(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> String {
        let radius = |sphere: &Sphere| {
            let key = ValueKey::new(sphere.file, sphere.element, Property::Radius);
            changed(key).unwrap_or(sphere.radius.number).to_bits()
        };
        let mut radii: Vec<u64> = self.spheres_of_forces().map(radius).collect();
        radii.sort_unstable();
        let mut hash = Sha256::new();
        radii.into_iter().for_each(|radius| hash.update(radius.to_le_bytes()));
        first_digits(hash)
    }

    /// Digest of the locations of all spheres of contact forces, in their frames, with the bodies that carry them, in whatever
    /// order. `moved` gives the new location of those that a plan moves, m.
    #[must_use]
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
        first_digits(hash)
    }

    /// The spheres of each contact force.
    fn spheres_of_forces(&self) -> impl Iterator<Item = &Sphere> {
        self.forces().iter().flat_map(Force::spheres).filter_map(|sphere| self.sphere(sphere))
    }

    /// Whether all contact values are those that `note` records.
    #[must_use]
    pub fn has_values_of(&self, note: &Note) -> bool {
        let by_name = note.parts.is_none();
        note.digest == if by_name { self.contact_digest_by_name() } else { self.contact_digest(|_| None) }
    }

    /// Whether all radii are those that `note` records; `None` where it records none.
    #[must_use]
    pub fn has_radii_of(&self, note: &Note) -> Option<bool> {
        let by_name = note.parts.is_none();
        let now = || if by_name { self.radii_digest_by_name() } else { self.radii_digest(|_| None) };
        note.radii.as_ref().map(|radii| *radii == now())
    }

    /// Whether all spheres are where `note` records them; `None` where it records no places.
    #[must_use]
    pub fn has_places_of(&self, note: &Note) -> Option<bool> {
        let by_name = note.parts.is_none();
        let now = || if by_name { self.places_digest_by_name() } else { self.places_digest(|_| None) };
        note.places.as_ref().map(|places| *places == now())
    }

    /// Why the note about the contacts cannot be relied on; `None` if it can, or if there is no note.
    ///
    /// A note of [`Scope::All`] that gives no mass can be relied on: nobody said one, and the contacts are taken as made for what the
    /// bodies weigh, as without a note. Once OpenSim has scaled the bodies, they no longer weigh that.
    #[must_use]
    pub fn doubt_about_note(&self) -> Option<NoteDoubt> {
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
    }
}

/// The first 16 digits of the SHA-256 of `bytes`, by which a note knows a reference again.
#[must_use]
pub fn short_digest(bytes: &[u8]) -> String {
    first_digits(Sha256::new_with_prefix(bytes))
}

fn first_digits(hash: Sha256) -> String {
    digits(hash, BYTES)
}

fn digits(hash: Sha256, bytes: usize) -> String {
    let digits = hash.finalize().into_iter().take(bytes).flat_map(|byte| [byte >> 4, byte & 0xf]);
    digits.filter_map(|digit| char::from_digit(digit.into(), 16)).collect()
}
