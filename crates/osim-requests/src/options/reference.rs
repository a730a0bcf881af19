//! What a reference is, where its file does not say.

use osim_model::Pattern;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::values::{Acceleration, Count, Kilograms, serial};

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
