//! Schemas of requests, from their types and the register.
//!
//! Besides the keywords of JSON Schema, the schemas have some of their own. `x-changes` is the position of the verb among the
//! verbs that change named models. `x-positional` lists the fields that a call has without their names. `x-group` is the subject
//! of a field that does not describe contacts. `x-of-run` marks a field for a whole run, which a row of a table cannot have.
//! Repeated parts of fields and conditions are in `$defs`.

use osim_model::messages::Verb;
use schemars::Schema;
use serde_json::{Map, Value, json};

use crate::fault::Relation;
use crate::register::{Entry, List, option_named};
use crate::request::{CHANGING, relations_of, type_schema, verb_entry};
use crate::values::path;

/// The schema of the requests for `verb`.
pub fn schema_of(verb: Verb) -> Schema {
    let mut schema = type_schema(verb);
    let object = schema.ensure_object();
    let mut names_files = false;
    let properties = object.entry("properties").or_insert_with(|| Map::new().into());
    if let Value::Object(properties) = properties {
        let fields = std::mem::take(properties);
        properties.insert("verb".to_owned(), json!({"const": verb.name()}));
        properties.extend(fields.into_iter().map(|(name, schema)| {
            let option = option_named(verb, &name);
            names_files |= option.is_some_and(|option| option.is_path());
            (name, option.map_or(schema.clone(), |option| with_register_texts(&option, schema)))
        }));
    }
    if !verb_entry(verb).positional.is_empty() {
        object.insert("x-positional".to_owned(), verb_entry(verb).positional.into());
    }
    if let Some(place) = CHANGING.iter().position(|changing| *changing == verb) {
        object.insert("x-changes".to_owned(), (place + 1).into());
    }
    object.insert("additionalProperties".to_owned(), false.into());
    let mut required = vec![Value::from("verb")];
    let mut all = Vec::new();
    let mut definitions = Map::new();
    if names_files {
        definitions.insert("Path".to_owned(), path::schema());
    }
    if let Some(Value::Object(of_types)) = object.remove("$defs") {
        definitions.extend(of_types);
    }
    let mut given = |field| is_given(field, &mut definitions);
    for relation in relations_of(verb) {
        match relation {
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

/// The schema of a field by its type, with the texts of the register.
fn with_register_texts(option: &Entry, of_type: Value) -> Value {
    let mut schema = json!({"description": null});
    let file = json!({"$ref": "#/$defs/Path"});
    // What says nothing may be null.
    let of_type = match (option.is_path(), option.list != List::One) {
        (false, _) => or_null(of_type),
        (true, false) => json!({"anyOf": [file, {"type": "null"}], "default": of_type["default"]}),
        (true, true) => or_null(json!({"type": "array", "items": file, "default": of_type["default"]})),
    };
    let groups = [
        option.group.map(|group| ("x-group", group.as_str().into())),
        option.is_of_run.then(|| ("x-of-run", true.into())),
    ];
    if let (Value::Object(schema), Value::Object(of_type)) = (&mut schema, of_type) {
        schema.extend(of_type);
        // Some types describe themselves, too.
        schema.insert("description".to_owned(), option.help.into());
        schema.extend(groups.into_iter().flatten().map(|(name, value): (_, Value)| (name.to_owned(), value)));
    }
    schema
}

/// The condition that `field` is given; it is defined once in the schema.
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
