//! Pairs of body names in two models, and scale factors of bodies, as texts.

use std::fmt;
use std::str::FromStr;

use osim_model::messages::shortest;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};
use serde_json::Value;
#[cfg(feature = "schemas")]
use serde_json::json;

use crate::values::serial::Texts;
use crate::values::typed_numbers::{positive_number, trimmed};

/// `BODY=BODY`: a body of the reference, and the body of the model that gets its spheres.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BodyMap {
    /// Name of the body of the reference.
    pub reference: String,
    /// Name of the body of the model.
    pub model: String,
}

impl FromStr for BodyMap {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let names = text.split_once('=').map(|(reference, model)| (trimmed(reference), trimmed(model)));
        match names {
            Some((reference, model)) if !reference.is_empty() && !model.is_empty() => {
                Ok(Self { reference: reference.to_owned(), model: model.to_owned() })
            }
            _ => Err("expected BODY=BODY, a body of the reference and one of the model, like toes_r=calcn_r"
                .to_owned()),
        }
    }
}

impl fmt::Display for BodyMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.reference, self.model)
    }
}

/// `BODY=x,y,z`: three factors above 0; `BODY=f` has the same factor along all axes.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyScale {
    /// Name of the body.
    pub body: String,
    /// The factors along x, y and z.
    pub factors: [f64; 3],
}

/// The expected form of scale factors, for messages.
const EXPECTED_SCALE: &str =
    "expected BODY=x,y,z with three factors above 0, or BODY=f with one, like calcn_r=1.1,1.05,1.1";
/// The largest plausible scale factor; the smallest is its inverse.
const LARGEST_SCALE_FACTOR: f64 = 1e9;

impl FromStr for BodyScale {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (body, factors) = text.split_once('=').ok_or(EXPECTED_SCALE)?;
        let factors: Vec<f64> = factors
            .split(',')
            .map(positive_number)
            .collect::<Result<_, _>>()
            .map_err(|_| EXPECTED_SCALE.to_owned())?;
        let factors = match *factors {
            [x, y, z] => [x, y, z],
            [factor] => [factor; 3],
            _ => return Err(EXPECTED_SCALE.to_owned()),
        };
        if !factors.iter().all(is_factor) {
            return Err(format!("{EXPECTED_SCALE}, each from 1e-9 to 1e9"));
        }
        Ok(Self { body: trimmed(body).to_owned(), factors })
    }
}

fn is_factor(factor: &f64) -> bool {
    (1.0 / LARGEST_SCALE_FACTOR..=LARGEST_SCALE_FACTOR).contains(factor)
}

impl fmt::Display for BodyScale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.body, self.factors.map(shortest).join(","))
    }
}

/// Reads scale factors: a map from bodies to three numbers or one, or texts such as `calcn_r=1.1,1.05,1.1`.
///
/// # Errors
/// A text or numbers that are not scale factors.
pub fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Vec<BodyScale>, D::Error> {
    match Value::deserialize(deserializer)? {
        Value::Object(bodies) => {
            let scale = |(body, factors): (String, Value)| {
                let expected = || {
                    D::Error::custom(format!(
                        "{body}: expected three factors above 0, or one, from 1e-9 to 1e9"
                    ))
                };
                let one = factors.as_f64().map(|factor| [factor; 3]);
                let factors: [f64; 3] = match one {
                    Some(factors) => factors,
                    None => serde_json::from_value(factors).map_err(|_| expected())?,
                };
                if factors.iter().all(is_factor) { Ok(BodyScale { body, factors }) } else { Err(expected()) }
            };
            bodies.into_iter().map(scale).collect()
        }
        texts => Texts::deserialize(texts).map_err(D::Error::custom),
    }
}

/// Writes scale factors as a map from bodies.
///
/// # Errors
/// The errors of the serialiser.
pub fn serialize<S: Serializer>(scales: &[BodyScale], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(scales.iter().map(|scale| (&scale.body, scale.factors)))
}

/// The schema of scale factors of bodies, in a file or one by one.
#[cfg(feature = "schemas")]
pub(crate) fn body_scale_schema(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let text = json!({"type": "string", "pattern": "="});
    let factor = json!({"type": "number", "minimum": 1e-9, "maximum": 1e9});
    schemars::json_schema!({"anyOf": [
        {
            "type": "object",
            "additionalProperties": {"anyOf": [
                {"type": "array", "items": factor, "minItems": 3, "maxItems": 3},
                factor,
            ]},
        },
        text,
        {"type": "array", "items": text},
    ]})
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_map_is_two_names_with_an_equals_sign() {
        let map: BodyMap = "toes_r = calcn_r".parse().unwrap();
        assert_eq!((map.reference.as_str(), map.model.as_str()), ("toes_r", "calcn_r"));
        assert_eq!(map.to_string().parse::<BodyMap>(), Ok(map));
        for text in ["toes_r", "=calcn_r", "toes_r="] {
            assert!(text.parse::<BodyMap>().is_err(), "{text}");
        }
    }
}
