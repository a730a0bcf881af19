//! The properties that are read and written: their names, units and domains, as OpenSim has them.

use std::fmt;
use std::str::FromStr;

/// A numeric property of a contact force or contact sphere.
///
/// ```
/// use osim_model::Property;
///
/// let property: Property = "constant_contact_force".parse().unwrap();
/// assert_eq!((property, property.unit()), (Property::ConstantContactForce, "m2"));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Property {
    /// `stiffness`, the plane strain modulus E₁* in N/m².
    Stiffness,
    /// `dissipation`, α in s/m.
    Dissipation,
    /// `static_friction`, dimensionless.
    StaticFriction,
    /// `dynamic_friction`, dimensionless.
    DynamicFriction,
    /// `viscous_friction` in s/m.
    ViscousFriction,
    /// `transition_velocity` in m/s.
    TransitionVelocity,
    /// `constant_contact_force`, cf: a squared indentation in m².
    ConstantContactForce,
    /// `hertz_smoothing`, bd in 1/m.
    HertzSmoothing,
    /// `hunt_crossley_smoothing`, bv in s/m.
    HuntCrossleySmoothing,
    /// `radius` of a `ContactSphere`, in m.
    Radius,
    /// `mass` of a `Body`, in kg: read, never written.
    Mass,
}

impl Property {
    /// Every property that can be changed, in the order in which reports list them.
    pub const ALL: [Self; 10] = [
        Self::Stiffness,
        Self::Dissipation,
        Self::StaticFriction,
        Self::DynamicFriction,
        Self::ViscousFriction,
        Self::TransitionVelocity,
        Self::ConstantContactForce,
        Self::HertzSmoothing,
        Self::HuntCrossleySmoothing,
        Self::Radius,
    ];

    /// OpenSim's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stiffness => "stiffness",
            Self::Dissipation => "dissipation",
            Self::StaticFriction => "static_friction",
            Self::DynamicFriction => "dynamic_friction",
            Self::ViscousFriction => "viscous_friction",
            Self::TransitionVelocity => "transition_velocity",
            Self::ConstantContactForce => "constant_contact_force",
            Self::HertzSmoothing => "hertz_smoothing",
            Self::HuntCrossleySmoothing => "hunt_crossley_smoothing",
            Self::Radius => "radius",
            Self::Mass => "mass",
        }
    }

    /// SI unit, for tables, spelled as in all of them: `N/m2`.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Stiffness => "N/m2",
            Self::Dissipation | Self::ViscousFriction | Self::HuntCrossleySmoothing => "s/m",
            Self::StaticFriction | Self::DynamicFriction => "",
            Self::TransitionVelocity => "m/s",
            Self::ConstantContactForce => "m2",
            Self::HertzSmoothing => "1/m",
            Self::Radius => "m",
            Self::Mass => "kg",
        }
    }

    /// Whether `value` is in the domain in which the contact laws hold; checked before anything is scaled.
    #[must_use]
    pub fn allows(self, value: f64) -> bool {
        value.is_finite() && if self.may_be_zero() { value >= 0.0 } else { value > 0.0 }
    }

    /// [`Property::allows`] in words.
    #[must_use]
    pub const fn domain(self) -> &'static str {
        if self.may_be_zero() { "a finite number, 0 or more" } else { "a finite number above 0" }
    }

    const fn may_be_zero(self) -> bool {
        matches!(
            self,
            Self::Dissipation
                | Self::StaticFriction
                | Self::DynamicFriction
                | Self::ViscousFriction
                | Self::ConstantContactForce
                | Self::Mass
        )
    }
}

impl fmt::Display for Property {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Property {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|property| property.name() == text).ok_or_else(|| match near(text) {
            near if near.is_empty() => {
                let names = Self::ALL.map(Self::name);
                format!("there is no property '{text}', expected one of {}", names.join(", "))
            }
            near => format!("there is no property '{text}': did you mean {}?", near.join(" or ")),
        })
    }
}

/// Names that were probably meant by `text`: those spelled almost like it, else those that it is a part of, or that end as it does.
fn near(text: &str) -> Vec<&'static str> {
    /// Letters that differ.
    const TYPED_WRONG: usize = 2;
    /// Shorter parts are in too many names.
    const LONG: usize = 5;

    let flat = |text: &str| text.to_lowercase().replace(['-', '_', ' '], "");
    let end = |text: &str| flat(text.rsplit(['-', '_', ' ']).next().unwrap_or_default());
    let (typed, ending) = (flat(text), end(text));
    let names = || Property::ALL.into_iter().map(Property::name);
    let apart = |name: &str| strsim::osa_distance(&flat(name), &typed);
    let closest = names().map(apart).min().filter(|&apart| apart <= TYPED_WRONG && apart < typed.len());
    if let Some(closest) = closest {
        return names().filter(|name| apart(name) == closest).collect();
    }
    let is_part = |name: &&str| {
        (typed.len() >= LONG && flat(name).contains(&typed)) || (ending.len() >= LONG && end(name) == ending)
    };
    names().filter(is_part).collect()
}

#[cfg(test)]
mod tests {
    use super::near;

    #[test]
    fn what_was_meant_is_found() {
        let smoothing = ["hertz_smoothing", "hunt_crossley_smoothing"];
        assert_eq!(near("hertz_smothing"), ["hertz_smoothing"]);
        assert_eq!(near("hertz-smoothing"), ["hertz_smoothing"]);
        assert_eq!(near("HertzSmoothing"), ["hertz_smoothing"]);
        assert_eq!(near("smoothing"), smoothing);
        assert_eq!(near("derivative_smoothing"), smoothing);
        assert_eq!(near("friction"), ["static_friction", "dynamic_friction", "viscous_friction"]);
        assert_eq!(near("stifness"), ["stiffness"]);
        assert!(near("k").is_empty() && near("damping").is_empty() && near("").is_empty());
    }
}
