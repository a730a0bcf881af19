//! The result of `inspect`: one struct for the table, JSON, CSV and `check`. Its serialised form is the JSON that
//! `docs/reference/json.md` describes.

use std::collections::BTreeMap;

use contact_scaling::DimensionlessContact;
use osim_model::compare::{BodyFactors, SpherePlacements};
use osim_model::messages::{Dialect, Phrase};
use osim_model::{
    Body, DVec3, Finding, Limb, Mass, MassSource, Model, Property, Sphere, SphereId, TextPosition,
    ValueOrigin,
};
use serde::Serialize;

#[cfg(feature = "schemas")]
use crate::serialized::FindingRecord;
use crate::serialized::{json_records, line_alone, optional_phrase, records};
use crate::{Figures, KnownContacts, NoteSummary, ReferenceContacts, SizeList, StandingBody};

/// Everything that `inspect` shows of a model.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct Inspection {
    /// Version of this JSON, which rises when a field changes its meaning or goes away.
    pub schema_version: u32,
    /// Name of the model's file, as the caller gave it.
    pub model: String,
    /// The bytes of that name, if it is not UTF-8.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model_bytes: Option<Vec<u8>>,
    /// `Version` of the document, for example 40000.
    pub document_version: u32,
    /// The name that the model has in its file.
    pub name: String,
    /// Mass of the model, kg.
    pub mass_kg: Option<f64>,
    /// Source of the mass, in words.
    #[serde(skip)]
    pub mass_source: Phrase,
    /// Magnitude of gravity, m/s².
    pub gravity_m_s2: Option<f64>,
    /// The mass that the contacts are made for.
    pub contacts_mass_kg: Option<ContactsMass>,
    /// Content of the model's note, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<NoteSummary>,
    /// The limbs, if left and right can be determined.
    pub limbs: Option<Vec<InspectedLimb>>,
    /// Limbs that share the body weight.
    pub stance_limbs: f64,
    /// What carries the body in the figures, in words.
    #[serde(skip)]
    pub carriers: String,
    /// Number of spheres of each limb, if all have equally many.
    pub spheres_per_limb: Option<usize>,
    /// Why the limbs, or one number of spheres for all limbs, are not known, in words.
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
    pub findings: Vec<Finding>,
    /// Bodies without ground, in file order.
    pub bodies: Vec<InspectedBody>,
    /// Factors against the generic model, if one is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_factors: Option<Vec<InspectedFactors>>,
    /// The published contacts that the model has, if its contacts are recognised.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub known_contacts: Option<KnownContacts>,
    /// The places of its spheres compared with those of the model that was scaled, if `check` was given one.
    #[serde(skip)]
    pub placement: Option<SpherePlacements>,
    /// The contacts of the model that was scaled, if `check` was given one.
    #[serde(skip)]
    pub reference_contacts: Option<ReferenceContacts>,
    /// What else would follow the size of the body, if another mass was asked about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub similarity: Option<SizeList>,
    /// What the contacts do under the weight.
    pub figures: Figures,
    /// Component paths of the spheres under heels.
    #[serde(skip)]
    pub heel_spheres: Vec<String>,
    /// Each joint tree with spheres over a floor: how high it is at the default pose, and the coordinate with which it stands.
    pub standing: Vec<StandingBody>,
    /// Why `standing` is not known, in words: the default pose of a body is not known.
    pub why_no_standing: Option<String>,
}

json_records! {
    /// The mass that the contacts are made for.
    ContactsMass from mass: &Mass {
        /// The mass in kg.
        value: f64 = mass.kg,
        /// Source of the mass, as a word for scripts.
        source: &'static str = mass.source.as_str(),
        /// Source of the mass, for people.
        #[serde(skip)]
        description: Phrase = mass.source.describe(),
        #[serde(skip)]
        from: MassSource = mass.source.clone(),
    }
}

impl ContactsMass {
    /// The mass, written as `kg`, in words: `62 kg (note in the file)`, or `not recorded (the body weighs 20 kg)`.
    pub fn in_words(&self, kg: &str) -> String {
        if self.from.is_about_contacts() {
            format!("{kg} kg ({})", self.description)
        } else {
            format!("not recorded (the body weighs {kg} kg)")
        }
    }
}

json_records! {
    /// A limb that stands on the ground.
    InspectedLimb from (model, limb): (&Model, &Limb) {
        /// First body below the place where left and right split.
        name: String = limb.name.clone(),
        /// Side of the limb, `right` or `left`.
        side: &'static str = limb.side.as_str(),
        /// Names of the spheres of the limb.
        spheres: Vec<String> = names_of_spheres(model, &limb.spheres),
    }

    /// A contact sphere of an inspected model.
    InspectedSphere from (model, sphere, limb): (&Model, &Sphere, Option<&str>) {
        /// Name of the sphere.
        name: String = sphere.name.clone(),
        /// Component path of the sphere.
        path: String = sphere.path.clone(),
        /// Radius of the sphere in m; NaN if the file has that, or for an ellipsoid, null in JSON.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        radius_m: f64 = if sphere.radii_m.is_none() { sphere.radius.number } else { f64::NAN },
        /// The three radii of an ellipsoid in m.
        #[serde(skip_serializing_if = "Option::is_none")]
        radii_m: Option<[f64; 3]> = sphere.radii_m,
        /// Centre of the sphere in the frame that carries it, m; NaN if the file has that, null in JSON.
        #[cfg_attr(feature = "schemas", schemars(with = "[Option<f64>; 3]"))]
        location_m: [f64; 3] = sphere.location_m,
        /// Component path of the frame that carries the sphere.
        frame: String = sphere.frame.clone(),
        /// The body that the frame belongs to, if there is one.
        body: Option<String> = sphere.body.clone(),
        /// Line of the element, from 1.
        #[serde(rename = "line", serialize_with = "line_alone")]
        #[cfg_attr(feature = "schemas", schemars(rename = "line", with = "usize"))]
        position: TextPosition = sphere.position,
        /// Limb to which the sphere belongs.
        limb: Option<String> = limb.map(str::to_owned),
        /// Lowest point in the body's frame, m, with the body's axes as they are at the default pose.
        lowest_point_m: Option<[f64; 3]> = model.lowest_point_m(sphere.id).map(DVec3::into),
    }
}

pub(super) fn names_of_spheres(model: &Model, spheres: &[SphereId]) -> Vec<String> {
    spheres.iter().filter_map(|&id| Some(model.sphere(id)?.name.clone())).collect()
}

/// A contact force of an inspected model, or one parameter set of it.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct InspectedForce {
    /// Name of the force.
    pub name: String,
    /// Component path of the force.
    pub path: String,
    /// OpenSim's class of the force.
    #[serde(rename = "type")]
    pub kind: &'static str,
    /// Number of the `ContactParameters`, if the force has several.
    pub set: Option<usize>,
    /// Names of the spheres of the force.
    pub spheres: Vec<String>,
    /// Whether OpenSim computes this force.
    pub applies: bool,
    /// Whether a change of the model would change this force.
    pub selected: bool,
    /// Effective values, in OpenSim's units.
    #[cfg_attr(feature = "schemas", schemars(with = "BTreeMap<String, Option<f64>>"))]
    pub parameters: BTreeMap<&'static str, f64>,
    /// Sources of the parameters.
    pub origin: BTreeMap<&'static str, &'static str>,
    /// The dimensionless contact, for the mass and gravity that it is made for on n spheres; several radii count with the mean R². Null
    /// if mass, limbs or gravity are not known, or one of its numbers is more than a double holds.
    pub dimensionless: Option<Dimensionless>,
    /// Line of the element, from 1.
    #[serde(rename = "line", serialize_with = "line_alone")]
    #[cfg_attr(feature = "schemas", schemars(rename = "line", with = "usize"))]
    pub position: TextPosition,
    /// E* with a plane of the same material (A.4), N/m²; if the force has several materials, with these (A.3).
    pub composite_modulus_n_m2: Option<f64>,
}

impl InspectedForce {
    /// The effective value of the property, in OpenSim's unit.
    pub fn parameter(&self, property: Property) -> Option<f64> {
        self.parameters.get(property.as_str()).copied()
    }

    /// Whether the number is a default, and not in the force's own element.
    pub fn is_default(&self, property: Property) -> bool {
        self.origin.get(property.as_str()).is_some_and(|origin| *origin != ValueOrigin::Element.as_str())
    }
}

json_records! {
    /// A contact as dimensionless numbers, in which contacts of different sizes can be compared.
    Dimensionless from contact: &DimensionlessContact {
        /// E* R² n / (M g).
        modulus: f64 = contact.modulus(),
        /// x̂ of the sphere under its share of the body weight, by the Hertz law (11).
        relative_indentation: f64 = contact.relative_indentation(),
        /// Dimensionless dissipation α √(g R).
        dissipation: f64 = contact.dissipation(),
        /// √cf / R (C.2).
        constant_indentation: Option<f64> = contact.constant_indentation(),
        /// Dimensionless Hertz smoothing bd R.
        hertz_smoothing: Option<f64> = contact.hertz_smoothing(),
        /// Dimensionless Hunt–Crossley smoothing bv √(g R).
        hunt_crossley_smoothing: Option<f64> = contact.hunt_crossley_smoothing(),
    }

    /// A body of an inspected model.
    InspectedBody from body: &Body {
        /// Name of the body.
        name: String = body.name.clone(),
        /// Component path of the body.
        path: String = body.path.clone(),
        /// Mass of the body in kg; NaN if the file has that, null in JSON.
        #[cfg_attr(feature = "schemas", schemars(with = "Option<f64>"))]
        mass_kg: f64 = body.mass.number,
    }

    /// The factors by which a body was scaled.
    InspectedFactors from body: &BodyFactors {
        /// Name of the body.
        body: String = body.body.clone(),
        /// Along x, y and z; `None` if no source gives the factor.
        factors: [Option<f64>; 3] = body.axes.map(|axis| axis.map(|axis| axis.factor)),
        /// The source of each of these factors.
        sources: [Option<&'static str>; 3] = body.axes.map(|axis| axis.map(|axis| axis.source.as_str())),
        /// The factors that each source gives, by the source's name.
        by_source: BTreeMap<&'static str, [Option<f64>; 3]> =
            body.sources.iter().map(|(name, factors)| (name.as_str(), *factors)).collect(),
    }
}

impl Dimensionless {
    /// The dimensionless numbers of `contact`; `None` if one of them is larger than a double can hold.
    pub(super) fn of(contact: &DimensionlessContact) -> Option<Self> {
        let numbers = Self::from(contact);
        let required = [numbers.modulus, numbers.relative_indentation, numbers.dissipation].into_iter();
        let smoothing =
            [numbers.constant_indentation, numbers.hertz_smoothing, numbers.hunt_crossley_smoothing];
        let is_finite = required.chain(smoothing.into_iter().flatten()).all(f64::is_finite);
        is_finite.then_some(numbers)
    }
}

impl Inspection {
    /// Writes all texts of the inspection in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        self.mass_source.spell(dialect);
        self.contacts_mass_kg.iter_mut().for_each(|mass| mass.description.spell(dialect));
        self.findings.iter_mut().for_each(|finding| finding.spell(dialect));
        self.limbs_unknown.iter_mut().for_each(|why| why.spell(dialect));
        self.figures.spell(dialect);
    }
}
