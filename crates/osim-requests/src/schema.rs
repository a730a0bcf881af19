//! Schemas of requests, from their types.
//!
//! Beside the words of JSON Schema they have two of their own, for what is made from them: `x-positional`, the fields that a call
//! has without their names, and `x-group`, what a field is about that says nothing about contacts. What fields and conditions repeat
//! is in `$defs`.

use osim_model::messages::Verb;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
#[cfg(feature = "schemas")]
use schemars::Schema;
#[cfg(feature = "schemas")]
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

use crate::fault::Relation;
use crate::fields::{FieldGroup, positional};

/// The schema of the requests `T` for `verb`.
pub(crate) fn schema<T: JsonSchema>(verb: Verb, relations: &[&[Relation]]) -> Schema {
    let mut schema = SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<T>();
    let object = schema.ensure_object();
    let properties = object.entry("properties").or_insert_with(|| Map::new().into());
    if let Value::Object(properties) = properties {
        let named = std::mem::take(properties);
        properties.insert("verb".to_owned(), json!({"const": verb.name()}));
        // What says nothing may be null.
        properties.extend(named.into_iter().map(|(name, schema)| {
            let schema = in_group(&name, or_null(schema));
            (name, schema)
        }));
    }
    if !positional(verb).is_empty() {
        object.insert("x-positional".to_owned(), positional(verb).into());
    }
    object.insert("additionalProperties".to_owned(), false.into());
    let mut required = vec![Value::from("verb")];
    let mut all = Vec::new();
    let mut definitions = match object.remove("$defs") {
        Some(Value::Object(of_types)) => of_types,
        _ => Map::new(),
    };
    let mut given = |field| is_given(field, &mut definitions);
    for relation in relations.iter().copied().flatten() {
        match *relation {
            Relation::Required(field) | Relation::Expected(field) => {
                required.push(field.into());
                all.push(given(field));
            }
            Relation::RequiredUnless(field, other) | Relation::ExpectedUnless(field, other) => {
                all.push(json!({"anyOf": [given(field), given(other)]}));
            }
            Relation::Needs(field, other) => {
                all.push(json!({"anyOf": [{"not": given(field)}, given(other)]}));
            }
            Relation::Excludes(field, other) => {
                all.push(json!({"not": {"allOf": [given(field), given(other)]}}));
            }
        }
    }
    object.insert("required".to_owned(), required.into());
    if !all.is_empty() {
        object.insert("allOf".to_owned(), all.into());
    }
    if !definitions.is_empty() {
        object.insert("$defs".to_owned(), definitions.into());
    }
    schema
}

/// The schema of the field `name` with its group, where it has one.
fn in_group(name: &str, mut schema: Value) -> Value {
    if let (Some(group), Some(object)) = (FieldGroup::of(name), schema.as_object_mut()) {
        object.insert("x-group".to_owned(), group.name().into());
    }
    schema
}

/// That a field is given. The condition is defined once.
fn is_given(field: &str, definitions: &mut Map<String, Value>) -> Value {
    let any = || {
        json!({
            "description": "Neither null, nor false, nor empty.",
            "not": {"anyOf": [
                {"enum": [null, false]},
                {"type": "array", "maxItems": 0},
                {"type": "object", "maxProperties": 0},
            ]},
        })
    };
    let condition = || json!({"required": [field], "properties": {field: {"$ref": "#/$defs/given"}}});
    definitions.entry("given").or_insert_with(any);
    definitions.entry(format!("{field}_given")).or_insert_with(condition);
    json!({"$ref": format!("#/$defs/{field}_given")})
}

fn or_null(mut schema: Value) -> Value {
    // One value may stand alone in the place of a list.
    if schema.get("type") == Some(&json!("array")) {
        let list = json!({"type": "array", "items": schema["items"]});
        let alternatives = json!([schema["items"].take(), list, {"type": "null"}]);
        if let Some(object) = schema.as_object_mut() {
            object.remove("items");
            object.remove("type");
            object.insert("anyOf".to_owned(), alternatives);
        }
    } else if let Some(Value::String(kind)) = schema.get("type").cloned().as_ref() {
        schema["type"] = json!([kind, "null"]);
        if let Some(Value::Array(words)) = schema.get_mut("enum") {
            words.push(Value::Null);
        }
    } else if let Some(Value::Array(choices)) = schema.get_mut("anyOf")
        && !choices.contains(&json!({"type": "null"}))
    {
        choices.push(json!({"type": "null"}));
    }
    schema
}
