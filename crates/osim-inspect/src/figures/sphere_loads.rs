//! Spheres with all the contact laws that press them.

use contact_scaling::{Contact, Law, Spheres};
use foldhash::{HashMap, HashMapExt};
use osim_model::{Fault, ForceId, LoadedSphere, SphereId};

/// One sphere with all laws that press it.
pub(super) struct SphereLoads {
    pub(super) sphere: SphereId,
    pub(super) forces: Vec<ForceId>,
    pub(super) radius_m: f64,
    pub(super) contacts: Vec<Contact>,
    pub(super) laws: Vec<Spheres>,
}

impl SphereLoads {
    /// The bits of all that its laws are made from.
    pub(super) fn key(&self) -> Vec<u64> {
        let numbers = self.contacts.iter().flat_map(|contact| {
            let smoothing = contact.smoothing().map(|smoothing| {
                [
                    smoothing.constant_contact_force,
                    smoothing.hertz_smoothing,
                    smoothing.hunt_crossley_smoothing,
                ]
            });
            let smoothing = smoothing.map_or(vec![f64::NAN], |smoothing| smoothing.to_vec());
            [contact.plane_strain_modulus(), contact.dissipation()].into_iter().chain(smoothing)
        });
        [self.radius_m].into_iter().chain(numbers).map(f64::to_bits).collect()
    }
}

/// Spheres with all their laws, in the order of the model's spheres.
pub(super) fn sphere_loads(loaded: &[LoadedSphere]) -> Result<Vec<SphereLoads>, Fault> {
    let mut all: Vec<SphereLoads> = Vec::new();
    let mut places: HashMap<SphereId, usize> = HashMap::new();
    for one in loaded {
        let law =
            Law::of(&one.contact, one.radius_m).and_then(|law| Spheres::new(law, 1.0)).map_err(Fault::new)?;
        let place = *places.entry(one.sphere).or_insert(all.len());
        match all.get_mut(place) {
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
