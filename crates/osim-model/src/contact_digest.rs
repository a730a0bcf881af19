//! Digests of all contact values and of the spheres' places, by which a note recognises its contacts.

use sha2::{Digest, Sha256};

use crate::contacts::{Force, Slot, Sphere};
use crate::fault::{FileId, NoteDoubt};
use crate::model::Model;
use crate::note::Scope;
use crate::property::Property;
use osim_xml::ElementId;

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
    /// Digest of all contact values: parameters of every contact force and radii of their spheres.
    ///
    /// `changed` gives the new value of those that a plan changes. The same numbers have the same digest whatever their
    /// spelling and wherever they are in the file.
    #[must_use]
    pub fn contact_digest(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> String {
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
                for value in &set.values {
                    let property = value.property;
                    let key = ValueKey { file: force.file, object: set.element, property };
                    feed(&force.path, index, property, changed(key).unwrap_or(value.number));
                }
            }
            let value = &force.transition_velocity;
            let key = ValueKey { file: force.file, object: force.element, property: value.property };
            feed(&force.path, 0, value.property, changed(key).unwrap_or(value.number));
            for sphere in force.spheres().into_iter().filter_map(|sphere| self.sphere(sphere)) {
                let key = ValueKey { file: sphere.file, object: sphere.element, property: Property::Radius };
                feed(&sphere.path, 0, Property::Radius, changed(key).unwrap_or(sphere.radius.number));
            }
        }
        first_digits(hash)
    }

    /// Digest of the radii of all spheres of contact forces. `changed` gives the new value of those that a plan changes.
    #[must_use]
    pub fn radii_digest(&self, changed: impl Fn(ValueKey) -> Option<f64>) -> String {
        let mut hash = Sha256::new();
        for sphere in self.forces().iter().flat_map(Force::spheres).filter_map(|sphere| self.sphere(sphere)) {
            let key = ValueKey { file: sphere.file, object: sphere.element, property: Property::Radius };
            hash.update(sphere.path.as_bytes());
            hash.update([0]);
            hash.update(changed(key).unwrap_or(sphere.radius.number).to_bits().to_le_bytes());
        }
        first_digits(hash)
    }

    /// Digest of the locations of all spheres of contact forces, in their frames. `moved` gives the new location of those that
    /// a plan moves, m.
    #[must_use]
    pub fn places_digest(&self, moved: impl Fn(&Sphere) -> Option<[f64; 3]>) -> String {
        let mut hash = Sha256::new();
        for force in self.forces() {
            for sphere in force.spheres().into_iter().filter_map(|sphere| self.sphere(sphere)) {
                hash.update(sphere.path.as_bytes());
                hash.update([0]);
                for coordinate in moved(sphere).unwrap_or(sphere.location_m) {
                    // -0 and 0 are one place.
                    hash.update((coordinate + 0.0).to_bits().to_le_bytes());
                }
            }
        }
        first_digits(hash)
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
        if note.digest != self.contact_digest(|_| None) {
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
    let digits = hash.finalize().into_iter().take(8).flat_map(|byte| [byte >> 4, byte & 0xf]);
    digits.filter_map(|digit| char::from_digit(digit.into(), 16)).collect()
}
