//! The contact of each sphere that meets a half-space, as the contact laws need it.

use contact_scaling::modulus::SurfaceValues;
use contact_scaling::{Contact, ContactValues, SmoothingValues};

use super::surfaces::{Surfaces, sphere_sets};
use crate::model::{Fault, Force, ForceId, Model, Property, SetId, SphereId};

/// One sphere under load, with what the contact laws need to know of it: from [`loaded_spheres`].
///
/// ```
/// use osim_model::{Model, Selection};
/// use osim_model::loaded_spheres;
///
/// # let bytes: &[u8] = include_bytes!("../../../tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let spheres = loaded_spheres(&model, &selected.forces)?;
/// // The file says <radius>0.03</radius>, <stiffness>1000000</stiffness> and <dissipation>2</dissipation>.
/// let sphere = &spheres[0];
/// assert_eq!(model.sphere(sphere.sphere).map(|sphere| sphere.name.as_str()), Some("heel_r"));
/// assert_eq!((sphere.radius_m, sphere.contact.dissipation()), (0.03, 2.0));
/// assert!((sphere.contact.plane_strain_modulus() - 1e6).abs() < 1e-6);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LoadedSphere {
    /// The sphere.
    pub sphere: SphereId,
    /// The force that presses it.
    pub force: ForceId,
    /// Its parameter set in the force.
    pub set: SetId,
    /// Its radius, m.
    pub radius_m: f64,
    /// E₁* (N/m²) of two equal surfaces that are as stiff together as sphere and plane are (A.3, A.4), α (s/m), and the
    /// smoothing where the class has it.
    pub contact: Contact,
}

/// Every moving sphere that an applied force among `forces` presses on a half-space; one that two forces press appears
/// twice.
///
/// # Errors
/// A value that is not a plain number or outside its domain, with its place.
pub fn loaded_spheres(model: &Model, forces: &[ForceId]) -> Result<Vec<LoadedSphere>, Fault> {
    let mut loaded = Vec::new();
    for &id in forces {
        let Some(force) = model.force(id).filter(|force| force.applies) else { continue };
        if !model.meets_half_space(force) {
            continue;
        }
        let surfaces = Surfaces::of(force)?;
        for (set, spheres) in sphere_sets(model, force) {
            let contact = contact_of_set(force, &surfaces, set)?;
            for sphere in spheres {
                let radius_m = model.radius_m(sphere)?;
                loaded.push(LoadedSphere { sphere, force: id, set, radius_m, contact });
            }
        }
    }
    Ok(loaded)
}

/// The contact of the spheres of parameter set `set` with the force's plane.
///
/// # Errors
/// A value that is not a plain number or outside its domain, with its place.
pub fn contact_of_set(force: &Force, surfaces: &Surfaces, set: SetId) -> Result<Contact, Fault> {
    contact_of_values(force, surfaces.with_plane(set)?, set)
}

/// The same with a plane that has its own parameters in the set `plane`.
///
/// # Errors
/// A value that is not a plain number or outside its domain, with its place.
pub fn contact_of_pair(
    force: &Force,
    surfaces: &Surfaces,
    set: SetId,
    plane: SetId,
) -> Result<Contact, Fault> {
    contact_of_values(force, surfaces.together(set, plane)?, set)
}

fn contact_of_values(force: &Force, values: SurfaceValues, set: SetId) -> Result<Contact, Fault> {
    let SurfaceValues { plane_strain_modulus, dissipation } = values;
    let get = |property| force.checked(set, property);
    let smoothing = match (
        get(Property::ConstantContactForce)?,
        get(Property::HertzSmoothing)?,
        get(Property::HuntCrossleySmoothing)?,
    ) {
        (Some(constant_contact_force), Some(hertz_smoothing), Some(hunt_crossley_smoothing)) => {
            Some(SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })
        }
        _ => None,
    };
    Contact::new(ContactValues { plane_strain_modulus, dissipation, smoothing })
        .map_err(|error| Fault::new(error).of(force.path.clone()))
}
