//! What somebody changed in a model since its note was written.

use crate::mass::{MassRequest, same_mass};
use crate::model::Model;

/// What is no longer as it was when the note was written.
#[derive(Debug, Clone, Default, PartialEq)]
#[non_exhaustive]
pub struct ChangedSinceNote {
    /// Whether radii are others.
    pub radii: bool,
    /// Whether other values of the contacts are. Where radii are, nobody can know: one digest covers all values.
    pub values: bool,
    /// Whether spheres have other places.
    pub places: bool,
    /// Whether bodies that carry spheres have other mesh factors.
    pub sizes: bool,
    /// What the bodies weighed together then, and now, kg.
    pub weight_kg: Option<(f64, f64)>,
}

impl ChangedSinceNote {
    /// Whether nothing is known to have changed.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        *self == Self::default()
    }
}

impl Model {
    /// Limbs that share the body weight, where the note says how many.
    #[must_use]
    pub fn noted_stance_limbs(&self) -> Option<f64> {
        self.note.as_ref().and_then(|note| note.stance_limbs)
    }

    /// What changed since the note was written; nothing where there is no note.
    #[must_use]
    pub fn changed_since_note(&self) -> ChangedSinceNote {
        let Some(note) = &self.note else { return ChangedSinceNote::default() };
        let differs = |noted: &Option<String>, now: String| noted.as_ref().is_some_and(|noted| *noted != now);
        let radii = differs(&note.radii, self.radii_digest(|_| None));
        let weighs = MassRequest::default().bodies_kg(self);
        ChangedSinceNote {
            radii,
            values: !radii && note.digest != self.contact_digest(|_| None),
            places: differs(&note.places, self.places_digest(|_| None)),
            sizes: self.bodies_have_other_sizes(note),
            weight_kg: note.weighed_kg.zip(weighs).filter(|&(then, now)| !same_mass(then, now)),
        }
    }
}
