//! What `inspect` knows of a model, apart from its bytes: one struct for the table, JSON, CSV and `check`.
//!
//! Serialised it is the JSON contract; `docs/reference/json.md` describes every field.

#[cfg(feature = "schemas")]
use std::collections::BTreeMap;

use contact_scaling::DimensionlessContact;
use osim_model::compare::SpherePlacements;
use osim_model::messages::{Dialect, Phrase, readable};
use osim_model::{Finding, Mass, Origin, Property};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::figures::Figures;
use crate::inspection::note::NoteStory;
use crate::inspection::standing::StandingBody;
use crate::known_contacts::{KnownContacts, ReferenceContacts};
#[cfg(feature = "schemas")]
use crate::serialized::FindingRecord;
use crate::serialized::{optional_phrase, records};
use crate::similarity::SizeList;

/// A model as it was found.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct Inspection {
    /// Raised when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// The model as it was named.
    pub model: String,
    /// Its name in bytes, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// `Version` of the document, for example 40000.
    pub document_version: u32,
    /// The model's own name.
    pub name: String,
    /// What the model weighs, kg.
    pub mass_kg: Option<f64>,
    /// Who said so, in words.
    #[serde(skip)]
    pub mass_source: Phrase,
    /// Magnitude of gravity, m/s².
    pub gravity_m_s2: Option<f64>,
    /// The mass that the contacts are made for.
    pub contacts_mass_kg: Option<ContactsMass>,
    /// What the note in the model says, where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<NoteStory>,
    /// The limbs, where left and right can be determined.
    pub limbs: Option<Vec<InspectedLimb>>,
    /// Limbs that share the body weight.
    pub stance_limbs: f64,
    /// Spheres of each limb, where all have equally many.
    pub spheres_per_limb: Option<usize>,
    /// Why the limbs, or one number of spheres, are not known, in words.
    #[serde(serialize_with = "optional_phrase")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<String>"))]
    pub limbs_unknown: Option<Phrase>,
    /// Contact spheres, in file order.
    pub spheres: Vec<InspectedSphere>,
    /// Contact forces, in file order; one entry for each of their parameter sets.
    pub forces: Vec<InspectedForce>,
    /// Traps found while reading, and masses that disagree.
    #[serde(serialize_with = "records")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<FindingRecord>"))]
    pub warnings: Vec<Finding>,
    /// Bodies, in file order, ground left out.
    pub bodies: Vec<InspectedBody>,
    /// Factors against the generic model, where one was named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_factors: Option<Vec<InspectedFactors>>,
    /// Whose contacts they are, if it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub known_contacts: Option<KnownContacts>,
    /// Its spheres compared with those of the model that was scaled, where `check` was given one.
    #[serde(skip)]
    pub placement: Option<SpherePlacements>,
    /// The contacts of that model.
    #[serde(skip)]
    pub reference_contacts: Option<ReferenceContacts>,
    /// What else would follow its size, where another mass was asked about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub similarity: Option<SizeList>,
    /// What the contacts do under the weight.
    pub figures: Figures,
    /// Each joint tree with spheres over a floor: where it is over it at the default pose, and what puts it on its feet.
    pub standing: Vec<StandingBody>,
    /// Why that is not known, in words: the default pose of a body is not.
    pub why_no_standing: Option<String>,
}

/// The mass that the contacts are made for.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct ContactsMass {
    /// In kg.
    pub value: f64,
    /// Who said so, as a word for scripts.
    pub source: &'static str,
    /// Who said so, for people.
    #[serde(skip)]
    pub description: Phrase,
    /// Whether somebody said it of the contacts. Otherwise it is what the model weighs, which is taken because nothing else is
    /// known.
    #[serde(skip)]
    pub recorded: bool,
}

impl ContactsMass {
    /// The mass that contacts are made for, with its source as scripts and as people read it.
    pub fn new(mass: &Mass) -> Self {
        Self {
            value: mass.kg,
            source: mass.source.as_str(),
            description: mass.source.describe(),
            recorded: mass.source.is_about_contacts(),
        }
    }

    /// What is known of it, in words: `62 kg (note in the file)`, or `not recorded (the body weighs 20 kg)`.
    pub fn in_words(&self) -> String {
        let kg = readable(self.value);
        if self.recorded {
            format!("{kg} kg ({})", self.description)
        } else {
            format!("not recorded (the body weighs {kg} kg)")
        }
    }
}

/// A limb that stands on the ground.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct InspectedLimb {
    /// First body below the place where left and right split.
    pub name: String,
    /// `right` or `left`.
    pub side: &'static str,
    /// Names of its spheres.
    pub spheres: Vec<String>,
}

/// A contact sphere.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct InspectedSphere {
    /// Its name.
    pub name: String,
    /// Its component path.
    pub path: String,
    /// In m; NaN where the file says so, null in JSON.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub radius_m: f64,
    /// Centre in its frame, m; NaN where the file says so, null in JSON.
    #[cfg_attr(feature = "schemas", schemars(with = "[Option<f64>; 3]"))]
    pub location_m: [f64; 3],
    /// The frame it is attached to, as a component path.
    pub frame: String,
    /// The body that the frame belongs to, where there is one.
    pub body: Option<String>,
    /// Line of the element, from 1.
    pub line: usize,
    /// Limb it belongs to.
    pub limb: Option<String>,
    /// Lowest point in the body's frame, m, with the body's axes as they stand.
    pub lowest_point_m: Option<[f64; 3]>,
}

/// A contact force, or one parameter set of it.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct InspectedForce {
    /// Its name.
    pub name: String,
    /// Its component path.
    pub path: String,
    /// OpenSim's class.
    #[serde(rename = "type")]
    pub kind: &'static str,
    /// Number of the `ContactParameters`, where there are several.
    pub set: Option<usize>,
    /// Names of its spheres.
    pub spheres: Vec<String>,
    /// Whether OpenSim computes it.
    pub applies: bool,
    /// Whether a change would take it.
    pub selected: bool,
    /// Effective values, in OpenSim's units.
    pub parameters: Parameters,
    /// Where each comes from.
    pub origin: Origins,
    /// The contact without dimensions, at the mass and gravity it is made for on n spheres; of several radii it is that of the
    /// mean R². Null where mass, limbs or gravity are not known, or one of its numbers is more than a double holds.
    pub dimensionless: Option<Dimensionless>,
    /// Line of the element, from 1.
    pub line: usize,
    /// E* with a plane of the same material (A.4), N/m²; with the materials of the force where it has several (A.3).
    pub composite_modulus_n_m2: Option<f64>,
}

/// Effective values by OpenSim's names, in OpenSim's order.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(transparent))]
pub struct Parameters(
    #[cfg_attr(feature = "schemas", schemars(with = "BTreeMap<String, Option<f64>>"))] Vec<(Property, f64)>,
);

/// Origins by OpenSim's names.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(transparent))]
pub struct Origins(
    #[cfg_attr(feature = "schemas", schemars(with = "BTreeMap<String, String>"))] Vec<(Property, Origin)>,
);

impl Parameters {
    pub fn get(&self, property: Property) -> Option<f64> {
        self.0.iter().find(|(known, _)| *known == property).map(|(_, value)| *value)
    }
}

impl Origins {
    /// `true` where the number is not in the object itself.
    pub fn is_default(&self, property: Property) -> bool {
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
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct Dimensionless {
    /// E* R² n / (M g).
    pub modulus: f64,
    /// x̂ under its share of the body weight, by the Hertz law (11).
    pub relative_indentation: f64,
    /// α √(g R).
    pub dissipation: f64,
    /// √cf / R (C.2).
    pub constant_indentation: Option<f64>,
    /// bd R.
    pub hertz_smoothing: Option<f64>,
    /// bv √(g R).
    pub hunt_crossley_smoothing: Option<f64>,
}

impl Dimensionless {
    /// Those of `contact`; `None` if one of them is more than a double holds.
    pub(super) fn of(contact: &DimensionlessContact) -> Option<Self> {
        let smoothing =
            [contact.constant_indentation(), contact.hertz_smoothing(), contact.hunt_crossley_smoothing()];
        let [constant_indentation, hertz_smoothing, hunt_crossley_smoothing] = smoothing;
        let (modulus, relative_indentation) = (contact.modulus(), contact.relative_indentation());
        let dissipation = contact.dissipation();
        let own = [modulus, relative_indentation, dissipation].into_iter();
        own.chain(smoothing.into_iter().flatten()).all(f64::is_finite).then_some(Self {
            modulus,
            relative_indentation,
            dissipation,
            constant_indentation,
            hertz_smoothing,
            hunt_crossley_smoothing,
        })
    }
}

/// A body.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct InspectedBody {
    /// Its name.
    pub name: String,
    /// Its component path.
    pub path: String,
    /// In kg; NaN where the file says so, null in JSON.
    #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
    pub mass_kg: f64,
}

/// How a body was scaled.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct InspectedFactors {
    /// Name of the body.
    pub body: String,
    /// Along x, y, z; `None` where nothing says.
    pub factors: [Option<f64>; 3],
    /// Which source was taken, axis by axis.
    pub sources: [Option<&'static str>; 3],
    /// What each source says, by its name.
    pub by_source: FactorsBySource,
}

/// Factors by the name of the source.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(transparent))]
pub struct FactorsBySource(
    #[cfg_attr(feature = "schemas", schemars(with = "BTreeMap<String, [Option<f64>; 3]>"))]
    Vec<(&'static str, [Option<f64>; 3])>,
);

impl Serialize for FactorsBySource {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut sorted = self.0.clone();
        sorted.sort_by_key(|(name, _)| *name);
        serializer.collect_map(sorted)
    }
}

impl Parameters {
    pub(super) fn new(values: Vec<(Property, f64)>) -> Self {
        Self(values)
    }
}

impl Origins {
    pub(super) fn new(origins: Vec<(Property, Origin)>) -> Self {
        Self(origins)
    }
}

impl FactorsBySource {
    pub(super) fn new(sources: Vec<(&'static str, [Option<f64>; 3])>) -> Self {
        Self(sources)
    }
}

impl Inspection {
    /// Spells everything it says in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        self.mass_source.spell(dialect);
        self.contacts_mass_kg.iter_mut().for_each(|mass| mass.description.spell(dialect));
        self.warnings.iter_mut().for_each(|warning| warning.spell(dialect));
        self.limbs_unknown.iter_mut().for_each(|why| why.spell(dialect));
        self.figures.spell(dialect);
    }
}
