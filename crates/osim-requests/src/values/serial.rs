//! Values that are read from their text, in JSON too: as text, or as a number where the text is one.

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
/// What [`FromStr`] says of it.
pub fn from_text<'d, T, D>(deserializer: D) -> Result<T, D::Error>
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

/// The same of a value that may be absent.
///
/// # Errors
/// What [`FromStr`] says of it.
pub fn optional_from_text<'d, T, D>(deserializer: D) -> Result<Option<T>, D::Error>
where
    T: FromStr<Err: Display>,
    D: Deserializer<'d>,
{
    match Option::<Value>::deserialize(deserializer)? {
        None => Ok(None),
        Some(value) => from_text(value).map(Some).map_err(D::Error::custom),
    }
}

/// Reads a list of such values, or one alone in its place.
///
/// # Errors
/// Those of the values.
pub fn from_texts<'d, T, D>(deserializer: D) -> Result<Vec<T>, D::Error>
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
/// Those of the serialiser.
pub fn as_texts<T: Display, S: Serializer>(values: &[T], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(values.iter().map(ToString::to_string))
}
