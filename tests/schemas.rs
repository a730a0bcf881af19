//! `schemas/` must equal the schemas of the types in the code. To write them again: `UPDATE_SCHEMAS=1 cargo test --test schemas`.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_inspect::{CheckResult, FindingRecord, Inspection};
use osim_library::run::JsonRecord;
use osim_model::messages::Verb;
use osim_planning::DesignSheet;
use osim_requests::schema_of;
use osim_view::report::explain::TopicRecord;
use osim_view::report::json::{FailureRecord, PlanRecord};
use osim_view::report::reproduce::ReproductionRecord;
use osim_view::report::results::{DropRecord, FitRecord, MotionRecord, PresetRecord, SweepRecord};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::Value;

/// Most letters in a line of a schema that can be broken.
const LINE_WIDTH: usize = 140;

/// Every schema by its path below `schemas/`.
fn schemas() -> BTreeMap<String, String> {
    let requests = Verb::ALL.iter().map(|&verb| {
        let title = format!("A request: {}", verb.name());
        (format!("requests/{}", verb.name()), with_title(schema_of(verb), &title))
    });
    let others = [
        ("failure", schema_of_output::<FailureRecord>("A model that failed, on standard output of any verb")),
        ("finding", schema_of_output::<FindingRecord>("One finding: of a model, of a check, of a change")),
        (
            "results/change",
            schema_of_output::<PlanRecord>("The result of rescale, transfer, design, set and batch"),
        ),
        ("results/check", schema_of_output::<CheckResult>("The result of check")),
        ("results/design", schema_of_output::<DesignSheet>("The result of design without a model")),
        ("results/drop-test", schema_of_output::<DropRecord>("The result of drop-test")),
        ("results/explanation", schema_of_output::<TopicRecord>("The result of explain")),
        ("results/fit", schema_of_output::<FitRecord>("The result of fit")),
        ("results/inspection", schema_of_output::<Inspection>("The result of inspect")),
        ("results/motion", schema_of_output::<MotionRecord>("The result of motion")),
        ("results/preset", schema_of_output::<PresetRecord>("The result of presets")),
        ("results/reproduction", schema_of_output::<ReproductionRecord>("The result of reproduce")),
        ("results/summary-line", schema_of_output::<JsonRecord>("A line of a summary (NDJSON)")),
        ("results/sweep", schema_of_output::<SweepRecord>("The result of sweep")),
    ];
    let others = others.into_iter().map(|(name, schema)| (name.to_owned(), schema));
    requests
        .chain(others)
        .map(|(name, schema)| {
            let text = json_text(&serde_json::to_value(schema).unwrap(), 0, LINE_WIDTH);
            (format!("{name}.schema.json"), format!("{text}\n"))
        })
        .collect()
}

/// A value as JSON: on one line if it fits into `room`, else one line for each of its parts.
fn json_text(value: &Value, indent: usize, room: usize) -> String {
    let (ends, parts): (_, Vec<(String, &Value)>) = match value {
        Value::Object(fields) => {
            let with_name = |(name, part)| (format!("{}: ", Value::from(name)), part);
            ("{}", fields.iter().map(|(name, part)| (name.as_str(), part)).map(with_name).collect())
        }
        Value::Array(items) => ("[]", items.iter().map(|item| (String::new(), item)).collect()),
        simple => return simple.to_string(),
    };
    let (begin, end) = ends.split_at(1);
    let joined = |between: &str, written: &dyn Fn(&str, &Value) -> String| {
        parts.iter().map(|(name, part)| written(name, part)).collect::<Vec<_>>().join(between)
    };
    let line = joined(", ", &|name, part| format!("{name}{}", json_text(part, 0, usize::MAX)));
    if line.len() + 2 <= room {
        return format!("{begin}{line}{end}");
    }
    let inner = indent + 2;
    let lines = joined(",\n", &|name, part| {
        let room = LINE_WIDTH.saturating_sub(inner + name.len() + 1);
        format!("{:inner$}{name}{}", "", json_text(part, inner, room))
    });
    format!("{begin}\n{lines}\n{:indent$}{end}", "")
}

/// The schema of the JSON that the program prints for a value of type `T`.
fn schema_of_output<T: JsonSchema>(title: &str) -> Schema {
    let generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    with_title(generator.into_root_schema_for::<T>(), title)
}

fn with_title(mut schema: Schema, title: &str) -> Schema {
    schema.insert("title".to_owned(), Value::from(title));
    schema
}

fn schemas_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../schemas")
}

fn schema_names(folder: &Path, prefix: &str) -> Vec<String> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            names.extend(schema_names(&entry.path(), &format!("{name}/")));
        } else if name.ends_with(".json") {
            names.push(name);
        }
    }
    names.sort();
    names
}

#[test]
fn schemas_are_up_to_date() {
    let (schemas, folder) = (schemas(), schemas_folder());
    if std::env::var_os("UPDATE_SCHEMAS").is_some() {
        for (name, text) in &schemas {
            std::fs::create_dir_all(folder.join(name).parent().unwrap()).unwrap();
            std::fs::write(folder.join(name), text).unwrap();
        }
    }
    for (name, text) in &schemas {
        let committed = std::fs::read_to_string(folder.join(name)).unwrap_or_default();
        assert!(
            committed == *text,
            "schemas/{name} is out of date: UPDATE_SCHEMAS=1 cargo test --test schemas"
        );
    }
    assert_eq!(schema_names(&folder, ""), schemas.into_keys().collect::<Vec<_>>());
}

/// In the schemas of results every object is closed (no unknown fields), and every field has a description.
#[test]
fn results_are_closed_and_described() {
    for (name, text) in schemas() {
        let schema: Value = serde_json::from_str(&text).unwrap();
        jsonschema::meta::validate(&schema).unwrap_or_else(|error| panic!("{name}: {error}"));
        walk(&schema, &mut |object| {
            let Some(Value::Object(properties)) = object.get("properties") else { return };
            // Parts of `allOf` and `anyOf` speak of fields that are described elsewhere.
            if object.get("type").is_none() {
                return;
            }
            let closing_rules = ["additionalProperties", "unevaluatedProperties"];
            assert!(
                closing_rules.iter().any(|rule| object.get(rule) == Some(&Value::Bool(false))),
                "{name}: {object}"
            );
            for (field, schema) in properties {
                let is_described =
                    ["description", "const", "$ref"].iter().any(|key| schema.get(key).is_some());
                assert!(is_described || field == "bytes", "{name}: {field} has no description");
            }
        });
    }
}

fn walk(value: &Value, visit: &mut impl FnMut(&Value)) {
    visit(value);
    match value {
        Value::Object(fields) => fields.values().for_each(|field| walk(field, visit)),
        Value::Array(items) => items.iter().for_each(|item| walk(item, visit)),
        _ => {}
    }
}
