//! Animals of Table 1.

use std::fmt::Display;

use contact_scaling::{Contact, DomainError, Ratios, Scale, ScaleValues, falisse2022};
use osim_model::files::Failure;

/// Gravity of Table 1, m/s².
const GRAVITY: f64 = 9.81;

/// An animal of Table 1: M in kg, n, R in m.
pub(super) fn animal(mass_kg: f64, sphere_count: f64, radius_m: f64) -> Result<Scale, Failure> {
    Scale::new(ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2: GRAVITY }).map_err(failure)
}

/// The contact of the 62 kg human, scaled to an animal.
pub(super) fn scaled(to: &Scale) -> Result<Contact, Failure> {
    let human = falisse2022();
    let scaled = || -> Result<Contact, DomainError> {
        let from = Scale::new(ScaleValues { gravity_m_s2: GRAVITY, ..human.scale.values() })?;
        Ok(human.contact.scaled(&Ratios::between(&from, to)?))
    };
    scaled().map_err(failure)
}

/// Something that went wrong with numbers of the table.
pub(super) fn failure(error: impl Display) -> Failure {
    Failure::outside("Table 1", "plot", error.to_string())
}
