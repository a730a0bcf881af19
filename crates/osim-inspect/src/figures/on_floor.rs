//! A sphere on the floor: all that its figures are computed from.

use contact_scaling::{Contact, DomainError, Law, SharedLoad, SmoothingValues, Spheres};
use foldhash::{HashMap, HashMapExt};
use osim_model::{Fault, ForceId, LoadedSphere, SphereId};

/// A figure's value, or why there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Answer {
    Known(f64),
    /// Something that is needed for it is not known.
    Unknown,
    /// It would be beyond where its equation gives a number, so beyond its limit.
    Beyond,
}

impl From<Option<f64>> for Answer {
    fn from(value: Option<f64>) -> Self {
        value.map_or(Self::Unknown, Self::Known)
    }
}

impl Answer {
    pub(super) fn value(self) -> Option<f64> {
        match self {
            Self::Known(value) => Some(value),
            Self::Unknown | Self::Beyond => None,
        }
    }
}

#[derive(Clone, Copy)]
pub(super) struct Weight {
    pub(super) mass_kg: f64,
    /// The part along the normal of the floor.
    pub(super) gravity_m_s2: f64,
}

/// One sphere of a limb under its share of the weight.
pub(super) struct OnFloor<'s> {
    pub(super) sphere: &'s SphereLoads,
    /// Whose weight, where it is known.
    pub(super) weight: Option<Weight>,
    /// One body weight on all spheres that share it.
    pub(super) one_body_weight: Option<SharedLoad>,
    /// Speed before an impact, m/s.
    pub(super) impact_speed_m_s: Option<f64>,
    /// How it rests under one and two body weights, if it is known.
    pub(super) rests: &'s [Rest],
}

/// Where a sphere rests under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest {
    pub(super) body_weights: f64,
    pub(super) load_n: f64,
    /// x̂ under its share, by the Hertz law and by the model's.
    pub(super) hertz: Option<f64>,
    pub(super) model_law: Option<f64>,
    /// x̂ with all spheres of the limb level.
    pub(super) level_hertz: Option<f64>,
    pub(super) level_model_law: Option<f64>,
    /// x̂ with each sphere of the limb at its own height.
    pub(super) standing_hertz: Option<f64>,
    pub(super) standing_model_law: Option<f64>,
}

impl OnFloor<'_> {
    fn at(&self, body_weights: f64) -> Option<&Rest> {
        self.rests.iter().find(|rest| rest.body_weights == body_weights)
    }

    pub(super) fn at_one(&self) -> Option<&Rest> {
        self.at(1.0)
    }

    /// A figure under one body weight.
    pub(super) fn one(&self, of: impl Fn(&Rest) -> Option<f64>) -> Answer {
        self.at(1.0).and_then(of).into()
    }

    /// A figure under two body weights.
    pub(super) fn two(&self, of: impl Fn(&Rest) -> Option<f64>) -> Answer {
        self.at(2.0).and_then(of).into()
    }

    pub(super) fn load(&self) -> Option<SharedLoad> {
        self.one_body_weight
    }

    pub(super) fn mass_on_sphere(&self) -> Option<f64> {
        Some(self.weight?.mass_kg / self.one_body_weight?.sphere_count())
    }

    pub(super) fn composite_modulus(&self) -> f64 {
        self.sphere.contacts.iter().map(Contact::composite_modulus).sum()
    }

    pub(super) fn dissipation(&self) -> Option<f64> {
        let contacts = &self.sphere.contacts;
        let first = contacts.first().map(Contact::dissipation);
        first.filter(|&alpha| contacts.iter().all(|contact| contact.dissipation() == alpha))
    }

    /// α and the speed before an impact.
    pub(super) fn impact(&self) -> Option<(f64, f64)> {
        self.dissipation().zip(self.impact_speed_m_s)
    }

    fn smoothed(&self) -> impl Iterator<Item = SmoothingValues> {
        self.sphere.contacts.iter().filter_map(Contact::smoothing)
    }

    /// What the smoothing does; of several forces the one that does most.
    pub(super) fn most(&self, of: impl Fn(SmoothingValues, f64) -> Result<f64, DomainError>) -> Option<f64> {
        self.smoothed().filter_map(|values| of(values, self.sphere.radius_m).ok()).reduce(f64::max)
    }

    pub(super) fn force_just_touching(&self) -> Option<f64> {
        self.smoothed().next()?;
        Some(self.sphere.laws.iter().map(|law| law.law().rest_force(0.0)).sum())
    }
}

// Spheres with all the contact laws that press them.

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
