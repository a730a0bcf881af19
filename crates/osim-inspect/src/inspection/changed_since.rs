//! What somebody changed since the note was written, in words.

use osim_model::messages::readable;
use osim_model::{ChangedContacts, ChangedSinceNote};

/// Each change as a part of one sentence; an empty list if nothing changed.
pub(super) fn in_words(changed: &ChangedSinceNote) -> Vec<String> {
    let sizes = changed.sizes.then(|| "sizes of bodies".to_owned());
    let weight = changed.weight_kg.map(|(then, now)| {
        format!("the bodies weighed {} kg then and weigh {} kg now", readable(then), readable(now))
    });
    of_contacts(&changed.contacts).into_iter().chain(sizes).chain(weight).collect()
}

fn of_contacts(changed: &ChangedContacts) -> Vec<String> {
    match changed {
        ChangedContacts::Apart {
            sphere_count,
            force_count,
            sphere_names,
            force_names,
            radii,
            places,
            properties,
            exchanged,
        } => {
            let count = |of: &str, count: &Option<(usize, usize)>| {
                count.map(|(then, now)| format!("the contacts had {then} {of} then and have {now} now"))
            };
            let counts: Vec<String> =
                count("spheres", sphere_count).into_iter().chain(count("forces", force_count)).collect();
            let unknown = (!counts.is_empty()).then(|| {
                "the note cannot show whether other numbers of the contacts changed, too".to_owned()
            });
            let named = [
                (*radii, "radii"),
                (*places, "places of spheres"),
                (*sphere_names, "names of spheres"),
                (*force_names, "names of forces"),
                (*exchanged, "which contact has which numbers"),
            ];
            let properties = properties.iter().map(|property| property.name().to_owned());
            counts.into_iter().chain(unknown).chain(true_ones(named)).chain(properties).collect()
        }
        ChangedContacts::Together { radii, values, places } => {
            let named = [
                (*radii, "radii, names or number of spheres (perhaps other numbers of contacts, too)"),
                (*values, "numbers of contacts other than radii, or names of forces"),
                (*places, "places, names or number of spheres"),
            ];
            true_ones(named).collect()
        }
    }
}

fn true_ones<const N: usize>(parts: [(bool, &str); N]) -> impl Iterator<Item = String> {
    parts.into_iter().filter(|(is, _)| *is).map(|(_, name)| name.to_owned())
}
