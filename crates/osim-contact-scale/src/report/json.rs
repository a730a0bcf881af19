//! The JSON contract of a change: one object per model and line. `docs/json.md` describes every field.

use osim_patch::{Change, Move, Plan, Warning};
use serde::Serialize;

const SCHEMA_VERSION: u32 = 1;

/// One JSON object and a line end.
pub(crate) fn line(value: &impl Serialize) -> String {
    // Serialising owned strings, numbers and lists cannot fail; an empty line would be seen at once if it did.
    let mut text = serde_json::to_string(value).unwrap_or_default();
    text.push('\n');
    text
}

#[derive(Serialize)]
struct JsonWarning<'w> {
    code: &'static str,
    message: &'w str,
    line: Option<usize>,
}

fn warnings(warnings: &[Warning]) -> Vec<JsonWarning<'_>> {
    let json = |w: &'_ Warning| (w.code.as_str(), w.line);
    warnings
        .iter()
        .map(|warning| {
            let (code, line) = json(warning);
            JsonWarning { code, message: &warning.message, line }
        })
        .collect()
}

#[derive(Serialize)]
struct JsonPlan<'p> {
    schema_version: u32,
    model: &'p str,
    output: Option<&'p str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    geometry_output: Option<&'p str>,
    contacts_mass_kg: Option<JsonMasses>,
    changes: Vec<JsonChange<'p>>,
    warnings: Vec<JsonWarning<'p>>,
    notes: &'p [String],
}

#[derive(Serialize)]
struct JsonMasses {
    from: f64,
    source: &'static str,
    to: f64,
}

#[derive(Serialize)]
struct JsonChange<'p> {
    force: Option<&'p str>,
    path: &'p str,
    set: Option<usize>,
    sphere: Option<&'p str>,
    property: &'static str,
    from: Amount,
    to: Amount,
    factor: Option<f64>,
    equation: &'static str,
    line: usize,
    inserted: bool,
}

impl<'p> From<&'p Change> for JsonChange<'p> {
    fn from(change: &'p Change) -> Self {
        Self {
            force: change.force.as_deref(),
            path: &change.path,
            set: change.set,
            sphere: change.sphere.as_deref(),
            property: change.property.name(),
            from: Amount::Number(change.from),
            to: Amount::Number(change.to),
            factor: change.factor,
            equation: change.equation,
            line: change.line,
            inserted: change.inserted,
        }
    }
}

/// A number, or the three of a location.
#[derive(Serialize)]
#[serde(untagged)]
enum Amount {
    Number(f64),
    Place([f64; 3]),
}

impl<'p> From<&'p Move> for JsonChange<'p> {
    fn from(place: &'p Move) -> Self {
        Self {
            force: None,
            path: &place.path,
            set: None,
            sphere: Some(&place.sphere),
            property: "location",
            from: Amount::Place(place.from),
            to: Amount::Place(place.to),
            factor: None,
            equation: place.equation,
            line: place.line,
            inserted: place.inserted,
        }
    }
}

/// A plan, and where its result went.
pub(crate) fn plan(plan: &Plan, model: &str, output: Option<&str>, geometry_output: Option<&str>) -> String {
    line(&JsonPlan {
        schema_version: SCHEMA_VERSION,
        model,
        output,
        geometry_output,
        contacts_mass_kg: plan.masses.as_ref().map(|masses| JsonMasses {
            from: masses.from.kg,
            source: masses.from.source.as_str(),
            to: masses.to_kg,
        }),
        changes: plan
            .changes
            .iter()
            .map(JsonChange::from)
            .chain(plan.moves.iter().map(JsonChange::from))
            .collect(),
        warnings: warnings(&plan.warnings),
        notes: &plan.remarks,
    })
}
