//! What changes, how, and by which reference.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_model::messages::{Input, phrase};
use osim_model::{
    Axis, DissipationBy, ForceKind, LevelAxis, MovedSpheres, Pattern, Property, PropertySet, RadiusAxis,
};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::fault::{Relation, RequestFault};
use crate::values::serial::{self, choices};
use crate::values::{Acceleration, BodyScale, Count, Kilograms, Positive, Radius, assignment, bodies, path};

choices! {
    /// Which size dissipation follows (14).
    DissipationChoice: Radius {
        /// R^-1/2.
        Radius = "radius";
        /// M^-1/6.
        Mass = "mass";
    }
}

choices! {
    /// The axis of a sphere's frame that points away from the ground.
    AxisChoice {
        /// x.
        X = "x";
        /// y.
        Y = "y";
        /// z.
        Z = "z";
        /// x, downwards.
        MinusX = "-x";
        /// y, downwards.
        MinusY = "-y";
        /// z, downwards.
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

/// What changes, and how.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "What changes"))]
#[serde(default)]
pub struct ScalingOptions {
    /// Radii: isometric (R ~ M^1/3), keep, a radius in metres, or a factor like x1.5
    /// [default: isometric with `target_mass`, keep otherwise]
    #[cfg_attr(feature = "clap", arg(long, value_name = "RULE"))]
    pub radius: Option<Radius>,
    /// Keep the soles: where a radius changes, move the centre so that the lowest point of the sphere stays
    #[cfg_attr(feature = "clap", arg(long))]
    pub level: bool,
    /// The axis of the spheres' frames that points up with the foot flat [default: nearest to -gravity]
    #[cfg_attr(feature = "clap", arg(long, value_enum, hide_short_help = true, allow_hyphen_values = true))]
    pub level_axis: Option<AxisChoice>,
    /// Only these properties, separated by commas (OpenSim's names, and radius)
    #[cfg_attr(feature = "clap", arg(long, value_name = "LIST", value_delimiter = ',', value_parser = assignment::one))]
    #[serde(with = "assignment")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub only: Vec<Property>,
    /// Everything but these properties
    #[cfg_attr(feature = "clap", arg(long, value_name = "LIST", value_delimiter = ',', value_parser = assignment::one))]
    #[serde(with = "assignment")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub keep: Vec<Property>,
    /// What dissipation follows (14): R^-1/2 or M^-1/6
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t, hide_short_help = true))]
    pub dissipation_by: DissipationChoice,
    /// Scale transition_velocity and viscous_friction too (an extension of the paper)
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub friction: bool,
    /// Gravity the contacts are made for now, m/s2 [default: the note's, else the model's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G", hide_short_help = true))]
    pub contacts_gravity: Option<Acceleration>,
    /// Scale to this gravity too, m/s2 (an extension of the paper) [default with `reference_gravity`: the model's]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G", hide_short_help = true))]
    pub target_gravity: Option<Acceleration>,
}

impl ScalingOptions {
    /// Which of its fields need or exclude others.
    pub(crate) const RELATIONS: &'static [Relation] =
        &[Relation::Needs("level_axis", "level"), Relation::Needs("contacts_gravity", "target_gravity")];

    /// Refuses a choice of properties that leaves nothing.
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

    /// The properties that change.
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

    /// Where up is, if bottoms are to stay.
    pub fn level_axis(&self, gravity: Option<[f64; 3]>) -> Option<LevelAxis> {
        let axis = || self.level_axis.map_or_else(|| LevelAxis::of_gravity(gravity), AxisChoice::axis);
        self.level.then(axis)
    }

    /// What dissipation follows.
    pub fn dissipation(&self) -> DissipationBy {
        match self.dissipation_by {
            DissipationChoice::Radius => DissipationBy::Radius,
            DissipationChoice::Mass => DissipationBy::Mass,
        }
    }
}

choices! {
    /// How a radius follows from three factors.
    RadiusAxisChoice: Geomean {
        /// That of the x axis.
        X = "x";
        /// That of the y axis.
        Y = "y";
        /// That of the z axis.
        Z = "z";
        /// The cube root of their product.
        Geomean = "geomean";
        /// The smallest.
        Min = "min";
        /// The largest.
        Max = "max";
    }
}

choices! {
    /// What happens to spheres that were moved already.
    MovedChoice {
        /// They are right.
        Keep = "keep";
        /// They are placed again.
        Replace = "replace";
    }
}

choices! {
    /// Whose scaling.
    RuleChoice: Paper {
        /// The paper's.
        Paper = "paper";
        /// PredSim's.
        Predsim = "predsim";
    }
}

/// Spheres follow their bodies.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(
    feature = "clap",
    derive(clap::Args),
    command(next_help_heading = "A model that OpenSim scaled (`from` is the generic model)")
)]
#[serde(default)]
pub struct FollowOptions {
    /// Spheres take place and size from their bodies, which OpenSim has scaled
    #[cfg_attr(feature = "clap", arg(long))]
    pub follow_bodies: bool,
    /// The ScaleSet that the Scale Tool applied (its output_scale_file)
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub body_scale_file: Option<PathBuf>,
    /// Factors of a body (or one, BODY=f); may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "BODY=x,y,z"))]
    #[serde(with = "bodies")]
    #[cfg_attr(feature = "schemas", schemars(schema_with = "bodies::body_scale_schema"))]
    pub body_scale: Vec<BodyScale>,
    /// How a radius follows from three factors
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t, hide_short_help = true))]
    pub radius_axis: RadiusAxisChoice,
    /// Spheres that were moved or resized already: keep them, or place them again
    #[cfg_attr(feature = "clap", arg(long, value_enum))]
    pub moved_spheres: Option<MovedChoice>,
    /// Refuse where spheres of one force follow bodies with different factors
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub strict: bool,
    /// The paper's scaling, or PredSim's (stiffness by mass/height^2, dissipation by 1/height)
    #[cfg_attr(feature = "clap", arg(long, value_enum, default_value_t))]
    pub rule: RuleChoice,
    /// Height of this model over that of the reference [default: mean of the body factors]
    #[cfg_attr(feature = "clap", arg(long, value_name = "RATIO", hide_short_help = true))]
    pub height_ratio: Option<Positive>,
}

impl FollowOptions {
    /// Which of its fields need or exclude others.
    pub(crate) const RELATIONS: &'static [Relation] = &[
        Relation::Needs("body_scale_file", "follow_bodies"),
        Relation::Needs("body_scale", "follow_bodies"),
        Relation::Needs("radius_axis", "follow_bodies"),
        Relation::Needs("moved_spheres", "follow_bodies"),
        Relation::Needs("strict", "follow_bodies"),
        Relation::Needs("height_ratio", "rule"),
    ];

    /// Factors by the names of bodies.
    pub fn given(&self) -> BTreeMap<String, [f64; 3]> {
        self.body_scale.iter().map(|scale| (scale.body.clone(), scale.factors)).collect()
    }

    /// What happens to spheres that were moved already.
    pub fn moved(&self) -> MovedSpheres {
        match self.moved_spheres {
            None => MovedSpheres::Refuse,
            Some(MovedChoice::Keep) => MovedSpheres::Keep,
            Some(MovedChoice::Replace) => MovedSpheres::Replace,
        }
    }

    /// How a radius follows from three factors.
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
        /// `SmoothSphereHalfSpaceForce`.
        Smooth = "smooth";
        /// `HuntCrossleyForce`.
        HuntCrossley = "hunt-crossley";
    }
}

choices! {
    /// The axis of a mirror.
    MirrorChoice {
        /// z: right and left.
        Z = "z";
    }
}

impl ClassChoice {
    /// That of OpenSim's class.
    pub const fn of(kind: ForceKind) -> Self {
        match kind {
            ForceKind::SmoothSphereHalfSpace => Self::Smooth,
            ForceKind::HuntCrossley => Self::HuntCrossley,
        }
    }

    /// OpenSim's class.
    pub const fn kind(self) -> ForceKind {
        match self {
            Self::Smooth => ForceKind::SmoothSphereHalfSpace,
            Self::HuntCrossley => ForceKind::HuntCrossley,
        }
    }
}

/// What the reference is, where its file does not say.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "The reference"))]
#[serde(default)]
pub struct ReferenceOptions {
    /// Mass its contacts are made for, kg [default: its note, else its bodies]
    #[cfg_attr(feature = "clap", arg(long, value_name = "KG", allow_hyphen_values = true))]
    pub reference_mass: Option<Kilograms>,
    /// Its spheres that share the body weight [default: as found per limb]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", hide_short_help = true))]
    pub reference_spheres: Option<Count>,
    /// Its gravity, m/s2 [default: its note's, else its own]: said, contacts are scaled from it to `target_gravity`
    #[cfg_attr(feature = "clap", arg(long, value_name = "G", hide_short_help = true))]
    pub reference_gravity: Option<Acceleration>,
    /// Only its forces with such a name; may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "GLOB", hide_short_help = true))]
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub reference_select: Vec<Pattern>,
    /// Take contact and isometric radius of this sphere for all
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME"))]
    pub reference_sphere: Option<String>,
}
