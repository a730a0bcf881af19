//! What somebody changed in a model since its note was written.

use crate::model::mass::{MassRequest, same_mass};
use crate::model::note::content::{Note, NotedNames, NotedParts};
use crate::model::property::Property;
use crate::model::typed_model::Model;

/// What is no longer as it was when the note was written.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ChangedSinceNote {
    /// What is different about the contacts themselves.
    pub contacts: ChangedContacts,
    /// Whether bodies that carry spheres have other mesh factors.
    pub sizes: bool,
    /// What the bodies weighed together then, and now, kg.
    pub weight_kg: Option<(f64, f64)>,
}

/// What is different about contacts: as much as the note's record can show.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ChangedContacts {
    /// How many spheres there were and are, where that is different. Then nothing else can be compared.
    pub sphere_count: Option<(usize, usize)>,
    pub force_count: Option<(usize, usize)>,
    pub sphere_names: bool,
    pub force_names: bool,
    pub radii: bool,
    /// Whether spheres have other places or bodies.
    pub places: bool,
    /// Properties of forces with other values.
    pub properties: Vec<Property>,
    /// Whether all numbers are still there, at other contacts.
    pub exchanged: bool,
}

impl Model {
    /// Limbs that share the body weight, where the note says how many.
    pub fn noted_stance_limbs(&self) -> Option<f64> {
        self.note.as_ref().and_then(|note| note.stance_limbs)
    }

    /// What changed since the note was written; nothing where there is no note.
    pub fn changed_since_note(&self) -> ChangedSinceNote {
        let Some(note) = &self.note else { return ChangedSinceNote::default() };
        let weighs = MassRequest::default().bodies_kg(self);
        ChangedSinceNote {
            contacts: self.changed_contacts(note),
            sizes: self.bodies_have_other_sizes(note),
            weight_kg: note.weighed_kg.zip(weighs).filter(|&(then, now)| !same_mass(then, now)),
        }
    }

    fn changed_contacts(&self, note: &Note) -> ChangedContacts {
        let radii = !self.has_radii_of(note);
        let places = self.has_places_of(note) == Some(false);
        let values = !self.has_values_of(note);
        let then = &note.parts;
        let now = self.noted_parts(|_| None);
        let counts = |then: &NotedNames, now: &NotedNames| {
            (then.count != now.count).then_some((then.count, now.count))
        };
        let (sphere_count, force_count) =
            (counts(&then.spheres, &now.spheres), counts(&then.forces, &now.forces));
        let comparable = sphere_count.is_none() && force_count.is_none();
        let properties = if comparable { differing_properties(then, &now) } else { Vec::new() };
        ChangedContacts {
            sphere_names: comparable && then.spheres.digest != now.spheres.digest,
            force_names: comparable && then.forces.digest != now.forces.digest,
            radii: comparable && radii,
            places: comparable && places,
            exchanged: comparable && values && !radii && properties.is_empty(),
            properties,
            sphere_count,
            force_count,
        }
    }
}

/// Properties with other values, and those that only one of the two has.
fn differing_properties(then: &NotedParts, now: &NotedParts) -> Vec<Property> {
    let differs = |property: &Property| then.properties.get(property) != now.properties.get(property);
    Property::ALL.into_iter().filter(differs).collect()
}
