//! Values that are read from their texts, also in JSON, and choices of one word among several.

use std::fmt::Display;
use std::marker::PhantomData;
use std::str::FromStr;

use osim_model::messages::shortest;
use serde::de::{Error, MapAccess, SeqAccess, Visitor};
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
    struct Text<T>(PhantomData<T>);

    impl<'s, T: FromStr<Err: Display>> Visitor<'s> for Text<T> {
        type Value = T;

        fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            f.write_str("a number or a text")
        }

        fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
            text.parse().map_err(E::custom)
        }

        fn visit_seq<A: SeqAccess<'s>>(self, _: A) -> Result<T, A::Error> {
            Err(A::Error::custom("a list, expected one number or one text"))
        }

        fn visit_map<A: MapAccess<'s>>(self, _: A) -> Result<T, A::Error> {
            Err(A::Error::custom("names with values, expected one number or one text"))
        }

        fn visit_bool<E: Error>(self, _: bool) -> Result<T, E> {
            Err(E::custom("expected a number or a text"))
        }

        fn visit_f64<E: Error>(self, value: f64) -> Result<T, E> {
            self.visit_str(&shortest(value))
        }

        fn visit_u64<E: Error>(self, value: u64) -> Result<T, E> {
            self.visit_str(&value.to_string())
        }

        fn visit_i64<E: Error>(self, value: i64) -> Result<T, E> {
            self.visit_str(&value.to_string())
        }
    }

    deserializer.deserialize_any(Text(PhantomData))
}

/// Reads a value that may be absent.
///
/// # Errors
/// The error of [`FromStr`].
pub(crate) fn optional_from_text<'d, T, D>(deserializer: D) -> Result<Option<T>, D::Error>
where
    T: FromStr<Err: Display>,
    D: Deserializer<'d>,
{
    match Option::<Value>::deserialize(deserializer)? {
        None => Ok(None),
        Some(value) => from_text(value).map(Some).map_err(D::Error::custom),
    }
}

/// Reads a list of values from their texts, or a single value.
///
/// # Errors
/// The error of [`FromStr`] for one of the values.
pub(crate) fn from_texts<'d, T, D>(deserializer: D) -> Result<Vec<T>, D::Error>
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

/// Writes a list of values as their texts.
///
/// # Errors
/// The errors of the serialiser.
pub(crate) fn as_texts<T: Display, S: Serializer>(values: &[T], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(values.iter().map(ToString::to_string))
}

/// The words of a choice, each with its meaning; the meaning is empty if the word is clear.
pub type Words = &'static [(&'static str, &'static str)];

/// Declares an enum whose variants are words: for a command line, for JSON and in messages. After the name of the enum comes the
/// default word, if there is one.
macro_rules! choices {
    ($(#[doc = $doc:literal])+ $name:ident $(: $default:ident)? { $($variant:ident = $word:literal $(, $help:literal)?;)+ }) => {
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

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.as_str())
            }
        }

        impl<'d> serde::Deserialize<'d> for $name {
            fn deserialize<D: serde::Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
                crate::values::serial::from_text(deserializer)
            }
        }

        #[cfg(feature = "schemas")]
        impl schemars::JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!({"type": "string", "enum": [$($word),+]})
            }

            fn inline_schema() -> bool {
                true
            }
        }
    };
}
pub(crate) use choices;
