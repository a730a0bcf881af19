//! Assignments to properties, such as `stiffness=x2 dissipation=1`, and lists of properties, by OpenSim's names.

use osim_model::messages::shortest;
use osim_model::{Assignment, Property};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

use crate::values::typed_numbers::{LENGTH_UNITS, factor, number, number_in, trimmed};

/// Assignments to properties, in the given order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Assignments(Vec<(Property, Assignment)>);

#[cfg(feature = "schemas")]
impl schemars::JsonSchema for Assignments {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Assignments".into()
    }

    /// Properties with a value or a factor each, or the text that [`Assignments::read`] takes.
    fn json_schema(_generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"anyOf": [
            {
                "type": "object",
                "additionalProperties": {"anyOf": [
                    {"type": "number", "minimum": 0},
                    {"type": "string", "pattern": "^[xX]?[0-9.eE+-]+$"},
                ]},
            },
            {"type": "string", "pattern": "="},
        ]})
    }

    fn inline_schema() -> bool {
        true
    }
}

/// Reads an assignment, `PROPERTY=VALUE` or `PROPERTY=xFACTOR`, from the texts of its two sides.
///
/// # Errors
/// An unknown property, or a value that is not a number.
pub fn assignment(name: &str, text: &str) -> Result<(Property, Assignment), String> {
    let property: Property = trimmed(name).parse()?;
    let text = trimmed(text);
    let value = match factor(text) {
        Some(factor) => number(factor).map(Assignment::Factor),
        None if property == Property::Radius => {
            number_in(text, "a radius in m", LENGTH_UNITS).map(Assignment::Value)
        }
        None => number(text).map(Assignment::Value),
    };
    value.map(|value| (property, value)).map_err(|why| format!("{name}={text}: {why}"))
}

impl Assignments {
    /// Adds an assignment.
    ///
    /// # Errors
    /// The property has an assignment already.
    pub fn add(&mut self, (property, value): (Property, Assignment)) -> Result<(), String> {
        if self.0.iter().any(|(known, _)| *known == property) {
            return Err(format!("{property} is set twice"));
        }
        self.0.push((property, value));
        Ok(())
    }

    pub fn as_slice(&self) -> &[(Property, Assignment)] {
        &self.0
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Reads assignments such as `stiffness=x2 dissipation=1`, with blanks or semicolons between them.
    ///
    /// # Errors
    /// A text that is not an assignment, or a property that appears twice.
    pub fn read(text: &str) -> Result<Self, String> {
        let mut all = Self::default();
        for item in text.split([' ', ';']).filter(|item| !item.is_empty()) {
            let (name, value) = item
                .split_once('=')
                .ok_or_else(|| format!("'{item}', expected PROPERTY=VALUE or PROPERTY=xFACTOR"))?;
            all.add(assignment(name, value)?)?;
        }
        Ok(all)
    }
}

impl FromIterator<(Property, Assignment)> for Assignments {
    fn from_iter<I: IntoIterator<Item = (Property, Assignment)>>(all: I) -> Self {
        Self(all.into_iter().collect())
    }
}

impl Serialize for Assignments {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(property, value)| match value {
            Assignment::Factor(factor) => (property.as_str(), Value::from(format!("x{}", shortest(*factor)))),
            Assignment::Value(value) => (property.as_str(), Value::from(*value)),
        }))
    }
}

impl<'d> Deserialize<'d> for Assignments {
    /// Reads a map, or the text that [`Assignments::read`] takes.
    fn deserialize<D: Deserializer<'d>>(deserializer: D) -> Result<Self, D::Error> {
        let mut all = Self::default();
        match Value::deserialize(deserializer)? {
            Value::Object(properties) => {
                for (name, value) in properties {
                    let text = match &value {
                        Value::Number(number) => number.as_f64().map(shortest).unwrap_or_default(),
                        Value::String(text) => text.clone(),
                        other => other.to_string(),
                    };
                    all.add(assignment(&name, &text).map_err(D::Error::custom)?).map_err(D::Error::custom)?;
                }
                Ok(all)
            }
            Value::String(text) => Self::read(&text).map_err(D::Error::custom),
            other => Err(D::Error::custom(format!(
                "expected properties with their values, such as {{\"stiffness\": \"x2\"}}, found {other}"
            ))),
        }
    }
}

/// Writes the names of properties.
///
/// # Errors
/// The errors of the serialiser.
pub fn serialize<S: Serializer>(properties: &[Property], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(properties.iter().map(|property| property.as_str()))
}

/// Reads a list of property names, or one text with commas between the names.
///
/// # Errors
/// A name that is not the name of a property.
pub fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Vec<Property>, D::Error> {
    let names = match Value::deserialize(deserializer)? {
        Value::String(text) => text.split(',').map(str::to_owned).collect(),
        list => Vec::<String>::deserialize(list).map_err(D::Error::custom)?,
    };
    names
        .iter()
        .map(|name| trimmed(name).parse::<Property>())
        .collect::<Result<_, _>>()
        .map_err(D::Error::custom)
}
