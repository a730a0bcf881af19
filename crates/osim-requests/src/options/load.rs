//! How many spheres share which load.

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::relation::Relation;
use crate::values::{Acceleration, Count, Positive};

/// How many spheres share the body weight.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(
    feature = "clap",
    derive(clap::Args),
    command(next_help_heading = "Spheres that share the weight")
)]
#[serde(default)]
pub struct CountOptions {
    /// Spheres that share the body weight, all stance limbs together [default: as found per limb]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub spheres: Option<Count>,
    /// Limbs that share the body weight [default: as the note in the model says, else 1]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub stance_limbs: Option<Count>,
}

impl CountOptions {
    /// n, if given.
    pub fn spheres(&self) -> Option<f64> {
        self.spheres.map(Count::get)
    }

    /// Limbs that share the weight: as said, else as `noted` in the model, else one.
    pub fn stance_limbs(&self, noted: Option<f64>) -> f64 {
        self.stance_limbs.map(Count::get).or(noted).unwrap_or(1.0)
    }

    /// The same, with what else figures are made for.
    #[must_use]
    pub fn stance_options(
        &self,
        impact_speed: Option<Positive>,
        gravity: Option<Acceleration>,
    ) -> StanceOptions {
        StanceOptions { spheres: self.spheres, stance_limbs: self.stance_limbs, impact_speed, gravity }
    }
}

/// What the figures are made for.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(
    feature = "clap",
    derive(clap::Args),
    command(next_help_heading = "What the figures are made for")
)]
#[serde(default)]
pub struct StanceOptions {
    /// Spheres that share the body weight, all stance limbs together [default: as found per limb]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub spheres: Option<Count>,
    /// Limbs that share the body weight [default: as the note in the model says, else 1]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub stance_limbs: Option<Count>,
    /// Impact speed for the restitution, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    #[cfg_attr(feature = "clap", arg(long, value_name = "M/S"))]
    pub impact_speed: Option<Positive>,
    /// Gravity, m/s2 [default: the model's own]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G"))]
    pub gravity: Option<Acceleration>,
}

/// The load on the spheres.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "The load"))]
#[serde(default)]
pub struct LoadOptions {
    /// Total load on all spheres, N
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub load: Option<Positive>,
    /// The load in body weights [default: 1 where a mass is known]
    #[cfg_attr(feature = "clap", arg(long, value_name = "B"))]
    pub body_weights: Option<Positive>,
    /// Gravity, m/s2 [default: the model's, else 9.80665]
    #[cfg_attr(feature = "clap", arg(long, value_name = "G"))]
    pub gravity: Option<Acceleration>,
}

impl LoadOptions {
    /// Which of its fields need or exclude others.
    pub const RELATIONS: &'static [Relation] = &[Relation::Excludes("load", "body_weights")];

    /// The load in body weights, if none is given in newtons.
    pub fn body_weights(&self) -> f64 {
        self.body_weights.map_or(1.0, Positive::get)
    }

    /// Gravity, if given.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity.map(Acceleration::get)
    }
}
