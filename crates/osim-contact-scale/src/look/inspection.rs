//! What `inspect` knows of a model, apart from its bytes: one struct for the table, JSON, CSV and `check`.
//!
//! Serialised it is the JSON contract; `docs/json.md` describes every field.

use contact_scaling::DimensionlessContact;
use osim_patch::{BodyFactors, Factors, Force, Limbs, Mass, Model, Origin, Property, Selected, Warning};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::figures::{Figures, composite_of};

/// Raised when a field changes its meaning or goes away.
const SCHEMA_VERSION: u32 = 1;

/// A model as it was found.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Inspection {
    pub schema_version: u32,
    /// The model as it was named.
    pub model: String,
    pub document_version: u32,
    /// The model's own name.
    pub name: String,
    /// What the model weighs, kg.
    pub mass_kg: Option<f64>,
    /// Who said so, in words.
    #[serde(skip)]
    pub mass_told_by: String,
    /// Magnitude of gravity, m/s².
    pub gravity_m_s2: Option<f64>,
    /// What the contacts stand for.
    pub contacts_mass_kg: Option<ContactsMass>,
    pub limbs: Option<Vec<LimbSeen>>,
    pub spheres_per_limb: Option<usize>,
    /// Why the limbs, or one number of spheres, are not known, in words.
    pub limbs_unknown: Option<String>,
    pub spheres: Vec<SphereSeen>,
    pub forces: Vec<ForceSeen>,
    #[serde(serialize_with = "warnings")]
    pub warnings: Vec<Warning>,
    pub bodies: Vec<BodySeen>,
    /// Factors against the generic model, where one was named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_factors: Option<Vec<FactorsSeen>>,
    pub figures: Figures,
}

/// What the contacts stand for.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct ContactsMass {
    /// In kg.
    pub value: f64,
    /// Who said so, as a word for scripts.
    pub source: &'static str,
    /// Who said so, for people.
    #[serde(skip)]
    pub told_by: String,
}

/// A limb that stands on the ground.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct LimbSeen {
    pub name: String,
    pub side: &'static str,
    /// Names of its spheres.
    pub spheres: Vec<String>,
}

/// A contact sphere.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct SphereSeen {
    pub name: String,
    pub path: String,
    /// In m; NaN where the file says so.
    pub radius_m: f64,
    /// Centre in its frame, m.
    pub location_m: [f64; 3],
    pub frame: String,
    pub body: Option<String>,
    pub line: usize,
    /// Limb it belongs to.
    pub limb: Option<String>,
    /// Lowest point in the body's frame, m, with the body's axes as they stand.
    pub lowest_point_m: Option<[f64; 3]>,
}

/// A contact force, or one parameter set of it.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct ForceSeen {
    pub name: String,
    pub path: String,
    #[serde(rename = "type")]
    pub kind: &'static str,
    pub set: Option<usize>,
    /// Names of its spheres.
    pub spheres: Vec<String>,
    pub applies: bool,
    /// Whether a change would take it.
    pub selected: bool,
    /// Effective values, in OpenSim's units.
    pub parameters: Parameters,
    /// Where each comes from.
    pub origin: Origins,
    /// The contact without dimensions, at the mass it stands for.
    pub dimensionless: Option<Dimensionless>,
    pub line: usize,
    /// E* with a plane of the same material (A.4), N/m²; with the materials of the force where it has several (A.3).
    pub composite_modulus_n_m2: Option<f64>,
}

/// Effective values by OpenSim's names, in OpenSim's order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Parameters(pub Vec<(Property, f64)>);

/// Origins by OpenSim's names.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Origins(pub Vec<(Property, Origin)>);

impl Parameters {
    pub(crate) fn get(&self, property: Property) -> Option<f64> {
        self.0.iter().find(|(known, _)| *known == property).map(|(_, value)| *value)
    }
}

impl Origins {
    /// `true` where the number is not in the object itself.
    pub(crate) fn is_default(&self, property: Property) -> bool {
        self.0.iter().any(|(known, origin)| *known == property && *origin != Origin::Element)
    }
}

/// A map in the order of its names, so that scripts see the same text in every version.
fn by_name<S: Serializer, T: Serialize>(
    values: impl Iterator<Item = (Property, T)>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let mut sorted: Vec<_> = values.map(|(property, value)| (property.name(), value)).collect();
    sorted.sort_by_key(|(name, _)| *name);
    let mut map = serializer.serialize_map(Some(sorted.len()))?;
    for (name, value) in sorted {
        map.serialize_entry(name, &value)?;
    }
    map.end()
}

impl Serialize for Parameters {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        by_name(self.0.iter().copied(), serializer)
    }
}

impl Serialize for Origins {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        by_name(self.0.iter().map(|(property, origin)| (*property, origin.as_str())), serializer)
    }
}

/// The form in which contacts of different sizes are compared.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Dimensionless {
    pub modulus: f64,
    pub relative_indentation: f64,
    pub dissipation: f64,
    pub constant_indentation: Option<f64>,
    pub hertz_smoothing: Option<f64>,
    pub hunt_crossley_smoothing: Option<f64>,
}

impl From<&DimensionlessContact> for Dimensionless {
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

/// Something to know, as the JSON has it.
#[derive(Serialize)]
struct WarningSeen<'w> {
    code: &'static str,
    message: &'w str,
    line: Option<usize>,
}

fn warnings<S: Serializer>(warnings: &[Warning], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(warnings.iter().map(|warning| WarningSeen {
        code: warning.code.as_str(),
        message: &warning.message,
        line: warning.line,
    }))
}

/// A body.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct BodySeen {
    pub name: String,
    pub path: String,
    /// In kg; NaN where the file says so.
    pub mass_kg: f64,
}

/// How a body was scaled.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct FactorsSeen {
    pub body: String,
    /// Along x, y, z; `None` where nothing says.
    pub factors: [Option<f64>; 3],
    pub sources: [Option<&'static str>; 3],
    /// What each source says, by its name.
    pub said: SourcesSaid,
}

/// Factors by the name of the source.
#[derive(Debug, Clone)]
pub(crate) struct SourcesSaid(pub Vec<(&'static str, [Option<f64>; 3])>);

impl Serialize for SourcesSaid {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut sorted = self.0.clone();
        sorted.sort_by_key(|(name, _)| *name);
        serializer.collect_map(sorted)
    }
}

/// What was worked out about a model, before it is told.
pub(super) struct Found<'f> {
    pub path: &'f str,
    pub mass: Option<&'f Mass>,
    pub contacts_mass: Option<&'f Mass>,
    pub selected: &'f Selected,
    pub limbs: &'f Limbs,
    pub warnings: &'f [Warning],
    /// For each force (and parameter set) its contact without dimensions, and E*.
    pub contacts: &'f [SetContact],
    pub factors: Option<&'f Factors>,
    pub figures: Figures,
}

/// The contact of one parameter set with the floor.
pub(super) struct SetContact {
    pub force: usize,
    pub set: usize,
    pub composite_modulus_n_m2: f64,
    /// `None` where mass, limbs or gravity are not known.
    pub dimensionless: Option<DimensionlessContact>,
}

impl Inspection {
    pub(super) fn new(model: &Model, found: Found<'_>) -> Self {
        Self {
            schema_version: SCHEMA_VERSION,
            model: found.path.to_owned(),
            document_version: model.document().version(),
            name: model.name.clone(),
            mass_kg: found.mass.map(|mass| mass.kg),
            mass_told_by: found.mass.map(|mass| mass.told_by.clone()).unwrap_or_default(),
            gravity_m_s2: model.gravity(),
            contacts_mass_kg: found.contacts_mass.map(|mass| ContactsMass {
                value: mass.kg,
                source: mass.source.as_str(),
                told_by: mass.told_by.clone(),
            }),
            limbs: found.limbs.known().map(|limbs| {
                let limb = |limb: &osim_patch::Limb| LimbSeen {
                    name: limb.name.clone(),
                    side: limb.side.as_str(),
                    spheres: names(model, &limb.spheres),
                };
                limbs.iter().map(limb).collect()
            }),
            spheres_per_limb: found.limbs.spheres_per_limb().ok(),
            limbs_unknown: found.limbs.spheres_per_limb().err(),
            spheres: spheres(model, found.limbs),
            forces: forces(model, &found),
            warnings: found.warnings.to_vec(),
            bodies: model
                .bodies()
                .iter()
                .map(|body| BodySeen {
                    name: body.name.clone(),
                    path: body.path.clone(),
                    mass_kg: body.mass.number,
                })
                .collect(),
            body_factors: found.factors.map(|factors| factors.bodies.iter().map(factors_seen).collect()),
            figures: found.figures,
        }
    }
}

fn names(model: &Model, spheres: &[usize]) -> Vec<String> {
    let named = spheres.iter().filter_map(|&index| model.spheres.get(index));
    named.map(|sphere| sphere.name.clone()).collect()
}

fn spheres(model: &Model, limbs: &Limbs) -> Vec<SphereSeen> {
    let limb_of = |index: usize| {
        let limb = limbs.known()?.iter().find(|limb| limb.spheres.contains(&index))?;
        Some(limb.name.clone())
    };
    let seen = model.spheres.iter().enumerate().map(|(index, sphere)| SphereSeen {
        name: sphere.name.clone(),
        path: sphere.path.clone(),
        radius_m: sphere.radius.number,
        location_m: sphere.location_m,
        frame: sphere.frame.clone(),
        body: sphere.body.clone(),
        line: sphere.line,
        limb: limb_of(index),
        lowest_point_m: model.lowest_point_m(index),
    });
    seen.collect()
}

fn forces(model: &Model, found: &Found<'_>) -> Vec<ForceSeen> {
    let mut seen = Vec::new();
    for (index, force) in model.forces.iter().enumerate() {
        for (number, set) in force.sets.iter().enumerate() {
            let contact =
                found.contacts.iter().find(|contact| (contact.force, contact.set) == (index, number));
            let parameters = parameters(force, number, |value| value.number);
            let alone = || {
                let stiffness = parameters.iter().find(|(property, _)| *property == Property::Stiffness)?.1;
                Some(composite_of(stiffness)).filter(|modulus| modulus.is_finite())
            };
            seen.push(ForceSeen {
                name: force.name.clone(),
                path: force.path.clone(),
                kind: force.kind.as_str(),
                set: set.index,
                spheres: names(model, &set.spheres),
                applies: force.applies,
                selected: found.selected.forces.contains(&index),
                composite_modulus_n_m2: contact.map(|contact| contact.composite_modulus_n_m2).or_else(alone),
                parameters: Parameters(parameters),
                origin: Origins(self::parameters(force, number, |value| value.origin)),
                dimensionless: contact.and_then(|contact| contact.dimensionless.as_ref()).map(Into::into),
                line: set.line,
            });
        }
    }
    seen
}

fn parameters<T>(force: &Force, set: usize, of: impl Fn(&osim_patch::Value) -> T) -> Vec<(Property, T)> {
    let named = Property::ALL.into_iter();
    named.filter_map(|property| Some((property, of(force.value(set, property)?)))).collect()
}

fn factors_seen(body: &BodyFactors) -> FactorsSeen {
    FactorsSeen {
        body: body.body.clone(),
        factors: body.axes.map(|axis| axis.map(|axis| axis.factor)),
        sources: body.axes.map(|axis| axis.map(|axis| axis.source.as_str())),
        said: SourcesSaid(body.said.iter().map(|(source, values)| (source.as_str(), *values)).collect()),
    }
}
