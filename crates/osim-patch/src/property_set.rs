//! Which properties a run may change.

use osim_model::Property;

/// The properties a run may change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PropertySet(Vec<Property>);

impl Default for PropertySet {
    /// Everything the paper scales: radius, E₁*, α and the three smoothing parameters.
    fn default() -> Self {
        Self(vec![
            Property::Radius,
            Property::Stiffness,
            Property::Dissipation,
            Property::ConstantContactForce,
            Property::HertzSmoothing,
            Property::HuntCrossleySmoothing,
        ])
    }
}

impl PropertySet {
    /// Friction speeds too: `transition_velocity` and `viscous_friction`.
    #[must_use]
    pub fn with_friction(mut self) -> Self {
        self.0.extend([Property::TransitionVelocity, Property::ViscousFriction]);
        self
    }

    /// Only those of `only` (all, where that is empty) and none of `keep`.
    #[must_use]
    pub fn restricted(mut self, only: &[Property], keep: &[Property]) -> Self {
        self.0.retain(|property| (only.is_empty() || only.contains(property)) && !keep.contains(property));
        self
    }

    /// Whether `property` may change.
    #[must_use]
    pub fn contains(&self, property: Property) -> bool {
        self.0.contains(&property)
    }

    /// `true` when nothing the paper scales is left behind (a radius may stay: the others then follow from that).
    #[must_use]
    pub fn is_complete(&self) -> bool {
        Self::default().0.iter().all(|&property| property == Property::Radius || self.contains(property))
    }
}
