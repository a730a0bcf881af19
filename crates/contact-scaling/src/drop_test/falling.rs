//! A body that falls on its spheres.

use super::body::Body;
use super::error::DropError;
use super::motion;
use super::report::DropReport;
use super::values::DropValues;
use crate::error::{non_negative, positive, within};
use crate::{Contact, DomainError, Law, Scale, Spheres};

/// A drop test that can be run.
///
/// M, g and the duration are above 0, the height 0 or above, all finite; at least one sphere, at least two
/// samples: checked once, in [`DropTest::new`].
#[derive(Debug, Clone, PartialEq)]
pub struct DropTest {
    values: DropValues,
    spheres: Vec<Spheres>,
}

impl DropTest {
    /// Samples of a series where nobody said how many.
    pub const SAMPLES: usize = 1001;

    /// A drop test of a body on these spheres. Spheres of the same law are taken together.
    ///
    /// # Errors
    /// [`DropError::Domain`] where a number is outside its domain or there is no sphere.
    pub fn new(spheres: impl IntoIterator<Item = Spheres>, values: DropValues) -> Result<Self, DropError> {
        positive("mass", values.mass_kg)?;
        positive("gravity", values.gravity_m_s2)?;
        non_negative("height", values.height_m)?;
        positive("duration", values.duration_s)?;
        within(values.samples >= 2, "number of samples", values.samples as f64, "at least 2")?;
        let spheres = together(spheres)?;
        within(!spheres.is_empty(), "number of spheres", 0.0, "at least 1")?;
        Ok(Self { values, spheres })
    }

    /// A drop test of a body of scale `scale` on n equal spheres, from a height in sphere radii (0.25 in the
    /// paper), for a duration in s (2 in the paper).
    ///
    /// # Errors
    /// As [`DropTest::new`].
    pub fn of(
        contact: &Contact,
        scale: &Scale,
        height_radii: f64,
        duration_s: f64,
    ) -> Result<Self, DropError> {
        let law = Law::of(contact, scale.radius_m())?;
        let values = DropValues {
            mass_kg: scale.mass_kg(),
            gravity_m_s2: scale.gravity_m_s2(),
            height_m: height_radii * scale.radius_m(),
            duration_s,
            samples: Self::SAMPLES,
        };
        Self::new([Spheres::new(law, scale.sphere_count())?], values)
    }

    /// The conditions, by name.
    #[must_use]
    pub fn values(&self) -> DropValues {
        self.values
    }

    /// The spheres, equal ones together.
    #[must_use]
    pub fn spheres(&self) -> &[Spheres] {
        &self.spheres
    }

    /// The radius lengths are compared with: √(Σ R_i² / n), in m.
    #[must_use]
    pub fn reference_radius_m(&self) -> f64 {
        self.body().length_m
    }

    /// Follows the body.
    ///
    /// # Errors
    /// [`DropError::Integration`] where the contact is too stiff for the duration; [`DropError::Domain`] where no
    /// indentation carries the body weight.
    pub fn run(&self) -> Result<DropReport, DropError> {
        let body = self.body();
        let record = motion::follow(&body, &self.values)?;
        DropReport::new(&body, &self.values, record)
    }

    /// The same spheres under other conditions, which are known to be right.
    pub(super) fn under(&self, values: DropValues) -> Self {
        Self { values, spheres: self.spheres.clone() }
    }

    pub(super) fn body(&self) -> Body<'_> {
        Body::new(&self.spheres, self.values.mass_kg, self.values.gravity_m_s2)
    }
}

/// Spheres of one law as one entry.
fn together(spheres: impl IntoIterator<Item = Spheres>) -> Result<Vec<Spheres>, DomainError> {
    let mut groups: Vec<Spheres> = Vec::new();
    for one in spheres {
        match groups.iter_mut().find(|group| group.law() == one.law()) {
            Some(group) => *group = Spheres::new(*one.law(), group.count() + one.count())?,
            None => groups.push(one),
        }
    }
    Ok(groups)
}
