//! Which properties a run may change.

use crate::model::Property;

/// The properties that may change.
///
/// ```
/// use osim_model::Property;
/// use osim_model::PropertySet;
///
/// // Everything the paper scales; friction is not among it.
/// let all = PropertySet::default();
/// assert!(all.contains(Property::Stiffness) && !all.contains(Property::TransitionVelocity));
/// assert!(all.clone().with_friction().contains(Property::TransitionVelocity));
///
/// // The stiffness alone: the contacts are not similar afterwards, because the others stay behind.
/// let stiffness = all.restricted(&[Property::Stiffness], &[]);
/// assert!(!stiffness.contains(Property::Dissipation) && !stiffness.is_complete());
/// ```
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
    /// The friction speeds too: `transition_velocity` ∝ √(g R) and `viscous_friction` ∝ 1/√(g R), beyond the paper.
    #[must_use]
    pub fn with_friction(mut self) -> Self {
        self.0.extend([Property::TransitionVelocity, Property::ViscousFriction]);
        self
    }

    /// Restricts the set to those of `only` (all, if it is empty) without those of `keep`.
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

    /// Whether everything that the paper scales is in it (a radius may stay: the others then follow from that).
    #[must_use]
    pub fn is_complete(&self) -> bool {
        Self::default().0.iter().all(|&property| property == Property::Radius || self.contains(property))
    }
}
