//! Requests from dictionaries: reads every field by its name, refuses a name that occurs twice, and reports the first wrong
//! field.

use std::fmt;

use osim_model::nearest_names;
use serde::Serialize;
use serde::de::{DeserializeOwned, DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Number, Value};

use crate::fault::{Relation, RequestFault};

/// Reads a request from its fields. A null field counts as absent. Only the `relations` that satisfy `checked` are checked.
///
/// # Errors
/// An unknown field, a value of the wrong form, or fields that contradict or need each other.
pub(crate) fn read<T>(
    fields: Map<String, Value>,
    relations: &[Relation],
    checked: fn(&Relation) -> bool,
) -> Result<T, RequestFault>
where
    T: Default + Serialize + DeserializeOwned,
{
    let known = all_fields(&T::default());
    if let Some(field) = fields.keys().find(|field| !known.contains_key(*field)) {
        let nearest = nearest_field(field, &known);
        return Err(RequestFault::UnknownField { field: field.clone(), nearest });
    }
    let fields: Map<String, Value> = fields.into_iter().filter(|(_, value)| !value.is_null()).collect();
    check_fields(&fields, relations, checked)?;
    serde_json::from_value(Value::Object(fields.clone()))
        .map_err(|error| fault_of_bad_value::<T>(&fields, &error))
}

/// Checks the relations between the fields of a request that was made as a struct: fields that differ from their defaults count as given.
/// ([`read`] checks dictionaries.)
///
/// # Errors
/// The first violated relation.
pub(crate) fn check<T: Default + Serialize>(request: &T, relations: &[Relation]) -> Result<(), RequestFault> {
    check_fields(&given_fields(request), relations, |_| true)
}

/// The fields of a request that differ from their defaults.
pub(crate) fn given_fields<T: Default + Serialize>(request: &T) -> Map<String, Value> {
    let silent = all_fields(&T::default());
    all_fields(request).into_iter().filter(|(name, value)| silent.get(name) != Some(value)).collect()
}

/// The request as a dictionary with all its fields.
pub(crate) fn all_fields(request: &impl Serialize) -> Map<String, Value> {
    match serde_json::to_value(request) {
        Ok(Value::Object(fields)) => fields,
        // Requests are structs: nothing else can result.
        _ => Map::new(),
    }
}

fn check_fields(
    fields: &Map<String, Value>,
    relations: &[Relation],
    checked: fn(&Relation) -> bool,
) -> Result<(), RequestFault> {
    let says = |name: &str| match fields.get(name) {
        None | Some(Value::Null | Value::Bool(false)) => false,
        Some(Value::Array(items)) => !items.is_empty(),
        Some(Value::Object(items)) => !items.is_empty(),
        Some(_) => true,
    };
    for relation in relations.iter().filter(|relation| checked(relation)) {
        match *relation {
            Relation::Required(field) | Relation::Expected(field) if !says(field) => {
                return Err(RequestFault::Missing { field });
            }
            Relation::RequiredUnless(field, other) | Relation::ExpectedUnless(field, other)
                if !says(field) && !says(other) =>
            {
                return Err(RequestFault::Missing { field });
            }
            Relation::Needs(field, other) if says(field) && !says(other) => {
                return Err(RequestFault::Needs { field, other });
            }
            Relation::Excludes(field, other) if says(field) && says(other) => {
                return Err(RequestFault::Excludes { field, other });
            }
            _ => {}
        }
    }
    Ok(())
}

/// Checks one field of a request.
///
/// # Errors
/// The value has the wrong form; the message gives the expected form.
pub(crate) fn check_value<T: DeserializeOwned>(name: &str, value: Value) -> Result<(), String> {
    let alone = Map::from_iter([(name.to_owned(), value)]);
    serde_json::from_value::<T>(Value::Object(alone)).map(drop).map_err(|error| error.to_string())
}

/// The fault for the first field whose value has the wrong form: each field is read alone.
fn fault_of_bad_value<T: DeserializeOwned>(
    fields: &Map<String, Value>,
    error: &serde_json::Error,
) -> RequestFault {
    for (name, value) in fields {
        if let Err(why) = check_value::<T>(name, value.clone()) {
            let (value, reason) = first_bad_item::<T>(name, value).unwrap_or((value, why));
            return RequestFault::BadValue { field: name.clone(), value: value_for_message(value), reason };
        }
    }
    RequestFault::general(error.to_string())
}

/// A value as text for a message. An object is shown as assignments, without the braces of JSON.
fn value_for_message(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Object(entries) if !entries.is_empty() => {
            let assigned = |(name, value): (&String, &Value)| format!("{name}={}", value_for_message(value));
            entries.iter().map(assigned).collect::<Vec<_>>().join(" ")
        }
        other => other.to_string(),
    }
}

/// The first item of a list that has the wrong form, and the error message for it.
fn first_bad_item<'v, T: DeserializeOwned>(name: &str, value: &'v Value) -> Option<(&'v Value, String)> {
    // Where no list can be taken, the list is what is wrong.
    check_value::<T>(name, Value::Array(Vec::new())).ok()?;
    let wrong = |item: &Value| check_value::<T>(name, Value::Array(vec![item.clone()])).err();
    value.as_array()?.iter().find_map(|item| Some((item, wrong(item)?)))
}

/// The known field with the name nearest to `field`.
fn nearest_field(field: &str, known: &Map<String, Value>) -> Option<String> {
    let names = || known.keys().map(String::as_str);
    let is_part = |name: &&str| name.starts_with(field) || field.starts_with(name);
    let part = || names().filter(is_part).min_by_key(|name| name.len().abs_diff(field.len()));
    nearest_names(field, names(), 2).first().copied().or_else(part).map(str::to_owned)
}

// JSON in which no name appears twice: of two values, nobody can know which one was meant.

/// Reads a JSON text.
///
/// # Errors
/// The text is not JSON, or an object in it has the same name twice.
pub(crate) fn from_slice(text: &[u8]) -> Result<Value, serde_json::Error> {
    let mut reader = serde_json::Deserializer::from_slice(text);
    let value = ValueWithUniqueFields.deserialize(&mut reader)?;
    reader.end()?;
    Ok(value)
}

/// Reads a JSON value in which no object has a field twice.
struct ValueWithUniqueFields;

impl<'d> DeserializeSeed<'d> for ValueWithUniqueFields {
    type Value = Value;

    fn deserialize<D: Deserializer<'d>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'d> Visitor<'d> for ValueWithUniqueFields {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_unit<E: Error>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
        Ok(Value::Bool(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        Number::from_f64(value).map(Value::Number).ok_or_else(|| E::custom("a number that is not finite"))
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
        Ok(value.into())
    }

    fn visit_seq<A: SeqAccess<'d>>(self, mut items: A) -> Result<Value, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element_seed(Self)? {
            list.push(item);
        }
        Ok(Value::Array(list))
    }

    fn visit_map<A: MapAccess<'d>>(self, mut fields: A) -> Result<Value, A::Error> {
        let mut map = Map::new();
        while let Some(name) = fields.next_key::<String>()? {
            let value = fields.next_value_seed(Self)?;
            if map.contains_key(&name) {
                return Err(A::Error::custom(format!("'{name}' appears twice")));
            }
            map.insert(name, value);
        }
        Ok(Value::Object(map))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unique_fields_are_read_as_by_serde_json() {
        let text = br#"{"a": [1, -2, 2.5, 1e300, null, true, "\u00e4", {}], "b": {"a": []}}"#;
        assert_eq!(from_slice(text).unwrap(), serde_json::from_slice::<Value>(text).unwrap());
    }

    #[test]
    fn a_name_that_occurs_twice_is_refused_at_any_depth() {
        for text in [r#"{"a": 1, "a": 1}"#, r#"[{"b": {"a": 1, "c": 2, "a": null}}]"#] {
            let error = from_slice(text.as_bytes()).unwrap_err().to_string();
            assert!(error.contains("'a' appears twice at line 1"), "{error}");
        }
        for text in ["", "{", "1 2", "nul"] {
            assert!(from_slice(text.as_bytes()).is_err(), "{text}");
        }
    }
}
