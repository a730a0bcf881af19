//! Scale factors of a body, in words.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use osim_model::shortest;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};
use serde_json::Value;

use super::decimal::positive_number;
use super::serial::from_texts;

/// `BODY=x,y,z`: three factors above 0.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct BodyScale {
    /// Name of the body.
    pub body: String,
    /// Along x, y and z.
    pub factors: [f64; 3],
}

impl FromStr for BodyScale {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = "expected BODY=x,y,z with three factors above 0, like calcn_r=1.1,1.05,1.1";
        let (body, factors) = text.split_once('=').ok_or(expected)?;
        let factors: Vec<f64> = factors
            .split(',')
            .map(positive_number)
            .collect::<Result<_, _>>()
            .map_err(|_| expected.to_owned())?;
        let factors: [f64; 3] = factors.try_into().map_err(|_| expected.to_owned())?;
        Ok(Self { body: body.trim().to_owned(), factors })
    }
}

impl fmt::Display for BodyScale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.body, self.factors.map(shortest).join(","))
    }
}

/// Reads factors from a map of bodies to three numbers, or from texts such as `calcn_r=1.1,1.05,1.1`.
///
/// # Errors
/// A text or numbers that are no factors.
pub(crate) fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Vec<BodyScale>, D::Error> {
    match Value::deserialize(deserializer)? {
        Value::Object(bodies) => {
            let scale = |(body, factors): (String, Value)| {
                let factors: [f64; 3] = serde_json::from_value(factors).map_err(D::Error::custom)?;
                // The text's own rules hold for numbers too.
                BodyScale { body, factors }.to_string().parse().map_err(D::Error::custom)
            };
            bodies.into_iter().map(scale).collect()
        }
        texts => from_texts(texts).map_err(D::Error::custom),
    }
}

/// Writes factors as a map of bodies.
///
/// # Errors
/// Those of the serialiser.
pub(crate) fn serialize<S: Serializer>(scales: &[BodyScale], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(scales.iter().map(|scale| (&scale.body, scale.factors)))
}

/// The type of both, for the schema.
pub(crate) type BodyScaleMap = BTreeMap<String, [f64; 3]>;
