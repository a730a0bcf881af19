//! A contact sphere under its share of the body weight: the data from which the figures of the sphere are computed.

use contact_scaling::{Contact, DomainError, Law, SharedLoad, SmoothingValues, Spheres};
use foldhash::{HashMap, HashMapExt};
use osim_model::{Fault, ForceId, LoadedSphere, Result, SphereId};

/// The value of a figure, or the reason why the figure has no value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum ComputedFigure {
    Known(f64),
    /// A quantity in the equation of the figure is not known.
    Unknown,
    /// The equation gives no number for these values. The figure then counts as beyond its limit.
    Beyond,
}

impl From<Option<f64>> for ComputedFigure {
    fn from(value: Option<f64>) -> Self {
        value.map_or(Self::Unknown, Self::Known)
    }
}

impl ComputedFigure {
    /// The value, if it is known.
    pub(super) fn value(self) -> Option<f64> {
        match self {
            Self::Known(value) => Some(value),
            Self::Unknown | Self::Beyond => None,
        }
    }
}

/// The mass of a body, and the component of gravity along the normal of its floor.
#[derive(Clone, Copy)]
pub(super) struct WeightOnFloor {
    pub(super) mass_kg: f64,
    /// The component of gravity along the normal of the floor.
    pub(super) gravity_m_s2: f64,
}

/// A sphere of a limb under its share of the weight.
pub(super) struct SphereOnFloor<'s> {
    pub(super) contacts: &'s SphereContacts,
    pub(super) weight: Option<WeightOnFloor>,
    /// The load of one body weight, and the number of spheres that share it.
    pub(super) one_body_weight: Option<SharedLoad>,
    /// Speed of the sphere before an impact, m/s; `None` if it is not known.
    pub(super) impact_speed_m_s: Option<f64>,
    /// The equilibria of the sphere under one and two body weights; empty if they are not known.
    pub(super) rests: &'s [SphereRest],
}

/// How deep a sphere is in the floor in equilibrium, under a number of body weights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SphereRest {
    pub(super) body_weights: f64,
    pub(super) load_n: f64,
    /// x̂ under the sphere's own share of the load, by the Hertz law; `model_law` is x̂ under this share by the law of the model.
    pub(super) hertz: Option<f64>,
    pub(super) model_law: Option<f64>,
    /// x̂ if the bottoms of all spheres of the limb are at one height, by the Hertz law.
    pub(super) level_hertz: Option<f64>,
    pub(super) level_model_law: Option<f64>,
    /// x̂ if each sphere of the limb is at its own height in the default pose, by the Hertz law.
    pub(super) standing_hertz: Option<f64>,
    pub(super) standing_model_law: Option<f64>,
}

impl SphereOnFloor<'_> {
    /// How deep the sphere is in equilibrium under this many body weights.
    pub(super) fn rest_at(&self, body_weights: f64) -> Option<&SphereRest> {
        self.rests.iter().find(|rest| rest.body_weights == body_weights)
    }

    /// A figure of the equilibrium under one body weight, if it is known.
    pub(super) fn at_one_body_weight(&self, figure: impl Fn(&SphereRest) -> Option<f64>) -> ComputedFigure {
        self.rest_at(1.0).and_then(figure).into()
    }

    /// A figure of the equilibrium under two body weights, if it is known.
    pub(super) fn at_two_body_weights(&self, figure: impl Fn(&SphereRest) -> Option<f64>) -> ComputedFigure {
        self.rest_at(2.0).and_then(figure).into()
    }

    /// The share of the body mass on this sphere, kg.
    pub(super) fn mass_on_sphere(&self) -> Option<f64> {
        Some(self.weight?.mass_kg / self.one_body_weight?.sphere_count())
    }

    /// E* of all contacts of the sphere together, N/m².
    pub(super) fn composite_modulus(&self) -> f64 {
        self.contacts.contacts.iter().map(Contact::composite_modulus).sum()
    }

    /// The dissipation of the sphere, s/m; `None` if its contacts have different ones.
    pub(super) fn dissipation(&self) -> Option<f64> {
        let contacts = &self.contacts.contacts;
        let first = contacts.first().map(Contact::dissipation);
        first.filter(|&alpha| contacts.iter().all(|contact| contact.dissipation() == alpha))
    }

    /// The dissipation α, and the speed before an impact; `None` if one of them is not known.
    pub(super) fn dissipation_and_speed(&self) -> Option<(f64, f64)> {
        self.dissipation().zip(self.impact_speed_m_s)
    }

    fn smoothing_values(&self) -> impl Iterator<Item = SmoothingValues> {
        self.contacts.contacts.iter().filter_map(Contact::smoothing)
    }

    /// Computes a figure from the smoothing and the radius. If several forces press the sphere, the largest value counts.
    pub(super) fn largest_of_smoothing(
        &self,
        figure: impl Fn(SmoothingValues, f64) -> Result<f64, DomainError>,
    ) -> Option<f64> {
        let figures =
            self.smoothing_values().filter_map(|values| figure(values, self.contacts.radius_m).ok());
        figures.reduce(f64::max)
    }

    /// The force at speed 0 of a smoothed sphere whose bottom just touches the floor, N.
    pub(super) fn force_just_touching(&self) -> Option<f64> {
        self.smoothing_values().next()?;
        Some(self.contacts.laws.iter().map(|law| law.law().rest_force(0.0)).sum())
    }
}

/// A sphere with the contact law of each force that presses it.
pub(super) struct SphereContacts {
    pub(super) sphere: SphereId,
    pub(super) forces: Vec<ForceId>,
    pub(super) radius_m: f64,
    pub(super) contacts: Vec<Contact>,
    pub(super) laws: Vec<Spheres>,
}

impl SphereContacts {
    /// The bits of all numbers in the contact laws of the sphere. Equal keys mean equal laws.
    pub(super) fn laws_key(&self) -> Vec<u64> {
        let numbers = self.contacts.iter().flat_map(|contact| {
            let smoothing = contact.smoothing();
            let smoothing =
                smoothing.map(|s| [s.constant_contact_force, s.hertz_smoothing, s.hunt_crossley_smoothing]);
            let smoothing = smoothing.map_or(vec![f64::NAN], |smoothing| smoothing.to_vec());
            [contact.plane_strain_modulus(), contact.dissipation()].into_iter().chain(smoothing)
        });
        [self.radius_m].into_iter().chain(numbers).map(f64::to_bits).collect()
    }
}

/// Contacts grouped by sphere, in the order of the model's spheres.
pub(super) fn contacts_by_sphere(loaded: &[LoadedSphere]) -> Result<Vec<SphereContacts>> {
    let mut all: Vec<SphereContacts> = Vec::new();
    let mut places: HashMap<SphereId, usize> = HashMap::new();
    for one in loaded {
        let law =
            Law::of(&one.contact, one.radius_m).and_then(|law| Spheres::new(law, 1.0)).map_err(Fault::new)?;
        let place = *places.entry(one.sphere).or_insert(all.len());
        match all.get_mut(place) {
            Some(sphere) => {
                sphere.forces.push(one.force);
                sphere.contacts.push(one.contact);
                sphere.laws.push(law);
            }
            None => all.push(SphereContacts {
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
