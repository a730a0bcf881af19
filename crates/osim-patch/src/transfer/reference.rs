//! The contacts of a model, as a reference for others.

use osim_model::{Fault, Mass, Model, Property, Selected};

use super::request::{Reference, ReferenceContact};
use crate::builder::PlanBuilder;
use crate::loaded_sphere::contact_of_set;
use crate::radii::root_mean_square;
use crate::surfaces::{Surfaces, sphere_sets};

/// Reads the contacts of the forces `selected` of a reference model, which were made for `mass` and for `sphere_count` spheres
/// that share its weight: see [`Reference`] for an example.
///
/// # Errors
/// A value that is not a plain number or outside its domain, with its place.
pub fn reference_of_model(
    model: &Model,
    selected: &Selected,
    mass: Mass,
    sphere_count: f64,
) -> Result<Reference, Fault> {
    let values = PlanBuilder::new(model);
    let mut contacts = Vec::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let surfaces = Surfaces::of(&values, force)?;
        for (set, spheres) in sphere_sets(model, force) {
            let mut radii_m = Vec::new();
            for &sphere in &spheres {
                radii_m.push(values.current_radius(sphere)?);
            }
            let radius_m = root_mean_square(radii_m.iter().copied());
            let contact = contact_of_set(&values, force, &surfaces, set)?;
            let get = |property| values.current(force.id, set, property);
            let friction = get(Property::TransitionVelocity)?.zip(get(Property::ViscousFriction)?);
            let names = spheres.iter().filter_map(|&s| model.sphere(s)).map(|s| s.name.clone()).collect();
            contacts.push(ReferenceContact { spheres: names, radii_m, radius_m, contact, friction });
        }
    }
    let name = model.name.clone();
    Ok(Reference {
        name,
        mass,
        sphere_count,
        gravity_m_s2: model.contacts_gravity().filter(|&g| g > 0.0),
        contacts,
    })
}
