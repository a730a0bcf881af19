//! Where contact begins in a measurement, in words.

use std::fmt;
use std::str::FromStr;

use contact_scaling::fit::Onset;
use osim_model::messages::shortest;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::serial::from_text;
use crate::values::typed::trimmed;

/// An indentation in m at which contact begins, or `fit` to find it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(inline))]
pub struct ContactOnset(#[cfg_attr(feature = "schemas", schemars(schema_with = "number_or_word"))] Onset);

#[cfg(feature = "schemas")]
fn number_or_word(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({"anyOf": [{"type": "number", "description": "metres"}, {"const": "fit"}]})
}

impl ContactOnset {
    /// The onset.
    #[must_use]
    pub const fn get(self) -> Onset {
        self.0
    }
}

impl Default for ContactOnset {
    fn default() -> Self {
        Self(Onset::At(0.0))
    }
}

impl FromStr for ContactOnset {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "fit" {
            return Ok(Self(Onset::Fitted));
        }
        match trimmed(text).parse::<f64>() {
            Ok(metres) if metres.is_finite() => Ok(Self(Onset::At(metres))),
            _ => Err("expected an indentation in metres, or fit to find it".to_owned()),
        }
    }
}

impl fmt::Display for ContactOnset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Onset::At(metres) => f.write_str(&shortest(metres)),
            Onset::Fitted => f.write_str("fit"),
        }
    }
}

impl Serialize for ContactOnset {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Onset::At(metres) => serializer.serialize_f64(metres),
            Onset::Fitted => serializer.serialize_str("fit"),
        }
    }
}

impl<'d> Deserialize<'d> for ContactOnset {
    fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
        from_text(deserializer)
    }
}
