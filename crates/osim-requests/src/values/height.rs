//! From how high a body falls, in words.

use std::fmt;
use std::str::FromStr;

use osim_model::messages::shortest;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::serial::from_text;
use crate::values::DropHeight;
use crate::values::typed::{LENGTHS, factor, not_negative};

/// Metres, or a multiple of the radius such as `x0.25`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(inline))]
pub struct Height(#[cfg_attr(feature = "schemas", schemars(schema_with = "number_or_text"))] DropHeight);

#[cfg(feature = "schemas")]
fn number_or_text(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({"anyOf": [
        {"type": "number", "minimum": 0, "description": "metres"},
        {"type": "string", "pattern": "^[xX][0-9.eE+-]+$"},
    ]})
}

impl Height {
    /// The height.
    #[must_use]
    pub const fn get(self) -> DropHeight {
        self.0
    }
}

impl Default for Height {
    /// A quarter of the radius, as in the paper's drop tests.
    fn default() -> Self {
        Self(DropHeight::Radii(0.25))
    }
}

impl FromStr for Height {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = "a length in metres, or a multiple of the radius like x0.25";
        let parse = |text: &str| not_negative(text, expected, LENGTHS);
        let height = match factor(text) {
            Some(number) => parse(number).map(DropHeight::Radii),
            None => parse(text).map(DropHeight::Metres),
        };
        height.map(Self)
    }
}

impl fmt::Display for Height {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            DropHeight::Metres(metres) => f.write_str(&shortest(metres)),
            DropHeight::Radii(radii) => write!(f, "x{}", shortest(radii)),
        }
    }
}

impl Serialize for Height {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            DropHeight::Metres(metres) => serializer.serialize_f64(metres),
            DropHeight::Radii(_) => serializer.collect_str(self),
        }
    }
}

impl<'d> Deserialize<'d> for Height {
    fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
        from_text(deserializer)
    }
}
