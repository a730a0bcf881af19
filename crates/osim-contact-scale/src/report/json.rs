//! The JSON contract: one object per model and line. `docs/json.md` describes every field.

use contact_scaling::DimensionlessContact;
use osim_patch::{BodyFactors, Change, Factors, Limbs, Mass, Model, Move, Plan, Property, Selected, Warning};
use serde::Serialize;
use serde_json::{Map, Value};

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

#[derive(Serialize)]
struct JsonInspect<'m> {
    schema_version: u32,
    model: &'m str,
    document_version: u32,
    name: &'m str,
    mass_kg: Option<f64>,
    gravity_m_s2: Option<f64>,
    contacts_mass_kg: Option<JsonMass>,
    limbs: Option<Vec<JsonLimb<'m>>>,
    spheres_per_limb: Option<usize>,
    limbs_unknown: Option<String>,
    spheres: Vec<JsonSphere<'m>>,
    forces: Vec<JsonForce<'m>>,
    warnings: Vec<JsonWarning<'m>>,
    bodies: Vec<JsonBody<'m>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    body_factors: Option<Vec<JsonFactors<'m>>>,
}

#[derive(Serialize)]
struct JsonFactors<'m> {
    body: &'m str,
    factors: [Option<f64>; 3],
    sources: [Option<&'static str>; 3],
    said: Map<String, Value>,
}

/// What the sources say of each body's scale.
fn factors(factors: &Factors) -> Vec<JsonFactors<'_>> {
    let of_body = |body: &'_ BodyFactors| {
        let said = body
            .said
            .iter()
            .map(|(source, values)| (source.as_str().to_owned(), Value::from(values.to_vec())));
        said.collect::<Map<String, Value>>()
    };
    factors
        .bodies
        .iter()
        .map(|body| JsonFactors {
            body: &body.body,
            factors: body.axes.map(|axis| axis.map(|axis| axis.factor)),
            sources: body.axes.map(|axis| axis.map(|axis| axis.source.as_str())),
            said: of_body(body),
        })
        .collect()
}

#[derive(Serialize)]
struct JsonMass {
    value: f64,
    source: &'static str,
}

#[derive(Serialize)]
struct JsonLimb<'m> {
    name: &'m str,
    side: &'static str,
    spheres: Vec<&'m str>,
}

#[derive(Serialize)]
struct JsonBody<'m> {
    name: &'m str,
    path: &'m str,
    mass_kg: f64,
}

#[derive(Serialize)]
struct JsonSphere<'m> {
    name: &'m str,
    path: &'m str,
    radius_m: f64,
    location_m: [f64; 3],
    frame: &'m str,
    body: Option<&'m str>,
    line: usize,
}

#[derive(Serialize)]
struct JsonForce<'m> {
    name: &'m str,
    path: &'m str,
    #[serde(rename = "type")]
    kind: &'static str,
    set: Option<usize>,
    spheres: Vec<&'m str>,
    applies: bool,
    selected: bool,
    parameters: Map<String, Value>,
    origin: Map<String, Value>,
    dimensionless: Option<JsonDimensionless>,
    line: usize,
}

/// The form in which contacts of different sizes are compared.
#[derive(Serialize)]
struct JsonDimensionless {
    modulus: f64,
    relative_indentation: f64,
    dissipation: f64,
    constant_indentation: Option<f64>,
    hertz_smoothing: Option<f64>,
    hunt_crossley_smoothing: Option<f64>,
}

impl From<&DimensionlessContact> for JsonDimensionless {
    fn from(contact: &DimensionlessContact) -> Self {
        Self {
            modulus: contact.modulus(),
            relative_indentation: contact.relative_indentation(),
            dissipation: contact.dissipation(),
            constant_indentation: contact.constant_indentation(),
            hertz_smoothing: contact.hertz_smoothing(),
            hunt_crossley_smoothing: contact.hunt_crossley_smoothing(),
        }
    }
}

/// Everything `inspect` knows.
pub(crate) struct Inspected<'i> {
    pub path: &'i str,
    pub model: &'i Model<'i, 'i>,
    pub mass: Option<&'i Mass>,
    pub contacts_mass: Option<&'i Mass>,
    pub selected: &'i Selected,
    pub limbs: &'i Limbs,
    pub warnings: &'i [Warning],
    /// For each force (and parameter set) its contact without dimensions, where mass, n and gravity are known.
    pub dimensionless: &'i [(usize, usize, DimensionlessContact)],
    /// Factors against the generic model, where one was named.
    pub factors: Option<&'i Factors>,
}

impl Inspected<'_> {
    pub(crate) fn dimensionless_of(&self, force: usize, set: usize) -> Option<&DimensionlessContact> {
        self.dimensionless.iter().find(|(f, s, _)| (*f, *s) == (force, set)).map(|(.., contact)| contact)
    }
}

/// What a model holds.
pub(crate) fn inspect(seen: &Inspected<'_>) -> String {
    let model = seen.model;
    let sphere_name = |&index: &usize| model.spheres.get(index).map_or("", |sphere| sphere.name.as_str());
    let limbs = seen.limbs.known().map(|limbs| {
        let names = |spheres: &[usize]| spheres.iter().map(sphere_name).collect();
        let limbs = limbs.iter().map(|limb| JsonLimb {
            name: &limb.name,
            side: limb.side.as_str(),
            spheres: names(&limb.spheres),
        });
        limbs.collect()
    });
    let spheres = model.spheres.iter().map(|sphere| JsonSphere {
        name: &sphere.name,
        path: &sphere.path,
        radius_m: sphere.radius.number,
        location_m: sphere.location_m,
        frame: &sphere.frame,
        body: sphere.body.as_deref(),
        line: sphere.line,
    });
    let forces = model.forces.iter().enumerate().flat_map(|(index, force)| {
        force.sets.iter().enumerate().map(move |(number, set)| JsonForce {
            name: &force.name,
            path: &force.path,
            kind: force.kind.as_str(),
            set: set.index,
            spheres: set.spheres.iter().map(sphere_name).collect(),
            applies: force.applies,
            selected: seen.selected.forces.contains(&index),
            parameters: parameters(force, number, |value| Value::from(value.number)),
            origin: parameters(force, number, |value| Value::from(value.origin.as_str())),
            dimensionless: seen.dimensionless_of(index, number).map(Into::into),
            line: set.line,
        })
    });
    line(&JsonInspect {
        schema_version: SCHEMA_VERSION,
        model: seen.path,
        document_version: model.document().version(),
        name: &model.name,
        mass_kg: seen.mass.map(|mass| mass.kg),
        gravity_m_s2: model.gravity(),
        contacts_mass_kg: seen
            .contacts_mass
            .map(|mass| JsonMass { value: mass.kg, source: mass.source.as_str() }),
        limbs,
        spheres_per_limb: seen.limbs.spheres_per_limb().ok(),
        limbs_unknown: seen.limbs.spheres_per_limb().err(),
        spheres: spheres.collect(),
        forces: forces.collect(),
        warnings: warnings(seen.warnings),
        bodies: model
            .bodies()
            .iter()
            .map(|body| JsonBody { name: &body.name, path: &body.path, mass_kg: body.mass.number })
            .collect(),
        body_factors: seen.factors.map(factors),
    })
}

fn parameters(
    force: &osim_patch::Force,
    set: usize,
    json: impl Fn(&osim_patch::Value) -> Value,
) -> Map<String, Value> {
    let named =
        Property::ALL.into_iter().filter_map(|property| Some((property, force.value(set, property)?)));
    named.map(|(property, value)| (property.name().to_owned(), json(value))).collect()
}
