//! The factor of each property, from the ratios of mass, radius, sphere count and gravity.

use contact_scaling::Ratios;
use osim_model::{DissipationBy, Property};

/// The factor and equation of each property.
pub(crate) fn factor(property: Property, ratios: &Ratios, by: DissipationBy) -> Option<(f64, &'static str)> {
    Some(match property {
        Property::Stiffness => (ratios.plane_strain_modulus(), "10"),
        Property::Dissipation => match by {
            DissipationBy::Radius => (ratios.dissipation(), "14"),
            DissipationBy::Mass => (ratios.dissipation_by_mass(), "14"),
        },
        Property::ConstantContactForce => (ratios.constant_contact_force(), "C.2"),
        Property::HertzSmoothing => (ratios.hertz_smoothing(), "C.5"),
        Property::HuntCrossleySmoothing => (ratios.hunt_crossley_smoothing(), "C.10"),
        Property::TransitionVelocity => (ratios.transition_velocity(), "friction"),
        Property::ViscousFriction => (ratios.viscous_friction(), "friction"),
        _ => return None,
    })
}
