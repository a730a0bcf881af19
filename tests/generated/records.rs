//! Makes tables of the records in the JSON of all verbs: a row with the names of the fields for each record in `schemas/`.

use std::path::Path;

use osim_inspect::Figure;
use serde_json::{Map, Value};

/// Parts of docs/reference/json.md, each with the schemas whose records it lists.
pub(crate) const PARTS_OF_JSON_PAGE: &[(&str, &[&str])] = &[
    ("records-shared", &["failure", "finding"]),
    ("records-inspect", &["results/inspection"]),
    ("records-check", &["results/check"]),
    ("records-change", &["results/change", "results/sweep"]),
    ("records-compute", &["results/design", "results/drop-test", "results/fit"]),
    ("records-motion", &["results/motion"]),
    ("records-look-up", &["results/preset", "results/explanation", "results/reproduction"]),
    ("records-summary", &["results/summary-line"]),
];

/// Records that are part of many other records, each with the name of the field that contains it.
const RECORDS_IN_MANY_RECORDS: &[(&str, &str)] =
    &[("FindingRecord", "finding"), ("ContactsMass", "mass"), ("Dimensionless", "dimensionless")];

/// Records that several results contain, each with the only result whose table lists it.
const RECORDS_LISTED_ONCE: &[(&str, &str)] = &[("SizeList", "results/inspection")];

/// A row for each record of these schemas.
pub(crate) fn table_of_records(schemas: &[&str]) -> String {
    let mut text = "|record|fields|\n|---|---|\n".to_owned();
    for name in schemas {
        let schema = read_schema(name);
        let shown_elsewhere =
            RECORDS_LISTED_ONCE.iter().filter(|(_, by)| by != name).map(|(record, _)| *record);
        let mut rows =
            Rows { definitions: &schema["$defs"], listed: shown_elsewhere.collect(), text: String::new() };
        for variant in alternatives_of_schema(&schema) {
            let title = name.rsplit('/').next().unwrap();
            let kind =
                variant["properties"]["kind"]["const"].as_str().map(|kind| format!(" of kind `{kind}`"));
            let kind = kind.unwrap_or_default();
            rows.add_record(&format!("[`{title}`](../../schemas/{name}.schema.json){kind}"), "", variant);
        }
        text.push_str(&rows.text);
    }
    text
}

fn read_schema(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../schemas/{name}.schema.json"));
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

/// The alternatives of a schema (`oneOf`), or the schema itself.
fn alternatives_of_schema(schema: &Value) -> Vec<&Value> {
    schema["oneOf"].as_array().map_or_else(|| vec![schema], |kinds| kinds.iter().collect())
}

struct Rows<'s> {
    definitions: &'s Value,
    listed: Vec<&'s str>,
    text: String,
}

impl<'s> Rows<'s> {
    /// The row of one record, then those of the records in it.
    fn add_record(&mut self, label: &str, path: &str, schema: &'s Value) {
        let fields = schema["properties"].as_object().unwrap();
        let listed = fields.iter().filter(|(name, _)| is_listed(name, fields));
        let mut inner = Vec::new();
        let names = listed.map(|(name, schema)| {
            let of_type = Type::of(schema);
            let record = of_type.record.filter(|record| self.definitions[record]["properties"].is_object());
            let shared = RECORDS_IN_MANY_RECORDS
                .iter()
                .find(|(record, _)| of_type.record.is_some_and(|of| of.starts_with(record)));
            if let (Some(record), None) = (record, shared) {
                inner.push((format!("{path}{name}{}", of_type.list), record));
            }
            let kind = match (shared, record) {
                (Some((_, name)), _) => format!(":{name}"),
                (None, Some(_)) if of_type.list.is_empty() => "{}".to_owned(),
                (None, Some(_)) => String::new(),
                (None, None) => of_type.kind_of_value(self.definitions, schema),
            };
            format!("`{name}{kind}{}{}`", of_type.list, if of_type.is_nullable { "?" } else { "" })
        });
        let names = names.collect::<Vec<_>>().join(", ");
        self.text.push_str(&format!("|{label}|{names}|\n"));
        for (path, name) in inner {
            if !self.listed.contains(&name) {
                self.listed.push(name);
                self.add_record(&format!("`{path}`"), &format!("{path}."), &self.definitions[name]);
            }
        }
    }
}

/// Whether a row lists the field. A row does not list fields of all records, of another table, or that repeat for each property.
fn is_listed(name: &str, fields: &Map<String, Value>) -> bool {
    let is_everywhere = ["schema_version", "model"].contains(&name) || name.ends_with("_bytes");
    let is_figure =
        fields.contains_key("touching_share") && Figure::ALL.iter().any(|figure| figure.info().name == name);
    let of_property =
        ["_from", "_to", "_factor", "_from_m", "_to_m"].iter().find_map(|end| name.strip_suffix(end));
    !is_everywhere && !is_figure && of_property.is_none_or(|property| property == "stiffness")
}

/// The kind of value of a field.
struct Type<'s> {
    list: &'static str,
    is_nullable: bool,
    record: Option<&'s str>,
}

impl<'s> Type<'s> {
    fn of(schema: &'s Value) -> Self {
        let is_null = |schema: &Value| schema["type"] == "null";
        let kinds = |schema: &'s Value| {
            schema["anyOf"].as_array().map_or_else(Vec::new, |kinds| kinds.iter().collect())
        };
        let has_type = |kind: &str| {
            schema["type"] == kind
                || schema["type"].as_array().is_some_and(|kinds| kinds.iter().any(|one| one == kind))
        };
        let alternatives: Vec<&Value> = kinds(schema);
        let reference = |schema: &'s Value| schema["$ref"].as_str().and_then(|path| path.rsplit('/').next());
        Self {
            list: if has_type("array") { "[]" } else { "" },
            is_nullable: has_type("null") || alternatives.iter().any(|kind| is_null(kind)),
            record: reference(schema)
                .or_else(|| reference(&schema["items"]))
                .or_else(|| alternatives.into_iter().find_map(reference)),
        }
    }

    /// Name of the kind of value; empty for a number, because most values are numbers.
    fn kind_of_value(&self, definitions: &Value, schema: &Value) -> String {
        let value_schema = match self.record {
            Some(name) => &definitions[name],
            None if self.list.is_empty() => schema,
            None => &schema["items"],
        };
        let text = value_schema.to_string();
        let has_type = |kind: &str| {
            value_schema["type"] == kind
                || value_schema["type"].as_array().is_some_and(|kinds| kinds.iter().any(|one| one == kind))
        };
        if has_type("string")
            || value_schema["oneOf"][0]["type"] == "string"
            || value_schema.get("const").is_some()
        {
            ":text".to_owned()
        } else if has_type("boolean") {
            ":bool".to_owned()
        } else if has_type("object") {
            "{}".to_owned()
        } else {
            assert!(["number", "integer"].iter().any(|kind| text.contains(kind)), "{text}");
            String::new()
        }
    }
}
