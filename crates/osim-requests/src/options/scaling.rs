//! Options for the properties that change, the rules of the change, and the reference.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_model::messages::{Input, phrase};
use osim_model::{
    Axis, DissipationBy, ForceKind, LevelAxis, MovedSpheres, Pattern, Property, PropertySet, RadiusAxis,
    RadiusRule,
};

use crate::fault::RequestFault;
use crate::values::serial::{self, choices, fields};
use crate::values::{Acceleration, BodyScale, Count, Kilograms, Positive, Radius, assignment, bodies, path};

choices! {
    /// Which size dissipation follows (14).
    DissipationChoice: Radius {
        Radius = "radius";
        Mass = "mass";
    }

    /// The axis of a sphere's frame that points away from the ground.
    AxisChoice {
        X = "x";
        Y = "y";
        Z = "z";
        MinusX = "-x";
        MinusY = "-y";
        MinusZ = "-z";
    }

    /// How the radius of a sphere follows from the three factors of its body.
    RadiusAxisChoice {
        X = "x";
        Y = "y";
        Z = "z";
        Geomean = "geomean";
        Min = "min";
        Max = "max";
    }

    /// The rule for spheres that were moved already.
    MovedChoice {
        Keep = "keep";
        Replace = "replace";
    }

    /// The rule of scaling.
    RuleChoice: Paper {
        Paper = "paper";
        Predsim = "predsim";
    }

    /// A class of contact forces.
    ClassChoice {
        Smooth = "smooth";
        HuntCrossley = "hunt-crossley";
    }

    /// The axis of a mirror.
    MirrorChoice {
        Z = "z";
    }
}

impl AxisChoice {
    /// The axis that points up.
    pub fn axis(self) -> LevelAxis {
        let (axis, down) = match self {
            Self::X => (Axis::X, false),
            Self::Y => (Axis::Y, false),
            Self::Z => (Axis::Z, false),
            Self::MinusX => (Axis::X, true),
            Self::MinusY => (Axis::Y, true),
            Self::MinusZ => (Axis::Z, true),
        };
        LevelAxis { axis, down, of_body: false }
    }
}

fields! {
    /// Options for the properties that change, and how.
    struct ScalingOptions {
        radius: Option<Radius>,
        level: bool,
        level_axis: Option<AxisChoice>,
        #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
        only: Vec<Property> as "assignment",
        #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
        keep: Vec<Property> as "assignment",
        dissipation_by: DissipationChoice,
        friction: bool,
        contacts_gravity: Option<Acceleration>,
        target_gravity: Option<Acceleration>,
    } where Needs("level_axis", "level"), Needs("contacts_gravity", "target_gravity");

    /// Spheres follow their bodies.
    struct FollowOptions {
        follow_bodies: bool,
        body_scale_file: Option<PathBuf> as "path::Optional",
        #[cfg_attr(feature = "schemas", schemars(schema_with = "bodies::body_scale_schema"))]
        body_scale: Vec<BodyScale> as "bodies",
        radius_axis: Option<RadiusAxisChoice>,
        moved_spheres: Option<MovedChoice>,
        strict: bool,
        rule: RuleChoice,
        height_ratio: Option<Positive>,
    } where
        Needs("body_scale_file", "follow_bodies"), Needs("body_scale", "follow_bodies"),
        Needs("radius_axis", "follow_bodies"), Needs("moved_spheres", "follow_bodies"),
        Needs("strict", "follow_bodies"), Needs("height_ratio", "rule");

    /// Options for facts about the reference that its file does not say.
    struct ReferenceOptions {
        reference_mass: Option<Kilograms>,
        reference_spheres: Option<Count>,
        reference_gravity: Option<Acceleration>,
        reference_select: Vec<Pattern> as "serial::Texts",
        reference_sphere: Option<String>,
    }
}

impl ScalingOptions {
    /// Refuses a choice of properties that contains no property.
    pub fn check(&self) -> Result<(), RequestFault> {
        let never =
            self.only.iter().find(|p| matches!(p, Property::StaticFriction | Property::DynamicFriction));
        if let Some(property) = never {
            let message = phrase![
                Input::Only.with_value(property.as_str()),
                ": it has no dimension, so it is the same at every size; change it with set",
            ];
            return Err(RequestFault::refused(Input::Only, message));
        }
        let properties = self.properties();
        if Property::changeable().all(|property| !properties.contains(property)) {
            let message = phrase![Input::Only, " and ", Input::Keep, " leave no property to change"];
            return Err(RequestFault::refused(Input::Only, message));
        }
        Ok(())
    }

    /// The properties that a scaling changes: those of `only`, else all, without those of `keep`. Friction is left out unless it is asked
    /// for.
    pub fn properties(&self) -> PropertySet {
        // Naming a friction property among those that change asks for it.
        let asks = |p: &Property| matches!(p, Property::TransitionVelocity | Property::ViscousFriction);
        let friction = self.friction || self.only.iter().any(asks);
        let all = PropertySet::default();
        let all = if friction { all.with_friction() } else { all };
        all.restricted(&self.only, &self.keep)
    }

    /// The rule for new radii, if one is given and it is not that radii follow bodies.
    pub fn radius(&self) -> Option<RadiusRule> {
        self.radius.and_then(Radius::rule)
    }

    /// Refuses radii that follow bodies, in a change in which they cannot.
    pub fn refuse_radii_of_bodies(&self) -> Result<(), RequestFault> {
        if self.radius != Some(Radius::FOLLOW) {
            return Ok(());
        }
        let message = phrase![
            Input::Radius.with_value("follow"),
            " is for transfer with ",
            Input::FollowBodies,
            ", which knows how bodies were scaled",
        ];
        Err(RequestFault::refused(Input::Radius, message))
    }

    /// Whether dissipation follows the radius or the mass.
    pub fn dissipation(&self) -> DissipationBy {
        match self.dissipation_by {
            DissipationChoice::Radius => DissipationBy::Radius,
            DissipationChoice::Mass => DissipationBy::Mass,
        }
    }
}

impl FollowOptions {
    /// The scale factors given by the caller, by names of bodies.
    pub fn factors(&self) -> BTreeMap<String, [f64; 3]> {
        self.body_scale.iter().map(|scale| (scale.body.clone(), scale.factors)).collect()
    }

    /// The rule for spheres that were moved already.
    pub fn rule_for_moved_spheres(&self) -> MovedSpheres {
        match self.moved_spheres {
            None => MovedSpheres::Refuse,
            Some(MovedChoice::Keep) => MovedSpheres::Keep,
            Some(MovedChoice::Replace) => MovedSpheres::Replace,
        }
    }

    /// How the radius of a sphere follows from the three factors of its body.
    pub fn radius_axis(&self) -> RadiusAxis {
        match self.radius_axis {
            None | Some(RadiusAxisChoice::Geomean) => RadiusAxis::GeometricMean,
            Some(RadiusAxisChoice::X) => RadiusAxis::X,
            Some(RadiusAxisChoice::Y) => RadiusAxis::Y,
            Some(RadiusAxisChoice::Z) => RadiusAxis::Z,
            Some(RadiusAxisChoice::Min) => RadiusAxis::Min,
            Some(RadiusAxisChoice::Max) => RadiusAxis::Max,
        }
    }
}

impl ClassChoice {
    /// The choice that means OpenSim's class `kind`.
    pub const fn of(kind: ForceKind) -> Self {
        match kind {
            ForceKind::SmoothSphereHalfSpace => Self::Smooth,
            ForceKind::HuntCrossley => Self::HuntCrossley,
        }
    }

    /// OpenSim's class that the choice means.
    pub const fn kind(self) -> ForceKind {
        match self {
            Self::Smooth => ForceKind::SmoothSphereHalfSpace,
            Self::HuntCrossley => ForceKind::HuntCrossley,
        }
    }
}
