//! How deep spheres are where they carry a load.

use crate::model::SphereId;
use contact_scaling::equilibrium::{Raised, hertz_indentation_of_lowest, indentation_of_lowest};
use contact_scaling::{DomainError, Law, Spheres};

use super::gaps::Pressing;

/// The law by which spheres rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(clippy::exhaustive_enums, reason = "Hertz' law is under each law that a file can have")]
pub enum ByLaw {
    /// Hertz' law (1), without the smoothing of the class.
    Hertz,
    /// The law of the force's class, as OpenSim computes it.
    OfFile,
}

/// A joint tree at rest on some of its spheres.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Rest {
    /// How far the spheres move down along the normal from the default pose to this rest, m; below 0 if they move up.
    pub down_m: f64,
    /// The load that they carry, along the normal, N.
    pub load_n: f64,
    /// Each sphere, in file order.
    pub spheres: Vec<RestingSphere>,
}

/// A sphere of a joint tree at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RestingSphere {
    /// The sphere.
    pub sphere: SphereId,
    /// How deep it is in its floor, in its radius: x/R; not above 0 if it does not touch.
    pub relative_indentation: f64,
    /// What it carries along the normal, N.
    pub force_n: f64,
}

impl ByLaw {
    fn force(self, law: &Law, indentation_m: f64) -> f64 {
        match self {
            Self::Hertz => law.hertz().force(indentation_m),
            Self::OfFile => law.rest_force(indentation_m),
        }
    }
}

impl RestingSphere {
    /// Whether it touches the floor: what a smoothed law does before that is not counted.
    #[must_use]
    pub fn touches(&self) -> bool {
        self.relative_indentation > 0.0
    }
}

impl Rest {
    /// The sphere that is deepest, in its radius.
    #[must_use]
    pub fn deepest(&self) -> Option<&RestingSphere> {
        let deeper = |a: &RestingSphere, b: &RestingSphere| {
            a.relative_indentation.total_cmp(&b.relative_indentation).then(b.sphere.cmp(&a.sphere))
        };
        self.spheres.iter().max_by(|a, b| deeper(a, b))
    }

    /// Whether the spheres carry the load with each of them less deep than its radius: beyond that no law knows the sphere.
    #[must_use]
    pub fn is_carried(&self) -> bool {
        self.deepest().is_some_and(|deepest| deepest.relative_indentation < 1.0)
    }

    /// Where the contacts `pressing`, in the order of their spheres, carry `load_n`: the lowest of them is deepest.
    pub(super) fn of(pressing: &[&Pressing], load_n: f64, by: ByLaw) -> Result<Self, DomainError> {
        let lowest_m = pressing.iter().map(|one| one.gap_m).fold(f64::INFINITY, f64::min);
        let mut raised = Vec::new();
        for one in pressing {
            let law = Law::of(&one.contact.contact, one.contact.radius_m)?;
            raised.push(Raised::new(Spheres::new(law, 1.0)?, one.gap_m - lowest_m)?);
        }
        let deepest_m = match by {
            ByLaw::Hertz => hertz_indentation_of_lowest(&raised, load_n),
            ByLaw::OfFile => indentation_of_lowest(&raised, load_n),
        }?;
        let mut spheres: Vec<RestingSphere> = Vec::new();
        for (one, raised) in pressing.iter().zip(&raised) {
            let x = deepest_m - raised.height_m;
            let (sphere, force_n) = (one.contact.sphere, by.force(raised.spheres.law(), x));
            let relative_indentation = x / one.contact.radius_m;
            match spheres.last_mut().filter(|last| last.sphere == sphere) {
                Some(last) => {
                    last.force_n += force_n;
                    last.relative_indentation = last.relative_indentation.max(relative_indentation);
                }
                None => spheres.push(RestingSphere { sphere, relative_indentation, force_n }),
            }
        }
        Ok(Self { down_m: lowest_m + deepest_m, load_n, spheres })
    }
}
