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
    /// Steps of a ladder.
    Steps(u32) = 2 to 100_000, 5;
    /// Models to work on at once.
    Jobs(u16) = 1 to 4096, 1;
    /// Pixels to the inch.
    Dpi(u16) = 50 to 2400, 600;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each type with its bounds: the largest is taken, and one more is refused with both.
    #[test]
    fn every_count_has_a_largest() {
        macro_rules! bounds {
            ($($name:ident $least:literal $most:literal;)+) => {$(
                let expected = format!("expected a whole number from {} to {}", $least, $most);
                for taken in [$least, $most] {
                    assert_eq!(taken.to_string().parse::<$name>().map(|count| count.to_string()), Ok(taken.to_string()));
                }
                for refused in [$least - 1, $most + 1] {
                    assert_eq!(refused.to_string().parse::<$name>(), Err(expected.clone()));
                }
                for refused in ["1e9", "1000000000", "99999999999999999999", "-1", "2.5", ""] {
                    assert_eq!(refused.parse::<$name>(), Err(expected.clone()), "{refused}");
                }
            )+};
        }
        bounds! {
            Samples 2 1_000_000;
            SpheresOfFoot 1 60;
            Steps 2 100_000;
            Jobs 1 4096;
            Dpi 50 2400;
        }
        assert_eq!("100000".parse::<Steps>().map(Steps::get), Ok(contact_scaling::continuation::MOST_STEPS));
    }
}
