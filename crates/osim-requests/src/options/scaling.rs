//! Options for the properties that change, the rules of the change, and the reference.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_model::messages::{Input, phrase};
use osim_model::{
    Axis, DissipationBy, ForceKind, LevelAxis, MovedSpheres, Pattern, Property, PropertySet, RadiusAxis,
};
use serde::{Deserialize, Serialize};

use crate::fault::{Relation, RequestFault};
use crate::values::serial::{self, choices};
use crate::values::{Acceleration, BodyScale, Count, Kilograms, Positive, Radius, assignment, bodies, path};

choices! {
    /// Which size dissipation follows (14).
    DissipationChoice: Radius {
        Radius = "radius";
        Mass = "mass";
    }
}

choices! {
    /// The axis of a sphere's frame that points away from the ground.
    AxisChoice {
        X = "x";
        Y = "y";
        Z = "z";
        MinusX = "-x";
        MinusY = "-y";
        MinusZ = "-z";
    }
}

impl AxisChoice {
    fn axis(self) -> LevelAxis {
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

/// Options for the properties that change, and how.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct ScalingOptions {
    pub radius: Option<Radius>,
    pub level: bool,
    pub level_axis: Option<AxisChoice>,
    #[serde(with = "assignment")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub only: Vec<Property>,
    #[serde(with = "assignment")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub keep: Vec<Property>,
    pub dissipation_by: DissipationChoice,
    pub friction: bool,
    pub contacts_gravity: Option<Acceleration>,
    pub target_gravity: Option<Acceleration>,
}

impl ScalingOptions {
    /// Conditions between the options for scaling.
    pub(crate) const RELATIONS: &'static [Relation] =
        &[Relation::Needs("level_axis", "level"), Relation::Needs("contacts_gravity", "target_gravity")];

    /// Refuses a choice of properties that contains no property.
    pub fn check(&self) -> Result<(), RequestFault> {
        let never =
            self.only.iter().find(|p| matches!(p, Property::StaticFriction | Property::DynamicFriction));
        if let Some(property) = never {
            return Err(RequestFault::refused(
                Input::Only,
                phrase![
                    Input::Only.with_value(property.name()),
                    ": it has no dimension, so it is the same at every size; change it with set",
                ],
            ));
        }
        let properties = self.properties();
        if Property::ALL.iter().all(|&property| !properties.contains(property)) {
            let message = phrase![Input::Only, " and ", Input::Keep, " leave no property to change"];
            return Err(RequestFault::refused(Input::Only, message));
        }
        Ok(())
    }

    /// The properties that a scaling changes.
    pub fn properties(&self) -> PropertySet {
        // Naming a friction property among those that change asks for it.
        let friction = self.friction
            || self
                .only
                .iter()
                .any(|p| matches!(p, Property::TransitionVelocity | Property::ViscousFriction));
        let all = PropertySet::default();
        let all = if friction { all.with_friction() } else { all };
        all.restricted(&self.only, &self.keep)
    }

    /// The axis up, if the lowest points of spheres are to stay; `gravity` is that of the model.
    pub fn level_axis(&self, gravity: Option<[f64; 3]>) -> Option<LevelAxis> {
        let axis = || self.level_axis.map_or_else(|| LevelAxis::of_gravity(gravity), AxisChoice::axis);
        self.level.then(axis)
    }

    /// Whether dissipation follows the radius or the mass.
    pub fn dissipation(&self) -> DissipationBy {
        match self.dissipation_by {
            DissipationChoice::Radius => DissipationBy::Radius,
            DissipationChoice::Mass => DissipationBy::Mass,
        }
    }
}

choices! {
    /// How the radius of a sphere follows from the three factors of its body.
    RadiusAxisChoice: Geomean {
        X = "x";
        Y = "y";
        Z = "z";
        Geomean = "geomean";
        Min = "min";
        Max = "max";
    }
}

choices! {
    /// The rule for spheres that were moved already.
    MovedChoice {
        Keep = "keep";
        Replace = "replace";
    }
}

choices! {
    /// The rule of scaling.
    RuleChoice: Paper {
        Paper = "paper";
        Predsim = "predsim";
    }
}

/// Spheres follow their bodies.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct FollowOptions {
    pub follow_bodies: bool,
    #[serde(with = "path::Optional")]
    pub body_scale_file: Option<PathBuf>,
    #[serde(with = "bodies")]
    #[cfg_attr(feature = "schemas", schemars(schema_with = "bodies::body_scale_schema"))]
    pub body_scale: Vec<BodyScale>,
    pub radius_axis: RadiusAxisChoice,
    pub moved_spheres: Option<MovedChoice>,
    pub strict: bool,
    pub rule: RuleChoice,
    pub height_ratio: Option<Positive>,
}

impl FollowOptions {
    /// Conditions between the options for spheres that follow their bodies.
    pub(crate) const RELATIONS: &'static [Relation] = &[
        Relation::Needs("body_scale_file", "follow_bodies"),
        Relation::Needs("body_scale", "follow_bodies"),
        Relation::Needs("radius_axis", "follow_bodies"),
        Relation::Needs("moved_spheres", "follow_bodies"),
        Relation::Needs("strict", "follow_bodies"),
        Relation::Needs("height_ratio", "rule"),
    ];

    /// The scale factors given by the caller, by names of bodies.
    pub fn given(&self) -> BTreeMap<String, [f64; 3]> {
        self.body_scale.iter().map(|scale| (scale.body.clone(), scale.factors)).collect()
    }

    /// The rule for spheres that were moved already.
    pub fn moved(&self) -> MovedSpheres {
        match self.moved_spheres {
            None => MovedSpheres::Refuse,
            Some(MovedChoice::Keep) => MovedSpheres::Keep,
            Some(MovedChoice::Replace) => MovedSpheres::Replace,
        }
    }

    /// How the radius of a sphere follows from the three factors of its body.
    pub fn radius_axis(&self) -> RadiusAxis {
        match self.radius_axis {
            RadiusAxisChoice::X => RadiusAxis::X,
            RadiusAxisChoice::Y => RadiusAxis::Y,
            RadiusAxisChoice::Z => RadiusAxis::Z,
            RadiusAxisChoice::Geomean => RadiusAxis::GeometricMean,
            RadiusAxisChoice::Min => RadiusAxis::Min,
            RadiusAxisChoice::Max => RadiusAxis::Max,
        }
    }
}

choices! {
    /// A class of contact forces.
    ClassChoice {
        Smooth = "smooth";
        HuntCrossley = "hunt-crossley";
    }
}

choices! {
    /// The axis of a mirror.
    MirrorChoice {
        Z = "z";
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

/// Options for facts about the reference that its file does not say.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(default)]
pub struct ReferenceOptions {
    pub reference_mass: Option<Kilograms>,
    pub reference_spheres: Option<Count>,
    pub reference_gravity: Option<Acceleration>,
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub reference_select: Vec<Pattern>,
    pub reference_sphere: Option<String>,
}
