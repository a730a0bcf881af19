//! The common type of the two contact laws, and the spheres of a body.

use crate::error::require_positive;
use crate::{Contact, Hertz, HuntCrossley, Result, SmoothSphere};

/// The normal force of one sphere, by the force class of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Law {
    /// The law of `HuntCrossleyForce`: (12), without a force before contact.
    HuntCrossley(HuntCrossley),
    /// The smoothed law of `SmoothSphereHalfSpaceForce`: (C.9).
    Smooth(SmoothSphere),
}

impl Law {
    /// The law of a sphere of radius R (m) with the parameters `contact` of a model file: smoothed if the contact has
    /// smoothing.
    ///
    /// ```
    /// # use contact_scaling::{Law, falisse2022};
    /// assert!(matches!(Law::of(&falisse2022().contact, 0.032)?, Law::Smooth(_)));
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Hertz::of`].
    pub fn of(contact: &Contact, radius_m: f64) -> Result<Self> {
        Ok(match contact.smoothing() {
            Some(_) => Self::Smooth(SmoothSphere::of(contact, radius_m)?),
            None => Self::HuntCrossley(HuntCrossley::of(contact, radius_m)?),
        })
    }

    /// Normal force, in N, at the indentation x (m) and its rate ẋ (m/s).
    pub fn force(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        match self {
            Self::HuntCrossley(law) => law.force(indentation_m, speed_m_s),
            Self::Smooth(law) => law.force(indentation_m, speed_m_s),
        }
    }

    /// Normal force at speed 0 (ẋ = 0), in N, at the indentation x (m): (1), or (C.9) for a smoothed law.
    ///
    /// From it follow the equilibrium of a body, its stiffness, and the force of a sphere that just touches.
    ///
    /// ```
    /// # use contact_scaling::{Law, falisse2022};
    /// let law = Law::of(&falisse2022().contact, 0.032)?;
    /// assert_eq!(law.rest_force(0.01), law.force(0.01, 0.0));
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn rest_force(&self, indentation_m: f64) -> f64 {
        match self {
            Self::HuntCrossley(law) => law.hertz().force(indentation_m),
            Self::Smooth(law) => law.rest_force(indentation_m),
        }
    }

    /// An upper bound (N) of the force at speed 0 between two indentations (m), of which `to_m` is the deeper one.
    pub(crate) fn rest_force_limit(&self, from_m: f64, to_m: f64) -> f64 {
        match self {
            Self::HuntCrossley(law) => law.hertz().force(to_m),
            Self::Smooth(law) => law.rest_force_limit(from_m, to_m),
        }
    }

    /// Stiffness at speed 0, in N/m, at the indentation x (m): the slope of [`Self::rest_force`].
    pub fn rest_stiffness(&self, indentation_m: f64) -> f64 {
        match self {
            Self::HuntCrossley(law) => law.hertz().stiffness(indentation_m),
            Self::Smooth(law) => law.rest_stiffness(indentation_m),
        }
    }

    /// The Hertz law that this law extends.
    pub fn hertz(&self) -> &Hertz {
        match self {
            Self::HuntCrossley(law) => law.hertz(),
            Self::Smooth(law) => law.hertz(),
        }
    }

    /// This law with another α (s/m).
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless α is finite and 0 or above.
    pub fn with_dissipation(&self, dissipation: f64) -> Result<Self> {
        Ok(match self {
            Self::HuntCrossley(law) => Self::HuntCrossley(HuntCrossley::new(*law.hertz(), dissipation)?),
            Self::Smooth(law) => Self::Smooth(SmoothSphere::new(*law.hertz(), dissipation, law.smoothing())?),
        })
    }

    /// Dissipation α, in s/m.
    pub fn dissipation(&self) -> f64 {
        match self {
            Self::HuntCrossley(law) => law.dissipation(),
            Self::Smooth(law) => law.dissipation(),
        }
    }
}

/// Equal spheres of a body: their law and their number.
///
/// The number may be any number above 0, so that it can describe a load on a part of the spheres, such as one stance limb of two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spheres {
    law: Law,
    count: f64,
}

impl Spheres {
    /// `count` spheres of this law.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless the count is finite and above 0.
    pub fn new(law: Law, count: f64) -> Result<Self> {
        Ok(Self { law, count: require_positive("number of spheres", count)? })
    }

    /// The law of each sphere.
    pub fn law(&self) -> &Law {
        &self.law
    }

    /// How many spheres there are.
    pub fn count(&self) -> f64 {
        self.count
    }

    /// Normal force of all these spheres, in N, at the indentation x (m) and its rate ẋ (m/s).
    pub fn force(&self, indentation_m: f64, speed_m_s: f64) -> f64 {
        self.count * self.law.force(indentation_m, speed_m_s)
    }
}
