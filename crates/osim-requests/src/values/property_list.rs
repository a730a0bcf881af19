//! Lists of properties, by OpenSim's names.

use osim_model::Property;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};
use serde_json::Value;

use crate::values::typed::trimmed;

/// One of them.
///
/// # Errors
/// There is no such property.
pub fn one(text: &str) -> Result<Property, String> {
    trimmed(text).parse()
}

/// Writes their names.
///
/// # Errors
/// Those of the serialiser.
pub fn serialize<S: Serializer>(properties: &[Property], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(properties.iter().map(|property| property.name()))
}

/// Reads a list of names, or one text with commas between them.
///
/// # Errors
/// A name that is not a property's.
pub fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Vec<Property>, D::Error> {
    let names = match Value::deserialize(deserializer)? {
        Value::String(text) => text.split(',').map(str::to_owned).collect(),
        list => Vec::<String>::deserialize(list).map_err(D::Error::custom)?,
    };
    names.iter().map(|name| one(name)).collect::<Result<_, _>>().map_err(D::Error::custom)
}
