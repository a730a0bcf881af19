//! The record of a note after a change that takes contacts out or makes them of another class, and leaves what they are made for.

use crate::model::note::{Note, NotedNames, NotedParts};
use crate::model::typed_model::Model;

impl Note {
    /// This note of `before`, with the record of `after`. What others changed before stays recorded as it was, so that it is found.
    #[must_use]
    pub fn recorded_again(&self, before: &Model, after: &Model) -> Self {
        let had_places = before.has_places_of(self);
        let had_radii = before.has_radii_of(self);
        let mut note = self.clone();
        if before.has_values_of(self) {
            note.digest = after.contact_digest(|_| None);
            note.parts = Some(after.noted_parts(|_| None));
        } else if let Some(then) = &self.parts {
            note.parts = Some(then.again(&before.noted_parts(|_| None), after.noted_parts(|_| None)));
        }
        let by_name = note.parts.is_none();
        if had_radii != Some(false) {
            note.radii =
                Some(if by_name { after.radii_digest_by_name() } else { after.radii_digest(|_| None) });
        }
        if had_places == Some(true) {
            note.places =
                Some(if by_name { after.places_digest_by_name() } else { after.places_digest(|_| None) });
        }
        note
    }
}

impl NotedParts {
    /// `after`, with what `before` does not have as it was noted.
    fn again(&self, before: &Self, mut after: Self) -> Self {
        for (property, noted) in &self.properties {
            if before.properties.get(property) != Some(noted) {
                after.properties.insert(*property, noted.clone());
            }
        }
        let names = |noted: &NotedNames, before: &NotedNames, after: NotedNames| {
            if noted == before { after } else { noted.clone() }
        };
        Self {
            spheres: names(&self.spheres, &before.spheres, after.spheres),
            forces: names(&self.forces, &before.forces, after.forces),
            properties: after.properties,
        }
    }
}
