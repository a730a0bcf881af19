//! The contact parameters of a sphere as OpenSim takes them, checked once.

use crate::Ratios;
use crate::error::{DomainError, non_negative, positive};

/// 2^(3/2): E₁* of each of two equal surfaces over the composite E*, by OpenSim's mixing rule (A.3), (A.4).
pub const EQUAL_SURFACES: f64 = 2.0 * std::f64::consts::SQRT_2;

/// The parameters of one contact, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactValues {
    /// E₁*, plane strain modulus of each of two equal surfaces, in N/m²: OpenSim's `stiffness`.
    pub plane_strain_modulus: f64,
    /// α, in s/m: OpenSim's `dissipation`. 0 is legal.
    pub dissipation: f64,
    /// What only `SmoothSphereHalfSpaceForce` has; `None` for `HuntCrossleyForce`.
    pub smoothing: Option<SmoothingValues>,
}

/// The smoothing parameters of `SmoothSphereHalfSpaceForce`, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothingValues {
    /// cf, in m² in spite of its name (C.1): `constant_contact_force`. 0 is legal.
    pub constant_contact_force: f64,
    /// bd, in 1/m: `hertz_smoothing`.
    pub hertz_smoothing: f64,
    /// bv, in s/m: `hunt_crossley_smoothing`.
    pub hunt_crossley_smoothing: f64,
}

impl SmoothingValues {
    /// What OpenSim takes if a file has no value: cf = 1e-5 m², bd = 300 1/m, bv = 50 s/m.
    pub const OPENSIM_DEFAULT: Self =
        Self { constant_contact_force: 1e-5, hertz_smoothing: 300.0, hunt_crossley_smoothing: 50.0 };
}

/// The contact of a sphere with a half-space, both of one material.
///
/// E₁*, bd and bv are above 0, α and cf are 0 or above, all finite: checked once, in [`Contact::new`].
///
/// ```
/// use contact_scaling::{Contact, ContactValues};
/// let contact = Contact::new(ContactValues { plane_strain_modulus: 1e6, dissipation: 2.0, smoothing: None })?;
/// assert!((contact.composite_modulus() - 353_553.39).abs() < 0.01); // Table 1: 0.354 MPa
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact(ContactValues);

impl Contact {
    /// Checks the parameters and keeps them.
    ///
    /// # Errors
    /// [`DomainError`] unless E₁* > 0, α ≥ 0, cf ≥ 0, bd > 0 and bv > 0, all finite.
    pub fn new(values: ContactValues) -> Result<Self, DomainError> {
        positive("plane strain modulus", values.plane_strain_modulus)?;
        non_negative("dissipation", values.dissipation)?;
        if let Some(smoothing) = values.smoothing {
            non_negative("constant contact force", smoothing.constant_contact_force)?;
            positive("hertz smoothing", smoothing.hertz_smoothing)?;
            positive("hunt crossley smoothing", smoothing.hunt_crossley_smoothing)?;
        }
        Ok(Self(values))
    }

    /// Keeps parameters that are known to be valid.
    pub(crate) fn unchecked(values: ContactValues) -> Self {
        Self(values)
    }

    /// The parameters, by name.
    #[must_use]
    pub fn values(&self) -> ContactValues {
        self.0
    }

    /// E₁*, in N/m²: OpenSim's `stiffness`.
    #[must_use]
    pub fn plane_strain_modulus(&self) -> f64 {
        self.0.plane_strain_modulus
    }

    /// E* = E₁* / 2^(3/2), in N/m² (A.4).
    #[must_use]
    pub fn composite_modulus(&self) -> f64 {
        self.plane_strain_modulus() / EQUAL_SURFACES
    }

    /// α, in s/m: OpenSim's `dissipation`.
    #[must_use]
    pub fn dissipation(&self) -> f64 {
        self.0.dissipation
    }

    /// cf, bd and bv, where the law is the smoothed one.
    #[must_use]
    pub fn smoothing(&self) -> Option<SmoothingValues> {
        self.0.smoothing
    }

    /// The contact that is geometrically and dynamically similar to this one at another scale.
    ///
    /// Every parameter is multiplied once by its factor in [`Ratios`], so that ratios of 1 change no bit.
    /// It applies (10), (14), (C.2), (C.5) and (C.10). The products are not checked against the range of `f64`.
    #[must_use]
    pub fn scaled(&self, ratios: &Ratios) -> Self {
        let smoothing = self.smoothing().map(|s| SmoothingValues {
            constant_contact_force: s.constant_contact_force * ratios.constant_contact_force(),
            hertz_smoothing: s.hertz_smoothing * ratios.hertz_smoothing(),
            hunt_crossley_smoothing: s.hunt_crossley_smoothing * ratios.hunt_crossley_smoothing(),
        });
        Self(ContactValues {
            plane_strain_modulus: self.plane_strain_modulus() * ratios.plane_strain_modulus(),
            dissipation: self.dissipation() * ratios.dissipation(),
            smoothing,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMOOTH: SmoothingValues = SmoothingValues::OPENSIM_DEFAULT;
    const VALUES: ContactValues =
        ContactValues { plane_strain_modulus: 1e6, dissipation: 2.0, smoothing: Some(SMOOTH) };

    #[test]
    fn every_field_is_checked_by_name() {
        let refused = |values| Contact::new(values).unwrap_err().quantity();
        let smooth = |smoothing| ContactValues { smoothing: Some(smoothing), ..VALUES };
        assert_eq!(refused(ContactValues { plane_strain_modulus: 0.0, ..VALUES }), "plane strain modulus");
        assert_eq!(refused(ContactValues { dissipation: -1.0, ..VALUES }), "dissipation");
        let cf = SmoothingValues { constant_contact_force: -1e-9, ..SMOOTH };
        assert_eq!(refused(smooth(cf)), "constant contact force");
        let bd = SmoothingValues { hertz_smoothing: 0.0, ..SMOOTH };
        assert_eq!(refused(smooth(bd)), "hertz smoothing");
        let bv = SmoothingValues { hunt_crossley_smoothing: f64::NAN, ..SMOOTH };
        assert_eq!(refused(smooth(bv)), "hunt crossley smoothing");
    }

    #[test]
    fn no_dissipation_and_no_constant_force_are_legal_and_stay() {
        let smoothing = Some(SmoothingValues { constant_contact_force: 0.0, ..SMOOTH });
        let contact = Contact::new(ContactValues { dissipation: 0.0, smoothing, ..VALUES }).unwrap();
        let scaled = contact.scaled(&Ratios::isometric(7.0).unwrap());
        assert_eq!(scaled.dissipation(), 0.0);
        assert_eq!(scaled.smoothing().unwrap().constant_contact_force, 0.0);
    }

    #[test]
    fn ratios_of_one_change_no_bit() {
        let odd = ContactValues {
            plane_strain_modulus: 1_234_567.890_123_4,
            dissipation: 0.1 + 0.2,
            smoothing: Some(SMOOTH),
        };
        let contact = Contact::new(odd).unwrap();
        assert_eq!(contact.scaled(&Ratios::identity()), contact);
    }
}
