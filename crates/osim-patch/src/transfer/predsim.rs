//! PredSim's rule, for users who compare.

use contact_scaling::Ratios;
use osim_model::Property;

/// PredSim's rule, for users who compare; what it does not scale is the reference's.
pub(crate) fn predsim(property: Property, ratios: &Ratios, height_ratio: f64) -> Option<(f64, &'static str)> {
    Some(match property {
        Property::Stiffness => (ratios.mass() / (height_ratio * height_ratio), "predsim"),
        Property::Dissipation => (1.0 / height_ratio, "predsim"),
        Property::ConstantContactForce | Property::HertzSmoothing | Property::HuntCrossleySmoothing => {
            (1.0, "predsim")
        }
        _ => return None,
    })
}
