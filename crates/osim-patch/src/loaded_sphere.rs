//! The contact of each sphere that meets a half-space, as the contact laws need it.

use contact_scaling::{Contact, ContactValues, SmoothingValues};
use osim_model::{Fault, Force, ForceId, Model, Property, SetId, SphereId};

use crate::builder::PlanBuilder;
use crate::surfaces::{Surfaces, sphere_sets};

/// One sphere under load.
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
    /// E₁* of two equal surfaces (A.3, A.4), α, and the smoothing where the class has it.
    pub contact: Contact,
}

/// Every moving sphere that an applied force among `forces` presses on a half-space; one that two forces press is there
/// twice.
///
/// # Errors
/// A value that is no plain number or outside its domain, with its place.
pub fn loaded_spheres(model: &Model, forces: &[ForceId]) -> Result<Vec<LoadedSphere>, Fault> {
    let values = PlanBuilder::new(model);
    let mut loaded = Vec::new();
    for &id in forces {
        let Some(force) = model.force(id).filter(|force| force.applies) else { continue };
        if !model.meets_half_space(force) {
            continue;
        }
        let surfaces = Surfaces::of(&values, force)?;
        for (set, spheres) in sphere_sets(model, force) {
            let contact = contact_of_set(&values, force, &surfaces, set)?;
            for sphere in spheres {
                let radius_m = values.current_radius(sphere)?;
                loaded.push(LoadedSphere { sphere, force: id, set, radius_m, contact });
            }
        }
    }
    Ok(loaded)
}

/// The contact of the spheres of parameter set `set` with the force's plane.
pub(crate) fn contact_of_set(
    plan: &PlanBuilder<'_>,
    force: &Force,
    surfaces: &Surfaces,
    set: SetId,
) -> Result<Contact, Fault> {
    let (plane_strain_modulus, dissipation) = surfaces.with_plane(set)?;
    let get = |property| plan.current(force.id, set, property);
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
