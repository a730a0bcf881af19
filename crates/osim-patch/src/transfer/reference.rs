//! The contacts of a model, as a reference for others.

use contact_scaling::{Contact, ContactValues, SmoothingValues};
use osim_model::{
    Class, Fault, ForceKind, Mass, Model, Property, Selected, Surfaces, contact_of_set, root_mean_square,
    sphere_sets,
};

use super::request::{Reference, ReferenceContact};
use crate::objects::{Layout, NewContact};

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
    let mut contacts = Vec::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        let surfaces = Surfaces::of(force)?;
        for (set, spheres) in sphere_sets(model, force) {
            let mut radii_m = Vec::new();
            for &sphere in &spheres {
                radii_m.push(model.radius_m(sphere)?);
            }
            let radius_m = root_mean_square(radii_m.iter().copied());
            let contact = contact_of_set(force, &surfaces, set)?;
            let get = |property| force.checked(set, property);
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

/// The contacts of `layout` as a reference called `name`, which were made for `mass`, for `sphere_count` spheres that share its
/// weight, and for a gravity if known.
///
/// ```
/// use osim_model::{ForceKind, Mass, MassSource, Property};
/// use osim_patch::{Layout, NewContact, reference_of_layout};
///
/// let mut heel = NewContact::new(ForceKind::HuntCrossley, "force_heel", "heel");
/// heel.radius_m = 0.03;
/// heel.values = vec![(Property::Stiffness, 1e6), (Property::Dissipation, 2.0)];
/// let mut layout = Layout::default();
/// layout.contacts.push(heel);
///
/// let mass = Mass { kg: 62.0, source: MassSource::ReferenceMass };
/// let reference = reference_of_layout("human", &layout, mass, 6.0, Some(9.81))?;
/// assert_eq!(reference.contacts[0].contact.plane_strain_modulus(), 1e6);
/// assert_eq!(reference.contacts[0].radius_m, 0.03);
/// # Ok::<(), osim_model::Fault>(())
/// ```
///
/// # Errors
/// A value outside its domain.
pub fn reference_of_layout(
    name: &str,
    layout: &Layout,
    mass: Mass,
    sphere_count: f64,
    gravity_m_s2: Option<f64>,
) -> Result<Reference, Fault> {
    let contacts = layout.contacts.iter().map(contact_of_new).collect::<Result<_, Fault>>()?;
    Ok(Reference { name: name.to_owned(), mass, sphere_count, gravity_m_s2, contacts })
}

fn contact_of_new(new: &NewContact) -> Result<ReferenceContact, Fault> {
    let smooth = new.kind == ForceKind::SmoothSphereHalfSpace;
    let class = if smooth { Class::SmoothSphereHalfSpaceForce } else { Class::ContactParameters };
    let value = |property| {
        let given = new.values.iter().find(|(known, _)| *known == property);
        given.map_or_else(|| class.default(property), |(_, value)| *value)
    };
    let smoothing = SmoothingValues {
        constant_contact_force: value(Property::ConstantContactForce),
        hertz_smoothing: value(Property::HertzSmoothing),
        hunt_crossley_smoothing: value(Property::HuntCrossleySmoothing),
    };
    let values = ContactValues {
        plane_strain_modulus: value(Property::Stiffness),
        dissipation: value(Property::Dissipation),
        smoothing: smooth.then_some(smoothing),
    };
    Ok(ReferenceContact {
        spheres: vec![new.sphere.clone()],
        radii_m: vec![new.radius_m],
        radius_m: new.radius_m,
        contact: Contact::new(values).map_err(|fault| Fault::new(fault).of(new.force.clone()))?,
        friction: Some((value(Property::TransitionVelocity), value(Property::ViscousFriction))),
    })
}
