//! Values that are read from their texts, also in JSON, and choices of one word among several.

use std::fmt::Display;
use std::str::FromStr;

use osim_model::messages::shortest;
use serde::de::{Error, Unexpected};
use serde::{Deserialize, Deserializer, Serializer};
use serde_json::Value;

/// Reads a value from the text or number that JSON has for it.
///
/// # Errors
/// The error of [`FromStr`].
pub(crate) fn from_text<'d, T, D>(deserializer: D) -> Result<T, D::Error>
where
    T: FromStr<Err: Display>,
    D: Deserializer<'d>,
{
    let text = match Value::deserialize(deserializer)? {
        Value::String(text) => text,
        Value::Number(number) if number.is_f64() => number.as_f64().map(shortest).unwrap_or_default(),
        Value::Number(number) => number.to_string(),
        Value::Array(_) => return Err(D::Error::custom("a list, expected one number or one text")),
        Value::Object(_) => {
            return Err(D::Error::custom("names with values, expected one number or one text"));
        }
        Value::Bool(_) => return Err(D::Error::custom("expected a number or a text")),
        Value::Null => return Err(D::Error::invalid_type(Unexpected::Unit, &"a number or a text")),
    };
    text.parse().map_err(D::Error::custom)
}

/// How fields write and read lists of values: as their texts. A single value is read as a list of one.
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline, with = "Vec<String>"))]
pub(crate) struct Texts;

impl Texts {
    pub(crate) fn serialize<T: Display, S: Serializer>(all: &[T], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(all.iter().map(ToString::to_string))
    }

    /// Reads a list of values from their texts, or a single value.
    ///
    /// # Errors
    /// The error of [`FromStr`] for one of the values.
    pub(crate) fn deserialize<'d, T, D>(deserializer: D) -> Result<Vec<T>, D::Error>
    where
        T: FromStr<Err: Display>,
        D: Deserializer<'d>,
    {
        match Value::deserialize(deserializer)? {
            Value::Array(values) => {
                values.into_iter().map(|value| from_text(value).map_err(D::Error::custom)).collect()
            }
            value => Ok(vec![from_text(value).map_err(D::Error::custom)?]),
        }
    }
}

/// The values that a choice can have, as they are typed, each with its meaning; the meaning is empty if the value is clear.
pub type Words = &'static [(&'static str, &'static str)];

/// Lets types be read from JSON by [`FromStr`], as a text or a number, and gives them these schemas.
macro_rules! values_from_text {
    ($($name:ident = $schema:tt;)+) => {$(
        impl<'d> serde::Deserialize<'d> for $name {
            fn deserialize<D: serde::Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
                $crate::values::serial::from_text(deserializer)
            }
        }

        #[cfg(feature = "schemas")]
        impl schemars::JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!($schema)
            }

            fn inline_schema() -> bool {
                true
            }
        }
    )+};
}
pub(crate) use values_from_text;

/// Lets types, as [`values_from_text`] does, be read from JSON, and written by [`Display`]: as a number where the text is one.
macro_rules! values_as_text {
    ($($name:ident = $schema:tt;)+) => {
        $crate::values::serial::values_from_text! { $($name = $schema;)+ }

        $(impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let text = self.to_string();
                match text.parse() {
                    Ok(number) => serializer.serialize_f64(number),
                    Err(_) => serializer.serialize_str(&text),
                }
            }
        })+
    };
}
pub(crate) use values_as_text;

/// Declares enums whose variants are words: for a command line, for JSON and in messages. After the name of an enum comes its
/// default word, if there is one.
macro_rules! choices {
    ($($(#[doc = $doc:literal])+ $name:ident $(: $default:ident)? { $($variant:ident = $word:literal $(, $help:literal)?;)+ })+) => {$(
        $(#[doc = $doc])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $name {
            $($variant,)+
        }

        impl $name {
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Every word with its meaning, if it has a text.
            pub(crate) const WORDS: $crate::values::serial::Words = &[$(($word, concat!($($help)?))),+];

            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $word),+ }
            }
        }

        $(impl Default for $name {
            fn default() -> Self {
                Self::$default
            }
        })?

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.as_str())
            }
        }

        impl std::str::FromStr for $name {
            type Err = String;

            fn from_str(text: &str) -> Result<Self, String> {
                let found = Self::ALL.iter().find(|known| known.as_str() == text);
                found.copied().ok_or_else(|| {
                    let words: Vec<&str> = Self::ALL.iter().map(|known| known.as_str()).collect();
                    format!("expected one of {}", words.join(", "))
                })
            }
        }

        $crate::values::serial::values_as_text! { $name = {"type": "string", "enum": [$($word),+]}; }
    )+};
}
pub(crate) use choices;

/// Gives enums that [`choices`] declared a method that says what each of their words means to the program.
macro_rules! meanings {
    ($($(#[doc = $doc:literal])+ $name:ident.$method:ident: $type:ty { $($variant:ident => $value:expr),+ $(,)? })+) => {$(
        impl $name {
            $(#[doc = $doc])+
            pub const fn $method(self) -> $type {
                match self { $(Self::$variant => $value),+ }
            }
        }
    )+};
}
pub(crate) use meanings;

/// Declares structs whose fields are the options of a request, under the names that JSON has for them. `field: ..Group` has
/// the options of another such struct. After `as` comes the type that reads and writes the field, after `=` its value in a request
/// that does not name it, and after `where` the relations between options.
macro_rules! fields {
    ($($(#[$about:meta])* struct $name:ident {
        $($(#[$of_field:meta])* $field:ident: $(..$group:ident)? $($type:ty $(as $with:tt)? $(= $default:expr)?)?),+ $(,)?
    } $(where $($relation:ident($($option:literal),+)),+;)?)+) => {$(
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
        #[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
        #[serde(default)]
        pub struct $name {
            $(
                $(#[$of_field])*
                $(#[serde(flatten)] pub $field: $group,)?
                $($(#[serde(with = $with)])? pub $field: $type,)?
            )+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $crate::values::serial::fields!(@value $($($default)?)?)),+ }
            }
        }

        impl $name {
            /// The relations between the options: its own, then those of its groups.
            pub(crate) fn relations() -> Vec<$crate::fault::Relation> {
                let own: Vec<$crate::fault::Relation> = vec![$($($crate::fault::Relation::$relation($($option),+)),+)?];
                [own, $($($group::relations(),)?)+].concat()
            }
        }
    )+};
    (@value) => { Default::default() };
    (@value $value:expr) => { $value };
}
pub(crate) use fields;
