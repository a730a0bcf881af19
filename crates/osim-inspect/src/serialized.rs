//! What all JSON results share: their version, and findings and phrases as they have them.

use osim_model::Finding;
use osim_model::messages::Phrase;
#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
#[cfg(feature = "schemas")]
use serde_json::{Map, Value};

use crate::findings::Found;

/// Raised when a field of any result changes its meaning or goes away.
pub const SCHEMA_VERSION: u32 = 1;

/// One finding, as every JSON has it: of a model, of a check, of a change.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct FindingRecord {
    /// Stable short name.
    pub code: &'static str,
    /// How bad it is: `error`, `warning` or `remark`.
    pub severity: &'static str,
    /// This case, in words.
    pub message: String,
    /// Why it matters, the same for every case.
    pub why: String,
    /// What to do about it, the same for every case.
    pub advice: String,
    /// Component path of the force or sphere, where it is one; of the worst where it is several.
    pub place: Option<String>,
    /// Names of all spheres concerned, where it is about spheres.
    pub spheres: Vec<String>,
    /// Line in the model, where there is one.
    pub line: Option<usize>,
    /// The call that puts it right, where `check` can propose one.
    pub command: Option<String>,
}

impl From<&Finding> for FindingRecord {
    fn from(finding: &Finding) -> Self {
        Self {
            code: finding.code().as_str(),
            severity: finding.severity.as_str(),
            message: finding.message.to_string(),
            why: finding.why.to_string(),
            advice: finding.advice.to_string(),
            place: finding.place.clone(),
            spheres: finding.spheres.clone(),
            line: finding.line,
            command: None,
        }
    }
}

impl From<&Found> for FindingRecord {
    fn from(found: &Found) -> Self {
        Self { command: found.command.clone(), ..Self::from(&found.finding) }
    }
}

/// Serialises findings as their records.
pub(crate) fn records<S: Serializer>(findings: &[Finding], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(findings.iter().map(FindingRecord::from))
}

/// Serialises what was found as records.
pub(crate) fn found_records<S: Serializer>(found: &[Found], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(found.iter().map(FindingRecord::from))
}

/// Serialises a phrase that may be absent as its text.
pub(crate) fn optional_phrase<S: Serializer>(
    phrase: &Option<Phrase>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    phrase.as_ref().map(ToString::to_string).serialize(serializer)
}

/// The schema of an object whose fields come from a register: closed, and each field described.
#[cfg(feature = "schemas")]
#[derive(Debug)]
pub struct ObjectSchema<'g> {
    generator: &'g mut SchemaGenerator,
    properties: Map<String, Value>,
    required: Vec<String>,
}

#[cfg(feature = "schemas")]
impl<'g> ObjectSchema<'g> {
    /// No field yet.
    pub fn new(generator: &'g mut SchemaGenerator) -> Self {
        Self { generator, properties: Map::new(), required: Vec::new() }
    }

    pub fn field<T: JsonSchema>(&mut self, name: &str, description: &str) {
        self.required.push(name.to_owned());
        self.field_or_none::<T>(name, description);
    }

    /// A field that may be left out.
    pub fn field_or_none<T: JsonSchema>(&mut self, name: &str, description: &str) {
        let mut schema = self.generator.subschema_for::<T>();
        schema.insert("description".to_owned(), description.into());
        self.properties.insert(name.to_owned(), schema.to_value());
    }

    /// The schema.
    pub fn finish(self, description: &str) -> Schema {
        json_schema!({
            "description": description,
            "type": "object",
            "required": self.required,
            "properties": self.properties,
            "additionalProperties": false,
        })
    }
}
