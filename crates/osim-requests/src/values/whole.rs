//! Whole numbers with bounds.

#[cfg(feature = "schemas")]
use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize};

use super::serial::from_text;
use crate::values::typed::trimmed;

macro_rules! whole_numbers {
    ($($(#[doc = $doc:literal])+ $name:ident($type:ty) = $least:literal to $most:literal, $default:literal;)+) => {$(
        $(#[doc = $doc])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
        #[serde(transparent)]
        pub struct $name($type);

        impl $name {
            /// The number.
            #[must_use]
            pub const fn get(self) -> $type {
                self.0
            }
        }

        impl Default for $name {
            fn default() -> Self {
                Self($default)
            }
        }

        impl FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                match trimmed(text).parse::<$type>() {
                    Ok(number) if ($least..=$most).contains(&number) => Ok(Self(number)),
                    _ => Err(format!("expected a whole number from {} to {}", $least, $most)),
                }
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        impl<'d> Deserialize<'d> for $name {
            fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
                from_text(deserializer)
            }
        }

        #[cfg(feature = "schemas")]
        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
                json_schema!({"type": "integer", "minimum": $least, "maximum": $most})
            }

            fn inline_schema() -> bool {
                true
            }
        }
    )+};
}

whole_numbers! {
    /// Points of a series.
    Samples(u32) = 2 to 1_000_000, 1001;
    /// Spheres under one foot.
    SpheresOfFoot(u8) = 1 to 60, 4;
    /// Pixels to the inch.
    Dpi(u16) = 50 to 2400, 600;
}
