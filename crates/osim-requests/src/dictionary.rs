//! Requests from dictionaries: every field by its name, and what is wrong with the first that is.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::fault::RequestFault;
use crate::relation::Relation;

/// A name that is this like another was probably meant.
const NEAR: usize = 2;

/// Reads a request from its fields. A field that is null counts as absent.
///
/// # Errors
/// A field that does not exist, a value that cannot be taken, or fields that do not go together.
pub(crate) fn read<T>(fields: Map<String, Value>, relations: &[&[Relation]]) -> Result<T, RequestFault>
where
    T: Default + Serialize + DeserializeOwned,
{
    let known = map(&T::default());
    if let Some(field) = fields.keys().find(|field| !known.contains_key(*field)) {
        let nearest = nearest(field, &known);
        return Err(RequestFault::UnknownField { field: field.clone(), nearest });
    }
    let fields: Map<String, Value> = fields.into_iter().filter(|(_, value)| !value.is_null()).collect();
    check_fields(&fields, relations)?;
    match serde_json::from_value(Value::Object(fields.clone())) {
        Ok(request) => Ok(request),
        Err(error) => Err(bad_value::<T>(&fields, &error)),
    }
}

/// Checks that the fields of a request go together.
///
/// # Errors
/// The first that do not.
pub(crate) fn check<T: Default + Serialize>(
    request: &T,
    relations: &[&[Relation]],
) -> Result<(), RequestFault> {
    check_fields(&said(request), relations)
}

/// The fields of a request that differ from their defaults.
pub(crate) fn said<T: Default + Serialize>(request: &T) -> Map<String, Value> {
    let silent = map(&T::default());
    map(request).into_iter().filter(|(name, value)| silent.get(name) != Some(value)).collect()
}

/// Every field of a request.
pub(crate) fn map(request: &impl Serialize) -> Map<String, Value> {
    match serde_json::to_value(request) {
        Ok(Value::Object(fields)) => fields,
        // Requests are structs: nothing else can result.
        _ => Map::new(),
    }
}

fn check_fields(fields: &Map<String, Value>, relations: &[&[Relation]]) -> Result<(), RequestFault> {
    let says = |name: &str| match fields.get(name) {
        None | Some(Value::Null | Value::Bool(false)) => false,
        Some(Value::Array(items)) => !items.is_empty(),
        Some(Value::Object(items)) => !items.is_empty(),
        Some(_) => true,
    };
    check_relations(says, relations.iter().copied().flatten().copied())
}

/// Checks that the fields for which `says` is true go together.
///
/// # Errors
/// The first that do not.
pub(crate) fn check_relations(
    says: impl Fn(&str) -> bool,
    relations: impl Iterator<Item = Relation>,
) -> Result<(), RequestFault> {
    for relation in relations {
        match relation {
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

/// The first field whose value cannot be taken: each is tried alone.
fn bad_value<T: DeserializeOwned>(fields: &Map<String, Value>, error: &serde_json::Error) -> RequestFault {
    for (name, value) in fields {
        let alone = Map::from_iter([(name.clone(), value.clone())]);
        if let Err(error) = serde_json::from_value::<T>(Value::Object(alone)) {
            let (value, reason) = bad_item::<T>(name, value).unwrap_or_else(|| (value, error.to_string()));
            return RequestFault::BadValue { field: name.clone(), value: as_given(value), reason };
        }
    }
    RequestFault::general(error.to_string())
}

/// A value for a message. Objects are assignments, so that no front end shows the braces of JSON.
fn as_given(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Object(entries) if !entries.is_empty() => {
            let assigned = |(name, value): (&String, &Value)| format!("{name}={}", as_given(value));
            entries.iter().map(assigned).collect::<Vec<_>>().join(" ")
        }
        other => other.to_string(),
    }
}

/// The first item of a list that cannot be taken, and why.
fn bad_item<'v, T: DeserializeOwned>(name: &str, value: &'v Value) -> Option<(&'v Value, String)> {
    let read = |list| serde_json::from_value::<T>(Value::Object(Map::from_iter([(name.to_owned(), list)])));
    // Where no list can be taken, the list is what is wrong.
    read(Value::Array(Vec::new())).ok()?;
    let wrong = |item: &Value| Some(read(Value::Array(vec![item.clone()])).err()?.to_string());
    value.as_array()?.iter().find_map(|item| Some((item, wrong(item)?)))
}

/// The field that was probably meant.
fn nearest(field: &str, known: &Map<String, Value>) -> Option<String> {
    let likely = |name: &&String| {
        name.starts_with(field)
            || field.starts_with(name.as_str())
            || strsim::osa_distance(name, field) <= NEAR
    };
    known.keys().filter(likely).min_by_key(|name| strsim::osa_distance(name, field)).cloned()
}
