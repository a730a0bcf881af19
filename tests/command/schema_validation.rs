//! Compares every JSON that a test reads with `schemas/`.

use std::collections::HashMap;
use std::path::Path;
use std::sync::OnceLock;

use jsonschema::Validator;
use serde_json::Value;

use super::root;

const FAILURE_SCHEMA: &str = "failure";
const CHANGE_SCHEMA: &str = "results/change";
const INSPECTION_SCHEMA: &str = "results/inspection";
const SUMMARY_LINE_SCHEMA: &str = "results/summary-line";

/// The schemas of the JSON that each verb prints.
const CALLS_OF_SCHEMAS: [(&str, &[&str]); 15] = [
    ("rescale", &[CHANGE_SCHEMA]),
    ("transfer", &[CHANGE_SCHEMA]),
    ("design", &[CHANGE_SCHEMA, "results/design"]),
    ("set", &[CHANGE_SCHEMA]),
    ("batch", &[CHANGE_SCHEMA]),
    ("sweep", &["results/sweep"]),
    ("inspect", &[INSPECTION_SCHEMA]),
    ("check", &["results/check"]),
    ("drop-test", &["results/drop-test"]),
    ("motion", &["results/motion"]),
    ("plot", &[]),
    ("fit", &[CHANGE_SCHEMA, "results/fit"]),
    ("reproduce", &["results/reproduction"]),
    ("presets", &["results/preset"]),
    ("explain", &["results/explanation"]),
];

/// Validates the lines of standard output that are complete JSON objects. A stopped call may leave half a line.
#[track_caller]
pub(crate) fn validate_stdout(arguments: &str, stdout: &[u8]) {
    let verb =
        arguments.split_whitespace().find(|word| CALLS_OF_SCHEMAS.iter().any(|(verb, _)| verb == word));
    let all: Vec<&str> = CALLS_OF_SCHEMAS.iter().flat_map(|(_, schemas)| *schemas).copied().collect();
    let allowed: Vec<&str> = match verb {
        Some(verb) => CALLS_OF_SCHEMAS
            .iter()
            .filter(|(name, _)| *name == verb)
            .flat_map(|(_, schemas)| *schemas)
            .copied()
            .collect(),
        None if arguments.starts_with("request") => all,
        None => vec![CHANGE_SCHEMA, INSPECTION_SCHEMA],
    };
    // An object over several lines is an example in a text, and no result.
    for line in json_lines(stdout).filter(|line| line.ends_with(b"}")) {
        let value = parse_json(line);
        match value.get("error") {
            Some(_) => assert_matches_one_schema(&value, &[FAILURE_SCHEMA]),
            None => assert_matches_one_schema(&value, &allowed),
        }
    }
}

/// Validates a written file if it is a summary with lines of JSON.
#[track_caller]
pub(crate) fn validate_file(name: &str, bytes: &[u8]) {
    if name.ends_with(".ndjson") {
        json_lines(bytes)
            .for_each(|line| assert_matches_one_schema(&parse_json(line), &[SUMMARY_LINE_SCHEMA]));
    }
}

fn json_lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    let end = bytes.iter().rposition(|&byte| byte == b'\n').unwrap_or(0);
    bytes[..end].split(|&byte| byte == b'\n').filter(|line| line.starts_with(b"{\""))
}

#[track_caller]
fn parse_json(line: &[u8]) -> Value {
    serde_json::from_slice(line).unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(line)))
}

#[track_caller]
fn assert_matches_one_schema(value: &Value, schemas: &[&str]) {
    let fulfilled = schemas.iter().any(|name| schema_validator(name).is_valid(value));
    let why = || {
        let errors = |name: &&str| {
            let schemas = schema_validator(name).iter_errors(value);
            schemas.map(|error| format!("{name}{}: {error}", error.instance_path())).collect::<Vec<_>>()
        };
        schemas.iter().flat_map(errors).collect::<Vec<_>>().join("\n")
    };
    assert!(fulfilled, "{value}\nfulfils none of {schemas:?}:\n{}", why());
    assert_uniform_lists(value);
}

/// Asserts that all objects of an array have the same fields, because MATLAB turns them into one array of structures.
#[track_caller]
pub(crate) fn assert_uniform_lists(value: &Value) {
    match value {
        Value::Array(items) => {
            let mut fields =
                items.iter().filter_map(Value::as_object).map(|item| item.keys().collect::<Vec<_>>());
            let first = fields.next();
            fields.for_each(|fields| assert_eq!(Some(&fields), first.as_ref(), "{value}"));
            items.iter().for_each(assert_uniform_lists);
        }
        Value::Object(fields) => fields.values().for_each(assert_uniform_lists),
        _ => {}
    }
}

fn schema_validator(name: &str) -> &'static Validator {
    static ALL: OnceLock<HashMap<String, Validator>> = OnceLock::new();
    let all = ALL.get_or_init(|| {
        let names = CALLS_OF_SCHEMAS
            .iter()
            .flat_map(|(_, names)| *names)
            .copied()
            .chain([FAILURE_SCHEMA, SUMMARY_LINE_SCHEMA]);
        names
            .map(|name| (name.to_owned(), read_schema(&root().join(format!("schemas/{name}.schema.json")))))
            .collect()
    });
    &all[name]
}

fn read_schema(path: &Path) -> Validator {
    let schema =
        parse_json(&std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display())));
    jsonschema::validator_for(&schema).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
