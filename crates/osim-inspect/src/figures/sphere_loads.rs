//! Spheres with all the contact laws that press them.

use contact_scaling::{Contact, Law, Spheres};
use osim_model::{Fault, ForceId, SphereId};
use osim_patch::LoadedSphere;

/// One sphere with all laws that press it.
pub(super) struct SphereLoads {
    pub(super) sphere: SphereId,
    pub(super) forces: Vec<ForceId>,
    pub(super) radius_m: f64,
    pub(super) contacts: Vec<Contact>,
    pub(super) laws: Vec<Spheres>,
}

/// Spheres with all their laws, in the order of the model's spheres.
pub(super) fn sphere_loads(loaded: &[LoadedSphere]) -> Result<Vec<SphereLoads>, Fault> {
    let mut all: Vec<SphereLoads> = Vec::new();
    for one in loaded {
        let law =
            Law::of(&one.contact, one.radius_m).and_then(|law| Spheres::new(law, 1.0)).map_err(Fault::new)?;
        match all.iter_mut().find(|known| known.sphere == one.sphere) {
            Some(known) => {
                known.forces.push(one.force);
                known.contacts.push(one.contact);
                known.laws.push(law);
            }
            None => all.push(SphereLoads {
                sphere: one.sphere,
                forces: vec![one.force],
                radius_m: one.radius_m,
                contacts: vec![one.contact],
                laws: vec![law],
            }),
        }
    }
    all.sort_by_key(|one| one.sphere);
    Ok(all)
}
