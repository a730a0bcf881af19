//! Radii of spheres that are new, in words.

#[cfg(feature = "schemas")]
use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use osim_model::messages::shortest;
#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::serial::from_text;
use crate::values::typed::{LENGTHS, positive};

/// What is expected of a text.
const EXPECTED: &str = "isometric, follow or a radius in metres";
/// No radius is beyond this, in whatever unit, m.
const LARGEST: f64 = 1e9;

/// `isometric`, `follow` or metres.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum NewRadius {
    /// The reference's times the cube root of the masses' ratio (8).
    #[default]
    Isometric,
    /// The reference's times the geometric mean of the factors of the body that carries the sphere.
    Follow,
    /// All are this, m.
    Metres(f64),
}

#[cfg(feature = "schemas")]
impl JsonSchema for NewRadius {
    fn schema_name() -> Cow<'static, str> {
        "NewRadius".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({"anyOf": [
            {"type": "number", "exclusiveMinimum": 0, "maximum": 1e9, "description": "metres"},
            {"type": "string", "pattern": "^(isometric|follow)$"},
        ]})
    }

    fn inline_schema() -> bool {
        true
    }
}

impl FromStr for NewRadius {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "isometric" => Ok(Self::Isometric),
            "follow" => Ok(Self::Follow),
            _ => match positive(text, EXPECTED, LENGTHS)? {
                metres if metres <= LARGEST => Ok(Self::Metres(metres)),
                _ => Err(format!("expected {EXPECTED}, at most 1e9")),
            },
        }
    }
}

impl fmt::Display for NewRadius {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Isometric => f.write_str("isometric"),
            Self::Follow => f.write_str("follow"),
            Self::Metres(metres) => f.write_str(&shortest(*metres)),
        }
    }
}

impl Serialize for NewRadius {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Metres(metres) => serializer.serialize_f64(*metres),
            _ => serializer.collect_str(self),
        }
    }
}

impl<'d> Deserialize<'d> for NewRadius {
    fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
        from_text(deserializer)
    }
}
