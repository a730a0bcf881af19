//! Contacts that follow a scaled body.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_model::{MovedSpheres, RadiusAxis};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::choice::choices;
use crate::relation::Relation;
use crate::values::body_scale;
#[cfg(feature = "schemas")]
use crate::values::body_scale::BodyScaleSchema;
use crate::values::{BodyScale, Positive, path};

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
    #[serde(with = "body_scale")]
    #[cfg_attr(feature = "schemas", schemars(with = "BodyScaleSchema"))]
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
    pub const RELATIONS: &'static [Relation] = &[
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
    #[must_use]
    pub fn moved(&self) -> MovedSpheres {
        match self.moved_spheres {
            None => MovedSpheres::Refuse,
            Some(MovedChoice::Keep) => MovedSpheres::Keep,
            Some(MovedChoice::Replace) => MovedSpheres::Replace,
        }
    }

    /// How a radius follows from three factors.
    #[must_use]
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
