//! The contact of each sphere that meets a half-space, as the contact laws need it.

use contact_scaling::{Contact, ContactValues, SmoothingValues};

use super::draft::Draft;
use super::surfaces::{Surfaces, sphere_sets};
use crate::error::Fault;
use crate::model::{Force, Model};
use crate::property::Property;

/// One sphere under load.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedSphere {
    /// Index into [`Model::spheres`].
    pub sphere: usize,
    /// Index into [`Model::forces`].
    pub force: usize,
    /// Number of its parameter set in the force.
    pub set: usize,
    /// Its radius, m.
    pub radius_m: f64,
    /// E₁* of two equal surfaces (A.3, A.4), α, and the smoothing where the class has it.
    pub contact: Contact,
}

/// Every moving sphere that an applied force among `forces` presses on a half-space; one that two forces press is there
/// twice.
///
/// # Errors
/// A value that is no plain number or outside its domain, with its place.
pub fn loaded_spheres(model: &Model<'_, '_>, forces: &[usize]) -> Result<Vec<LoadedSphere>, Fault> {
    let draft = Draft::new(model);
    let mut loaded = Vec::new();
    for &index in forces {
        let Some(force) = model.forces.get(index).filter(|force| force.applies) else { continue };
        if !model.meets_half_space(force) {
            continue;
        }
        let surfaces = Surfaces::of(&draft, index, force)?;
        for (set, spheres) in sphere_sets(model, force) {
            let contact = contact_of_set(&draft, (index, force), &surfaces, set)?;
            for sphere in spheres {
                let radius_m = draft.current_radius(sphere)?;
                loaded.push(LoadedSphere { sphere, force: index, set, radius_m, contact });
            }
        }
    }
    Ok(loaded)
}

/// The contact of the spheres of parameter set `set` with the force's plane.
pub(super) fn contact_of_set(
    draft: &Draft<'_, '_, '_>,
    (index, force): (usize, &Force),
    surfaces: &Surfaces,
    set: usize,
) -> Result<Contact, Fault> {
    let (plane_strain_modulus, dissipation) = surfaces.with_plane(set)?;
    let get = |property| draft.current(index, set, property);
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
