//! What changes, and how.

use osim_model::messages::{Input, phrase};
use osim_model::{Axis, DissipationBy, LevelAxis, Property, PropertySet};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::choice::choices;
use crate::fault::RequestFault;
use crate::relation::Relation;
use crate::values::{Acceleration, Radius, property_list};

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
    #[cfg_attr(feature = "clap", arg(long, value_name = "LIST", value_delimiter = ',', value_parser = property_list::one))]
    #[serde(with = "property_list")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub only: Vec<Property>,
    /// Everything but these properties
    #[cfg_attr(feature = "clap", arg(long, value_name = "LIST", value_delimiter = ',', value_parser = property_list::one))]
    #[serde(with = "property_list")]
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
    pub const RELATIONS: &'static [Relation] =
        &[Relation::Needs("level_axis", "level"), Relation::Needs("contacts_gravity", "target_gravity")];

    /// Refuses a choice of properties that leaves nothing.
    pub fn check(&self) -> Result<(), RequestFault> {
        let never =
            self.only.iter().find(|p| matches!(p, Property::StaticFriction | Property::DynamicFriction));
        if let Some(property) = never {
            return Err(RequestFault::refused(
                Input::Only,
                phrase![
                    Input::Only.being(property.name()),
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
    #[must_use]
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
    #[must_use]
    pub fn dissipation(&self) -> DissipationBy {
        match self.dissipation_by {
            DissipationChoice::Radius => DissipationBy::Radius,
            DissipationChoice::Mass => DissipationBy::Mass,
        }
    }
}
