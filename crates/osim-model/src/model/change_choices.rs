//! Choices in a request: the properties to change, new values, and rules for radii and spheres.

use crate::messages::shortest;
use crate::model::Property;

/// The set of properties that a request may change.
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
    fn default() -> Self {
        Self(Self::SCALED.to_vec())
    }
}

impl PropertySet {
    /// All properties that the paper scales: radius, E₁*, α and the three smoothing parameters.
    pub const SCALED: [Property; 6] = [
        Property::Radius,
        Property::Stiffness,
        Property::Dissipation,
        Property::ConstantContactForce,
        Property::HertzSmoothing,
        Property::HuntCrossleySmoothing,
    ];

    /// Adds the friction speeds, which the paper does not scale: `transition_velocity` ∝ √(g R) and `viscous_friction` ∝ 1/√(g R).
    pub fn with_friction(mut self) -> Self {
        self.0.extend([Property::TransitionVelocity, Property::ViscousFriction]);
        self
    }

    /// Keeps the properties in `only` (all properties if `only` is empty), without those in `keep`.
    pub fn restricted(mut self, only: &[Property], keep: &[Property]) -> Self {
        self.0.retain(|property| (only.is_empty() || only.contains(property)) && !keep.contains(property));
        self
    }

    pub fn contains(&self, property: Property) -> bool {
        self.0.contains(&property)
    }

    /// Whether the set has all properties that the paper scales. The radius may be missing: the other properties then follow from the
    /// unchanged radius.
    pub fn is_complete(&self) -> bool {
        Self::SCALED.into_iter().all(|property| property == Property::Radius || self.contains(property))
    }
}

/// A new value of a property, or a factor for its present value.
///
/// Exhaustive: a number is set or multiplied, and nothing else.
///
/// ```
/// use osim_model::Assignment;
/// assert_eq!(Assignment::Value(1e6).to_string(), "1000000");
/// assert_eq!(Assignment::Factor(0.5).to_string(), "x0.5");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Assignment {
    /// The new value in the unit of the property.
    Value(f64),
    /// The factor that multiplies the present value.
    Factor(f64),
}

impl std::fmt::Display for Assignment {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Value(value) => f.write_str(&shortest(*value)),
            Self::Factor(factor) => write!(f, "x{}", shortest(*factor)),
        }
    }
}

/// The rule that gives moving spheres their new radii.
///
/// Exhaustive: plans of changes have a formula for each rule.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum RadiusRule {
    /// R ∝ M^{1/3}, like the linear dimensions of the body (8). In a transfer: as large relative to the body as in the reference.
    Isometric,
    #[default]
    Keep,
    /// All radii get this value, m.
    Metres(f64),
    /// All radii are multiplied by this factor.
    Factor(f64),
}

/// Whether the dissipation α changes with the radius or with the mass, (14).
///
/// Exhaustive: plans of changes have a factor for each choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DissipationBy {
    /// α ∝ R^{−1/2}: dissipation changes with the radius, as in the paper's Table 1.
    #[default]
    Radius,
    /// α ∝ M^{−1/6}: dissipation changes with the mass.
    Mass,
}

/// How the ratio of radii follows from a body's factors along x, y and z.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RadiusAxis {
    X,
    Y,
    Z,
    /// The cube root of the product of the three factors.
    #[default]
    GeometricMean,
    Min,
    Max,
}

impl RadiusAxis {
    /// The ratio of radii for a body's factors along x, y and z.
    pub fn radius_ratio(self, [x, y, z]: [f64; 3]) -> f64 {
        match self {
            Self::X => x,
            Self::Y => y,
            Self::Z => z,
            // Three equal factors are their own mean, to the last bit.
            Self::GeometricMean if x == y && y == z => x,
            Self::GeometricMean => libm::cbrt(x * y * z),
            Self::Min => x.min(y).min(z),
            Self::Max => x.max(y).max(z),
        }
    }
}

/// What to do with spheres of the scaled model that somebody has already moved or resized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MovedSpheres {
    /// Refuse the request, so that the caller decides ([`MissingFact::MovedSpheres`](crate::model::MissingFact::MovedSpheres)).
    #[default]
    Refuse,
    /// The spheres are right: keep their location and radius.
    Keep,
    /// The spheres are wrong: place them again from the reference.
    Replace,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_ratios_follow_the_requested_axis() {
        let factors = [1.0, 2.0, 4.0];
        let ratio = |axis: RadiusAxis| axis.radius_ratio(factors);
        assert_eq!((ratio(RadiusAxis::X), ratio(RadiusAxis::Y), ratio(RadiusAxis::Z)), (1.0, 2.0, 4.0));
        assert_eq!((ratio(RadiusAxis::Min), ratio(RadiusAxis::Max)), (1.0, 4.0));
        assert!((ratio(RadiusAxis::GeometricMean) - 2.0).abs() < 1e-15);
        assert_eq!(RadiusAxis::GeometricMean.radius_ratio([1.3, 1.3, 1.3]), 1.3);
    }
}
