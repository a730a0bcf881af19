//! The factor by which each property is scaled, from the ratios of mass, radius, sphere count and gravity; and PredSim's factors, to compare.

use contact_scaling::Ratios;
use osim_model::messages::{Input, readable};
use osim_model::{DissipationBy, Fault, FaultKind, GravityFor, Needed, Property};

use crate::change::ChangedBy;

/// The factor of a property by the paper, and its equation.
pub(crate) fn property_factor(
    property: Property,
    ratios: &Ratios,
    by: DissipationBy,
) -> Option<(f64, ChangedBy)> {
    Some(match property {
        Property::Stiffness => (ratios.plane_strain_modulus(), ChangedBy::Equation("10")),
        Property::Dissipation => match by {
            DissipationBy::Radius => (ratios.dissipation(), ChangedBy::Equation("14")),
            DissipationBy::Mass => (ratios.dissipation_by_mass(), ChangedBy::Equation("14")),
        },
        Property::ConstantContactForce => (ratios.constant_contact_force(), ChangedBy::Equation("C.2")),
        Property::HertzSmoothing => (ratios.hertz_smoothing(), ChangedBy::Equation("C.5")),
        Property::HuntCrossleySmoothing => (ratios.hunt_crossley_smoothing(), ChangedBy::Equation("C.10")),
        Property::TransitionVelocity => (ratios.transition_velocity(), ChangedBy::Friction),
        Property::ViscousFriction => (ratios.viscous_friction(), ChangedBy::Friction),
        _ => return None,
    })
}

/// The change from the gravity that contacts were made for to the gravity that they are scaled to.
pub(crate) struct GravityChange {
    /// γ = g_b/g_a; 1 without a target.
    pub(crate) ratio: f64,
    words: Option<String>,
}

impl GravityChange {
    /// From gravity `now` to `target`; `now_for` is for the error if `now` is not known.
    ///
    /// # Errors
    /// A target that is not above 0, or a gravity that nobody knows.
    pub(crate) fn new(now: Option<f64>, target: Option<f64>, now_for: GravityFor) -> Result<Self, Fault> {
        let Some(target) = target else { return Ok(Self { ratio: 1.0, words: None }) };
        if !(target.is_finite() && target > 0.0) {
            return Err(Fault::new(FaultKind::BadInput {
                input: Input::TargetGravity,
                value: target,
                expected: "an acceleration in m/s2 above 0",
            }));
        }
        match now {
            Some(now) if now.is_finite() && now > 0.0 => {
                let words = format!(
                    "; gravity {} -> {} m/s2 (x{})",
                    readable(now),
                    readable(target),
                    readable(target / now)
                );
                Ok(Self { ratio: target / now, words: Some(words) })
            }
            _ => Err(Fault::new(Needed::Gravity { purpose: now_for })),
        }
    }

    /// The two gravities, for the end of a sentence; empty without a target.
    pub(crate) fn in_words(self) -> String {
        self.words.unwrap_or_default()
    }
}

/// The factor of a property by PredSim's rule; 1 for a property that it takes from the reference without scaling.
pub(crate) fn predsim_factor(
    property: Property,
    ratios: &Ratios,
    height_ratio: f64,
) -> Option<(f64, ChangedBy)> {
    Some(match property {
        Property::Stiffness => (ratios.mass() / (height_ratio * height_ratio), ChangedBy::PredSim),
        Property::Dissipation => (1.0 / height_ratio, ChangedBy::PredSim),
        Property::ConstantContactForce | Property::HertzSmoothing | Property::HuntCrossleySmoothing => {
            (1.0, ChangedBy::PredSim)
        }
        _ => return None,
    })
}
