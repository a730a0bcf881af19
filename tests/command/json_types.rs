//! Types for reading the program's JSON strictly, so that a new, missing or changed field fails a test.

use std::collections::BTreeMap;

use serde::Deserialize;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Plan {
    pub(crate) schema_version: u32,
    pub(crate) model: String,
    pub(crate) output: Option<String>,
    #[serde(default)]
    pub(crate) geometry_output: Option<String>,
    pub(crate) contacts_mass_kg: Option<Mass>,
    pub(crate) target_mass_kg: Option<f64>,
    pub(crate) objects: Vec<Object>,
    pub(crate) changes: Vec<Change>,
    pub(crate) findings: Vec<Finding>,
    pub(crate) remarks: Vec<String>,
    pub(crate) credits: Option<String>,
}

impl Plan {
    /// The mass that the contacts were made for, its source, and the mass that they are made for after the change.
    #[track_caller]
    pub(crate) fn masses(&self) -> (f64, &str, f64) {
        let before = self.contacts_mass_kg.as_ref().expect("the run tells its masses");
        (before.value, before.source.as_str(), self.target_mass_kg.expect("the run tells its masses"))
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Object {
    pub(crate) change: String,
    pub(crate) class: String,
    pub(crate) name: String,
    pub(crate) path: String,
    pub(crate) body: Option<String>,
    pub(crate) location_m: Option<[f64; 3]>,
    pub(crate) radius_m: Option<f64>,
    pub(crate) parameters: Option<BTreeMap<String, f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Change {
    pub(crate) force: Option<String>,
    pub(crate) path: String,
    pub(crate) set: Option<usize>,
    pub(crate) sphere: Option<String>,
    pub(crate) property: String,
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) factor: Option<f64>,
    pub(crate) equation: String,
    pub(crate) line: usize,
    pub(crate) inserted: bool,
}

/// One thing to know: of a model, of a change, and of a check.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Finding {
    pub(crate) code: String,
    pub(crate) severity: String,
    pub(crate) message: String,
    pub(crate) why: String,
    pub(crate) advice: String,
    pub(crate) place: Option<String>,
    pub(crate) places: Vec<String>,
    pub(crate) spheres: Vec<String>,
    pub(crate) line: Option<usize>,
    pub(crate) column: Option<usize>,
    pub(crate) details: Vec<String>,
    pub(crate) command: Option<String>,
    pub(crate) had_before: bool,
    pub(crate) as_published: bool,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Note {
    pub(crate) version: String,
    pub(crate) steps: Vec<Step>,
    pub(crate) stance_limbs: Option<f64>,
    pub(crate) weighed_kg: Option<f64>,
    pub(crate) changed_since: Vec<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Step {
    pub(crate) operation: String,
    pub(crate) options: String,
    pub(crate) from_mass_kg: Option<f64>,
    pub(crate) reference: Option<String>,
    pub(crate) reference_digest: Option<String>,
    pub(crate) date: Option<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Inspection {
    pub(crate) schema_version: u32,
    pub(crate) model: String,
    pub(crate) document_version: u32,
    pub(crate) name: String,
    pub(crate) mass_kg: Option<f64>,
    pub(crate) gravity_m_s2: Option<f64>,
    pub(crate) contacts_mass_kg: Option<Mass>,
    #[serde(default)]
    pub(crate) note: Option<Note>,
    #[serde(default)]
    pub(crate) known_contacts: Option<Known>,
    pub(crate) limbs: Option<Vec<Limb>>,
    pub(crate) limbs_unknown: Option<String>,
    pub(crate) stance_limbs: f64,
    pub(crate) spheres_per_limb: Option<usize>,
    pub(crate) spheres: Vec<Sphere>,
    pub(crate) forces: Vec<Force>,
    pub(crate) findings: Vec<Finding>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) figures: Figures,
    pub(crate) standing: Vec<Standing>,
    pub(crate) why_no_standing: Option<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Standing {
    pub(crate) body: String,
    pub(crate) mass_kg: Option<f64>,
    pub(crate) weight_n: Option<f64>,
    pub(crate) coordinate: Option<String>,
    pub(crate) joint: Option<String>,
    pub(crate) why_no_coordinate: Option<String>,
    pub(crate) default_m: Option<f64>,
    pub(crate) touching_m: Option<f64>,
    pub(crate) bottoms: Vec<Bottom>,
    pub(crate) as_posed: Option<BodyAtRest>,
    pub(crate) on_one_limb: Option<BodyAtRest>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Bottom {
    pub(crate) sphere: String,
    pub(crate) path: String,
    pub(crate) height_m: f64,
    pub(crate) radius_m: f64,
    pub(crate) tilt_rad: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BodyAtRest {
    pub(crate) limb: Option<String>,
    pub(crate) value_m: Option<f64>,
    pub(crate) down_m: f64,
    pub(crate) load_n: f64,
    pub(crate) carried: bool,
    pub(crate) spheres: Vec<StandingSphere>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StandingSphere {
    pub(crate) sphere: String,
    pub(crate) path: String,
    pub(crate) relative_indentation: f64,
    pub(crate) force_n: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Figures {
    pub(crate) mass_kg: Option<f64>,
    pub(crate) gravity_m_s2: Option<f64>,
    pub(crate) impact_speed_m_s: Option<f64>,
    pub(crate) why_no_body_weight: Option<String>,
    pub(crate) limbs: Vec<LimbFigures>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LimbFigures {
    pub(crate) limb: Option<String>,
    pub(crate) side: Option<String>,
    pub(crate) sphere_count: Option<f64>,
    pub(crate) spheres: Vec<SphereFigures>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SphereFigures {
    pub(crate) sphere: String,
    pub(crate) path: String,
    pub(crate) forces: Vec<String>,
    pub(crate) radius_m: f64,
    pub(crate) composite_modulus_n_m2: f64,
    pub(crate) load_n: Option<f64>,
    pub(crate) relative_indentation_hertz: Option<f64>,
    pub(crate) relative_indentation_model_law: Option<f64>,
    pub(crate) relative_indentation_hertz_level: Option<f64>,
    pub(crate) relative_indentation_model_law_level: Option<f64>,
    pub(crate) relative_indentation_hertz_standing: Option<f64>,
    pub(crate) relative_indentation_model_law_standing: Option<f64>,
    pub(crate) relative_indentation_hertz_at_two: Option<f64>,
    pub(crate) relative_indentation_model_law_at_two: Option<f64>,
    pub(crate) relative_indentation_hertz_level_at_two: Option<f64>,
    pub(crate) relative_indentation_model_law_level_at_two: Option<f64>,
    pub(crate) contact_stiffness_n_m: Option<f64>,
    pub(crate) dimensionless_stiffness: Option<f64>,
    pub(crate) natural_frequency_hz: Option<f64>,
    pub(crate) mean_contact_stress_n_m2: Option<f64>,
    pub(crate) dissipation_s_m: Option<f64>,
    pub(crate) restitution_exact: Option<f64>,
    pub(crate) restitution_approximate: Option<f64>,
    pub(crate) constant_indentation: Option<f64>,
    pub(crate) transition_width: Option<f64>,
    pub(crate) force_just_touching_n: Option<f64>,
    pub(crate) touching_share: Option<f64>,
    pub(crate) limits: Vec<LimitCheck>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LimitCheck {
    pub(crate) figure: String,
    pub(crate) value: Option<f64>,
    pub(crate) limit: f64,
    pub(crate) within_limit: bool,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Mass {
    pub(crate) value: f64,
    pub(crate) source: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Limb {
    pub(crate) name: String,
    pub(crate) side: String,
    pub(crate) spheres: Vec<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sphere {
    pub(crate) name: String,
    pub(crate) path: String,
    pub(crate) radius_m: Option<f64>,
    pub(crate) location_m: [f64; 3],
    pub(crate) frame: String,
    pub(crate) body: Option<String>,
    pub(crate) line: usize,
    pub(crate) limb: Option<String>,
    pub(crate) lowest_point_m: Option<[f64; 3]>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Force {
    pub(crate) name: String,
    pub(crate) path: String,
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) set: Option<usize>,
    pub(crate) spheres: Vec<String>,
    pub(crate) applies: bool,
    pub(crate) selected: bool,
    pub(crate) parameters: BTreeMap<String, Option<f64>>,
    pub(crate) origin: BTreeMap<String, String>,
    pub(crate) dimensionless: Option<BTreeMap<String, Option<f64>>>,
    pub(crate) line: usize,
    pub(crate) composite_modulus_n_m2: Option<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) path: String,
    pub(crate) mass_kg: Option<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Failure {
    pub(crate) schema_version: u32,
    pub(crate) model: String,
    pub(crate) error: Fault,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Fault {
    pub(crate) code: String,
    pub(crate) message: String,
    pub(crate) line: Option<usize>,
    pub(crate) column: Option<usize>,
}

/// Contacts that somebody published.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Known {
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) source: String,
    pub(crate) made_for_kg: f64,
}
