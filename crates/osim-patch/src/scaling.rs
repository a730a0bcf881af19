//! The factor of each property, from the ratios of mass, radius, sphere count and gravity.

use contact_scaling::Ratios;
use osim_model::Property;

/// Which size α follows, (14).
///
/// ```
/// use osim_model::{MassRequest, Model, Property, Selection};
/// use osim_patch::{DissipationBy, RadiusRule, Rescale, rescale};
///
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// # let model = Model::parse(bytes)?;
/// # let selected = Selection::default().apply(&model)?;
/// # let (mass, _) = MassRequest::default().of_contacts(&model)?;
/// // <dissipation>2</dissipation>, from 10 to 640 kg, with spheres that stay.
/// let mut wanted = Rescale::new(640.0, mass);
/// wanted.radius = RadiusRule::Keep;
/// wanted.dissipation_by = DissipationBy::Mass;
/// let plan = rescale(&model, &selected, &wanted)?;
/// let dissipation = plan.changes.iter().find(|change| change.property == Property::Dissipation).unwrap();
/// // 64^{-1/6} is a half. By the radius, which stays, α would stay too.
/// assert!((dissipation.to - 1.0).abs() < 1e-12);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum DissipationBy {
    /// α ∝ R^{−1/2}, as in the paper's Table 1.
    #[default]
    Radius,
    /// α ∝ M^{−1/6}.
    Mass,
}

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
