//! The properties this crate reads and writes: their names, order, class defaults and domains, as OpenSim has them.

use std::fmt;
use std::str::FromStr;

/// A numeric property of a contact force or contact sphere.
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

    /// SI unit, for tables.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Stiffness => "N/m^2",
            Self::Dissipation | Self::ViscousFriction | Self::HuntCrossleySmoothing => "s/m",
            Self::StaticFriction | Self::DynamicFriction => "",
            Self::TransitionVelocity => "m/s",
            Self::ConstantContactForce => "m^2",
            Self::HertzSmoothing => "1/m",
            Self::Radius => "m",
            Self::Mass => "kg",
        }
    }

    /// The domain in which the contact laws hold, checked before anything is scaled.
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
        Self::ALL.into_iter().find(|property| property.name() == text).ok_or_else(|| {
            let names: Vec<_> = Self::ALL.iter().map(|property| property.name()).collect();
            format!("unknown property '{text}', expected one of {}", names.join(", "))
        })
    }
}

/// An OpenSim class whose numbers this crate reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Class {
    HuntCrossleyForce,
    ContactParameters,
    SmoothSphereHalfSpaceForce,
    ContactSphere,
    Body,
}

impl Class {
    pub(crate) const fn tag(self) -> &'static str {
        match self {
            Self::HuntCrossleyForce => "HuntCrossleyForce",
            Self::ContactParameters => "HuntCrossleyForce::ContactParameters",
            Self::SmoothSphereHalfSpaceForce => "SmoothSphereHalfSpaceForce",
            Self::ContactSphere => "ContactSphere",
            Self::Body => "Body",
        }
    }

    /// What OpenSim uses where neither the element nor `<defaults>` says anything (seen in OpenSim 4.6).
    pub(crate) const fn default(self, property: Property) -> f64 {
        match (self, property) {
            (Self::SmoothSphereHalfSpaceForce, Property::Stiffness) => 1.0,
            (_, Property::Mass) => f64::NAN,
            (_, Property::TransitionVelocity) => 0.01,
            (_, Property::ConstantContactForce) => 1e-5,
            (_, Property::HertzSmoothing) => 300.0,
            (_, Property::HuntCrossleySmoothing) => 50.0,
            _ => 0.0,
        }
    }

    /// All child elements in the order in which OpenSim writes them; an absent one is inserted at its place.
    pub(crate) const fn order(self) -> &'static [&'static str] {
        match self {
            Self::HuntCrossleyForce => &[
                "isDisabled",
                "appliesForce",
                "HuntCrossleyForce::ContactParametersSet",
                "transition_velocity",
            ],
            Self::ContactParameters => &[
                "geometry",
                "stiffness",
                "dissipation",
                "static_friction",
                "dynamic_friction",
                "viscous_friction",
            ],
            Self::SmoothSphereHalfSpaceForce => &[
                "socket_sphere",
                "socket_half_space",
                "socket_sphere_frame",
                "socket_half_space_frame",
                "appliesForce",
                "contact_sphere_radius",
                "contact_sphere_location",
                "contact_half_space_location",
                "contact_half_space_orientation",
                "stiffness",
                "dissipation",
                "static_friction",
                "dynamic_friction",
                "viscous_friction",
                "transition_velocity",
                "constant_contact_force",
                "derivative_smoothing",
                "hertz_smoothing",
                "hunt_crossley_smoothing",
                "force_visualization_radius",
                "force_visualization_scale_factor",
            ],
            Self::ContactSphere => &[
                "socket_frame",
                "socket_frame_connectee_name",
                "connector_frame_connectee_name",
                "connectors",
                "body_name",
                "location",
                "orientation",
                "display_preference",
                "color",
                "Appearance",
                "radius",
            ],
            Self::Body => &[],
        }
    }

    /// Numeric properties of a contact force of this class, in OpenSim's order.
    pub(crate) const fn parameters(self) -> &'static [Property] {
        match self {
            Self::HuntCrossleyForce => &[Property::TransitionVelocity],
            Self::ContactParameters => &[
                Property::Stiffness,
                Property::Dissipation,
                Property::StaticFriction,
                Property::DynamicFriction,
                Property::ViscousFriction,
            ],
            Self::SmoothSphereHalfSpaceForce => &[
                Property::Stiffness,
                Property::Dissipation,
                Property::StaticFriction,
                Property::DynamicFriction,
                Property::ViscousFriction,
                Property::TransitionVelocity,
                Property::ConstantContactForce,
                Property::HertzSmoothing,
                Property::HuntCrossleySmoothing,
            ],
            Self::ContactSphere => &[Property::Radius],
            Self::Body => &[Property::Mass],
        }
    }
}
