//! Parts that all JSON results have in common: the version of their schemas, and how findings and phrases are serialised.

use osim_model::messages::Phrase;
use osim_model::{Finding, TextPosition};
use serde::{Serialize, Serializer};
#[cfg(feature = "schemas")]
use serde_json::{Map, Value};

use crate::findings::FindingWithRemedy;

/// Version of the JSON schemas. It is raised when a field of any result changes its meaning or is removed.
pub const SCHEMA_VERSION: u32 = 1;

/// Records of JSON, each made from one value: after the type of a field is the expression that gives it.
#[macro_export]
macro_rules! json_records {
    ($($(#[$about:meta])* $name:ident from $source:tt: $type_of_source:ty {
        $($(#[$about_field:meta])* $field:ident: $type:ty = $value:expr,)*
    })*) => {$(
        $(#[$about])*
        #[derive(Debug, Clone, PartialEq, serde::Serialize)]
        #[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
        pub struct $name {
            $($(#[$about_field])* pub $field: $type,)*
        }

        impl From<$type_of_source> for $name {
            fn from($source: $type_of_source) -> Self {
                Self { $($field: $value,)* }
            }
        }
    )*};
}
pub(crate) use crate::json_records;

json_records! {
    /// A finding in JSON.
    FindingRecord from finding: &Finding {
        /// The finding's code, a short name that does not change.
        code: &'static str = finding.code().as_str(),
        /// Severity of the finding: `error`, `warning` or `remark`.
        severity: &'static str = finding.severity.as_str(),
        /// Message of the finding, in words.
        message: String = finding.message.to_string(),
        /// Why the finding matters, the same for every case.
        why: String = finding.why.to_string(),
        /// Advice about the finding, the same for every case.
        advice: String = finding.advice.to_string(),
        /// Component path of the force or sphere that the finding is about; of several the worst.
        place: Option<String> = finding.place.clone(),
        /// Component paths of all elements that the finding is about, `place` first, as far as they are known.
        places: Vec<String> = finding.paths().cloned().collect(),
        /// Names of all spheres that the finding is about.
        spheres: Vec<String> = finding.spheres.clone(),
        /// Line in the model's file, from 1.
        line: Option<usize> = finding.position.map(|at| at.line),
        /// Column in its line, in letters, from 1.
        column: Option<usize> = finding.position.map(|at| at.column),
        /// A sentence for each element that the finding is about, if there is more to say than its name.
        details: Vec<String> = finding.details.clone(),
        /// The call that corrects the fault, if `check` can propose one.
        command: Option<String> = None,
        /// Of the result of a change: the model before it, or the reference, has this finding, too.
        had_before: bool = finding.had_before,
        /// The known contacts were published with the finding.
        as_published: bool = finding.is_as_published(),
    }
}

impl From<&FindingWithRemedy> for FindingRecord {
    fn from(found: &FindingWithRemedy) -> Self {
        Self { command: found.command.clone(), ..Self::from(&found.finding) }
    }
}

pub(crate) fn records<'f, T, S: Serializer>(findings: &'f [T], serializer: S) -> Result<S::Ok, S::Error>
where
    FindingRecord: From<&'f T>,
{
    serializer.collect_seq(findings.iter().map(FindingRecord::from))
}

pub(crate) fn line_alone<S: Serializer>(position: &TextPosition, serializer: S) -> Result<S::Ok, S::Error> {
    position.line.serialize(serializer)
}

pub(crate) fn optional_phrase<S: Serializer>(
    phrase: &Option<Phrase>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    phrase.as_ref().map(ToString::to_string).serialize(serializer)
}

/// The schema of an object whose fields come from a register. It allows no other fields and describes each field.
#[cfg(feature = "schemas")]
pub struct ObjectSchema<'g> {
    generator: &'g mut schemars::SchemaGenerator,
    properties: Map<String, Value>,
    required: Vec<String>,
}

#[cfg(feature = "schemas")]
impl<'g> ObjectSchema<'g> {
    pub fn new(generator: &'g mut schemars::SchemaGenerator) -> Self {
        Self { generator, properties: Map::new(), required: Vec::new() }
    }

    pub fn field<T: schemars::JsonSchema>(&mut self, name: &str, description: &str) {
        self.required.push(name.to_owned());
        self.field_or_none::<T>(name, description);
    }

    /// Adds a field that may be absent.
    pub fn field_or_none<T: schemars::JsonSchema>(&mut self, name: &str, description: &str) {
        let mut schema = self.generator.subschema_for::<T>();
        schema.insert("description".to_owned(), description.into());
        self.properties.insert(name.to_owned(), schema.to_value());
    }

    pub fn finish(self, description: &str) -> schemars::Schema {
        schemars::json_schema!({
            "description": description,
            "type": "object",
            "required": self.required,
            "properties": self.properties,
            "additionalProperties": false,
        })
    }
}
