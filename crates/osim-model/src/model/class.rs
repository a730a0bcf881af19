//! The OpenSim classes whose numbers are read and written: their defaults, and the order of their elements.

use crate::model::property::Property;

/// An OpenSim class whose numbers are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Class {
    /// `HuntCrossleyForce`
    HuntCrossleyForce,
    /// `HuntCrossleyForce::ContactParameters`
    ContactParameters,
    /// `SmoothSphereHalfSpaceForce`
    SmoothSphereHalfSpaceForce,
    /// `ContactSphere`
    ContactSphere,
    /// `ContactHalfSpace`
    ContactHalfSpace,
    /// `Body`
    Body,
}

impl Class {
    /// The tag of its elements.
    #[must_use]
    pub const fn tag(self) -> &'static str {
        match self {
            Self::HuntCrossleyForce => "HuntCrossleyForce",
            Self::ContactParameters => "HuntCrossleyForce::ContactParameters",
            Self::SmoothSphereHalfSpaceForce => "SmoothSphereHalfSpaceForce",
            Self::ContactSphere => "ContactSphere",
            Self::ContactHalfSpace => "ContactHalfSpace",
            Self::Body => "Body",
        }
    }

    /// What OpenSim uses where neither the element nor `<defaults>` says anything (seen in OpenSim 4.6).
    #[must_use]
    pub const fn default(self, property: Property) -> f64 {
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
    #[must_use]
    pub const fn order(self) -> &'static [&'static str] {
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
            Self::ContactHalfSpace => &[
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
            ],
            Self::Body => &[],
        }
    }

    /// Numeric properties of a contact force of this class, in OpenSim's order.
    #[must_use]
    pub const fn parameters(self) -> &'static [Property] {
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
            Self::ContactHalfSpace => &[],
            Self::Body => &[Property::Mass],
        }
    }
}
